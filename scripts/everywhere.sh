#!/usr/bin/env bash
# The same edits give the same ids everywhere: builds proptests/platform for other machines, by other compilers and with
# other options, runs it there, and prints a table. docs/platforms.md has one.
#
#   scripts/everywhere.sh                 # all rows; installs what is missing from Debian 12 first
#   scripts/everywhere.sh --only NAME     # one row; may be given several times
#   scripts/everywhere.sh --no-install    # what is missing becomes a row that says so
#   scripts/everywhere.sh --strict        # with that, what is missing is a failure
#   scripts/everywhere.sh --list          # the names of the rows
#
# A row says: platform, compiler, options, the hash of all that the library gave out and whether it is the expected one,
# whether the amalgamation does the same, warnings in lib/, how many tests passed, and the seconds that the program took.
# "Tests" are lgs_platform, those of the C interface in C99, the example in C, those of the documents, and for the amalgamation
# lgs_platform and a game. Builds into build/everywhere/NAME, and logs there in log.txt.
# Exit status: 0: all alike; 1: a hash, a test or a build failed; 2: wrong usage.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# NAME | platform | compiler | options as the table says them | options of CMake, several with semicolons
rows='
gcc-12|Linux x86-64|g++-12|-O3|
clang-14|Linux x86-64|clang++-14|-O3|
clang-19|Linux x86-64|clang++-19|-O3|
libc++|Linux x86-64|clang++-19|-O3 -stdlib=libc++|FLAGS=-stdlib=libc++
i686|Linux i686|i686-linux-gnu-g++|-O3|
aarch64|Linux aarch64, qemu|aarch64-linux-gnu-g++|-O3|
s390x|Linux s390x, qemu|s390x-linux-gnu-g++|-O3|
windows|Windows x86-64, Wine|x86_64-w64-mingw32-g++-posix|-O3|
wasm|wasm32-wasi, Node|clang++-19|-O3 -fno-exceptions|FLAGS=-fno-exceptions
c++23|Linux x86-64|g++-12|-O3 -std=c++23|-DCMAKE_CXX_STANDARD=23
plain|Linux x86-64|g++-12|-O3 -fno-exceptions -fno-rtti|FLAGS=-fno-exceptions -fno-rtti
O0|Linux x86-64|g++-12|-O0, assertions|-DCMAKE_CXX_FLAGS_RELEASE=-O0
native|Linux x86-64|g++-12|-O3 -march=x86-64-v3 (FMA)|FLAGS=-march=x86-64-v3
lto|Linux x86-64|g++-12|-O3 -flto|-DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON
debug-stl|Linux x86-64|g++-12|-O1 -D_GLIBCXX_DEBUG, assertions|-DCMAKE_CXX_FLAGS_RELEASE=-O1;FLAGS=-D_GLIBCXX_DEBUG
ms-layout|Linux x86-64|g++-12|-O3 -mms-bitfields -fms-extensions|FLAGS=-mms-bitfields -fms-extensions
small|Linux x86-64|g++-12|-O3 -DLGS_SMALL_CODE|FLAGS=-DLGS_SMALL_CODE;-DCMAKE_C_FLAGS=-DLGS_SMALL_CODE
'
packages=(
  g++-12 clang-14 clang-19 libc++-19-dev libc++abi-19-dev g++-i686-linux-gnu
  g++-aarch64-linux-gnu g++-s390x-linux-gnu qemu-user
  g++-mingw-w64-x86-64-posix wine wine64
  lld-19 llvm-19 libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc nodejs
)

toolchain_of() {
  case $1 in
    i686 | aarch64 | s390x) echo "$1-linux-gnu" ;;
    windows) echo x86_64-w64-mingw32 ;;
    wasm) echo wasm32-wasi ;;
  esac
}

# What runs the programs of a row, if the machine does not.
runner_of() {
  case $1 in
    aarch64 | s390x) echo "qemu-$1" ;;
    windows) echo wine ;;
    wasm) echo node --no-warnings cmake/toolchains/wasi.mjs ;;
  esac
}

row() { printf '| %-9s | %-20s | %-36s | %-36s | %-16s | %-9s | %-9s | %8s | %5s | %7s |\n' "$@"; }
failed=0

