#!/usr/bin/env bash
# Runs all tests: those of the engine and its packages in Release with g++; then all, tools too, with clang++ and the
# address and undefined-behaviour sanitizers; those of threads with the thread sanitizer; and those of the web side in
# Node and Chromium, unless LGS_WEB=OFF. Installs what is missing first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
source scripts/web_steps.sh

scripts/setup.sh clang libclang-rt-dev chromium-driver libopenmpi-dev python3-shapely valgrind
summary=
# check PRESET TARGET CTEST-OPTION...: builds the target, and runs the tests on all cores. Some of them mostly wait.
check() {
  local preset=$1 target=$2
  shift 2
  build "$preset" "$target"
  show "ctest-$preset" "Tests ($preset)" ctest --preset "$preset" -j "$(($(nproc) + 2))" "$@"
  summary+="$preset $(sed -n 's/.* out of //p' "$logs/ctest-$preset.log"), "
}
check release lgs_tested_in_release -LE once
check asan lgs_tested
check tsan lgs_thread_tests -R '^tsan\.'
if [[ ${LGS_WEB:-ON} == OFF ]]; then
  printf '\nTests (web) are left out, since LGS_WEB=OFF\n'
  summary+='web left out, '
else
  build_web
  export LGS_COMMAND=$PWD/build/asan/cli/lgs
  for part in package sandbox article; do
    show "web-$part-tests" "Tests (web/$part)" npm test --silent --prefix "web/$part"
    summary+="web/$part $(sed -n 's/.*tests \([0-9]*\)$/\1/p' "$logs/web-$part-tests.log"), "
  done
fi
printf '\ntest.sh: all tests passed (%s) in %d s\n' "${summary%, }" "$SECONDS"
