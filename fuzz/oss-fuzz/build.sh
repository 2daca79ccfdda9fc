#!/bin/bash -eu
# Builds every target the way OSS-Fuzz and ClusterFuzzLite ask for: with CC, CXX, CFLAGS, CXXFLAGS and
# LIB_FUZZING_ENGINE as the environment has them, from $SRC/localgridseg into $OUT; beside each program its seeds,
# options and dictionary. fuzz/oss-fuzz/test.sh runs it without a container.

project=$SRC/localgridseg
build=${WORK:-$SRC}/build

# CXXFLAGS there ask for libc++, but the distribution's libraries, fmt among them, are built for libstdc++.
CXXFLAGS=${CXXFLAGS/-stdlib=libc++/}

# The flags bring sanitizers and coverage for all code, so the project adds none. CGAL's arrangement casts faces down to
# a class they are not of, which -fsanitize=vptr, part of `undefined`, would stop.
cmake -S "$project" -B "$build" -G Ninja \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" \
  -DCMAKE_CXX_FLAGS="$CXXFLAGS -fno-sanitize=vptr" -DCMAKE_BUILD_TYPE=None \
  -DLGS_BUILD_TESTS=OFF -DLGS_BUILD_FUZZERS=ON \
  -DLGS_FUZZ_COVERAGE= -DLGS_FUZZING_ENGINE="$LIB_FUZZING_ENGINE"

targets=$(cmake --build "$build" --target help | sed -n 's/^\(fuzz_[a-z0-9]*\): phony$/\1/p')
# shellcheck disable=SC2086
cmake --build "$build" --target $targets

mkdir -p "$OUT/lib"
for program in $targets; do
  target=${program#fuzz_}
  cp "$build/fuzz/$program" "$OUT/"
  seeds=$(mktemp -d)
  tar -xf "$project/fuzz/corpus/$target.tar" -C "$seeds"
  zip -q -j -r "$OUT/${program}_seed_corpus.zip" "$seeds"
  rm -r "$seeds"
  {
    echo "[libfuzzer]"
    echo "timeout = 60"
    if [ -e "$project/fuzz/dictionaries/$target.dict" ]; then
      cp "$project/fuzz/dictionaries/$target.dict" "$OUT/$program.dict"
      echo "dict = $program.dict"
      echo "max_len = 4096"  # texts, as in fuzz/run.sh
    else
      echo "max_len = 1024"
    fi
  } >"$OUT/$program.options"
  # The runners have no packages installed: shared libraries go along.
  ldd "$OUT/$program" | sed -n 's/.*=> \(\/[^ ]*lib\(stdc++\|gcc_s\|fmt\|pcre2-8\|pugixml\|gmp\|mpfr\|zstd\|z\|box2d\)\.[^ ]*\).*/\1/p' |
    xargs -r cp -n -t "$OUT/lib"
  patchelf --set-rpath '$ORIGIN/lib' "$OUT/$program"
done