# run_row NAME PLATFORM COMPILER OPTIONS CMAKE-OPTIONS
run_row() {
  local name=$1 platform=$2 compiler=$3 options=$4 build=build/everywhere/$1
  local flags='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow' arguments=() given runner toolchain
  read -ra runner <<<"$(runner_of "$name")"
  toolchain=$(toolchain_of "$name")
  local tool
  for tool in "$compiler" "${runner[@]:0:1}"; do
    if ! command -v "$tool" >/dev/null; then
      row "$name" "$platform" "$compiler" "$options" "$tool is missing" "" "" "" "" ""
      ((strict)) && failed=1
      return
    fi
  done
  IFS=';' read -ra given <<<"$5"
  for option in "${given[@]}"; do
    if [[ $option == FLAGS=* ]]; then flags+=" ${option#FLAGS=}"; else arguments+=("$option"); fi
  done
  if [[ $toolchain ]]; then
    arguments+=(--toolchain "$PWD/cmake/toolchains/$toolchain.cmake")
  else
    local c=${compiler/clang++/clang}
    arguments+=("-DCMAKE_CXX_COMPILER=$compiler" "-DCMAKE_C_COMPILER=${c/g++/gcc}")
  fi
  mkdir -p "$build"
  local log=$build/log.txt version
  version="$compiler $("$compiler" -dumpfullversion 2>/dev/null || "$compiler" -dumpversion)"
  if ! { cmake -S proptests/platform -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
           "-DCMAKE_CXX_FLAGS=$flags" "${arguments[@]}" && cmake --build "$build" --clean-first; } >"$log" 2>&1; then
    row "$name" "$platform" "$version" "$options" 'does not build' no no "" "" ""
    failed=1
    return
  fi
  local program warnings printed begin seconds hash same two_files tests
  program=$(find "$build" -maxdepth 1 -name 'lgs_platform*' -type f | head -n 1)
  warnings=$(grep -cE '(^|/)(lib|two_files)/.*warning:' "$log")
  "${runner[@]}" "$program" >/dev/null 2>&1  # Wine makes itself at home first
  begin=$(date +%s%N)
  printed=$("${runner[@]}" "$program" 2>>"$log" | tr -d '\r')
  seconds=$(awk "BEGIN { printf \"%.1f\", ($(date +%s%N) - $begin) / 1e9 }")
  hash=$(sed -n 's/^all //p' <<<"$printed")
  same=yes
  if [[ $printed != "$(<proptests/platform/expected.txt)" ]]; then
    same="no: $(diff <(echo "$printed") proptests/platform/expected.txt | sed -n 's/^> \([^ ]*\) .*/\1/p' |
                grep -vx all | paste -sd ' ')"
    failed=1
  fi
  ctest --test-dir "$build" --output-on-failure >>"$log" 2>&1 || failed=1
  tests=$(sed -n 's/^\([0-9]*\)% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)/\2 \3/p' "$log" | tail -n 1 |
          awk '{ print $2 - $1 "/" $2 }')
  if ctest --test-dir "$build" -R '^two_files' >/dev/null; then two_files=yes; else two_files=no; fi
  row "$name" "$platform" "$version" "$options" "${hash:-none}" "$same" "$two_files" "$warnings" "$tests" "$seconds"
}

only=()
install=1 strict=0
while (($#)); do
  case $1 in
    --only)
      only+=("${2:?--only needs a name; --list has them}")
      shift
      ;;
    --no-install) install=0 ;;
    --strict) strict=1 ;;
    --list)
      sed -n 's/^\([^|]*\)|.*/\1/p' <<<"$rows"
      exit
      ;;
    --help | -h)
      sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *)
      echo "everywhere: '$1' is no option; --help has them" >&2
      exit 2
      ;;
  esac
  shift
done
for name in "${only[@]}"; do
  if ! grep -qxF "$name" <<<"$(sed 's/|.*//' <<<"$rows")"; then
    echo "everywhere: no row '$name'; --list has them" >&2
    exit 2
  fi
done

if ((install)); then scripts/setup.sh "${packages[@]}" >&2 || exit 1; fi
export WINEPREFIX=$PWD/build/everywhere/wine WINEDEBUG=-all
row name platform compiler options hash same amalgamation warnings tests seconds
row --- --- --- --- --- --- --- ---: ---: ---:
while IFS='|' read -r name platform compiler options arguments; do
  [[ $name ]] || continue
  if ((${#only[@]})) && [[ " ${only[*]} " != *" $name "* ]]; then continue; fi
  run_row "$name" "$platform" "$compiler" "$options" "$arguments" </dev/null
done <<<"$rows"
exit "$failed"
