#!/usr/bin/env bash
# Runs build.sh without a container, as OSS-Fuzz would with libFuzzer and one of its sanitizers, and starts every target
# from its seeds. Needs clang, zip, unzip and patchelf.
#
#   fuzz/oss-fuzz/test.sh [address|undefined|none] [FOLDER]     default: address, out/oss-fuzz
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

sanitizer=${1:-address} folder=${2:-out/oss-fuzz}
case $sanitizer in
  address) flags="-fsanitize=address -fsanitize-address-use-after-scope" ;;
  undefined) flags="-fsanitize=undefined -fno-sanitize-recover=undefined" ;;
  none) flags= ;;
  *) echo "test.sh: no such sanitizer: $sanitizer" >&2; exit 2 ;;
esac
for tool in clang clang++ zip unzip patchelf; do
  command -v "$tool" >/dev/null || { echo "test.sh: $tool is missing" >&2; exit 2; }
done
mkdir -p "$folder/src" "$folder/work"
folder=$(cd "$folder" && pwd)
rm -rf "$folder/out" && mkdir "$folder/out"
ln -sfn "$PWD" "$folder/src/localgridseg"

export SRC=$folder/src OUT=$folder/out WORK=$folder/work CC=clang CXX=clang++ LIB_FUZZING_ENGINE=-fsanitize=fuzzer
export CFLAGS="-O1 -fno-omit-frame-pointer -gline-tables-only $flags -fsanitize=fuzzer-no-link" CXXFLAGS
CXXFLAGS="$CFLAGS -stdlib=libc++"
bash -eu fuzz/oss-fuzz/build.sh

for program in "$OUT"/fuzz_*; do
  [[ -x $program && $program != *.* ]] || continue
  seeds=$folder/work/seeds-${program##*/}
  rm -rf "$seeds" && mkdir "$seeds"
  unzip -q "${program}_seed_corpus.zip" -d "$seeds"
  options=()
  [[ -e $program.dict ]] && options+=("-dict=$program.dict")
  [[ -e $program.options ]] || { echo "test.sh: ${program##*/} has no options" >&2; exit 1; }
  # Not the corpus itself, which is many inputs: started, and a little further.
  (cd "$OUT" && "$program" -runs=2000 -max_total_time=20 -seed=1 "${options[@]}" "$seeds") >"$folder/work/log" 2>&1 ||
    { tail -n 30 "$folder/work/log"; exit 1; }
  printf '%-16s %s\n' "${program##*/}" "$(grep -E '^Done|cov:' "$folder/work/log" | tail -n 1)"
done
