#!/usr/bin/env bash
# Runs all tests: in Release, then with the address and undefined-behaviour sanitizers; those of threads with the thread
# sanitizer too. Installs what is missing first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh

scripts/setup.sh
summary=
for preset in release asan; do
  build "$preset" all
  show "ctest-$preset" "Tests ($preset)" ctest --preset "$preset" -j2
  summary+="$preset $(sed -n 's/.* out of //p' "$logs/ctest-$preset.log"), "
done
build tsan lgs_thread_tests
show ctest-tsan "Tests (tsan)" ctest --preset tsan -R '^tsan\.'
summary+="tsan $(sed -n 's/.* out of //p' "$logs/ctest-tsan.log"), "
printf '\ntest.sh: all tests passed (%s) in %d s\n' "${summary%, }" "$SECONDS"
