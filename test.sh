#!/usr/bin/env bash
# The tests, from a fresh clone. Installs by apt what is missing first.
#
#   ./test.sh        all: laws at a quarter of their scale, costs and packages in Release with g++; for a minute planted
#                    bugs of what changed in lib/ since LGS_SINCE (default: the last 20 commits), as far as Git knows; all
#                    tests with clang++ and the address and undefined-behaviour sanitizers; those of threads with the
#                    thread sanitizer; and the web side, in Node and Chromium, unless LGS_WEB=OFF
#   ./test.sh quick  the heart alone, while one works: all laws of engine, brushes and views at a small scale,
#                    regressions, two seconds of each fuzzer
#   ./test.sh full   for a night: all at three times their scale, all planted bugs of what changed since LGS_SINCE, half
#                    an hour of fuzzing, and a canary that must be found
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
source scripts/web_steps.sh

summary=
# check PRESET CTEST-OPTION...: runs the tests of a build on all cores. Some of them mostly wait.
check() {
  local preset=$1
  shift
  show "ctest-$preset" "Tests ($preset)" ctest --preset "$preset" -j "$(($(nproc) + 1))" "$@"
  summary+="$preset $(sed -n 's/.* out of //p' "$logs/ctest-$preset.log"), "
}

# Where planted bugs begin to be of what changed; nothing if Git does not know.
since() {
  echo "${LGS_SINCE:-$(git rev-list --max-count=20 HEAD 2>/dev/null | tail -n 1)}"
}

# Some bugs of what changed, another choice each day, in the build that was tested. A bug that the tests which are named
# for it do not find is told of; `full` fails for it. Without Git's history, or when time is up, there is nothing to say.
plant() {
  local begin log=$logs/planted.log
  begin=$(since)
  [[ $begin ]] || return 0
  timeout 120 proptests/bugs/run.py --built build/release --changed "$begin" --sample 12 --seed "$(date +%j)" \
    --minutes 1 --results "$logs/planted.jsonl" >"$log" 2>&1 || true
  grep SURVIVES "$log" || true
  summary+="$(grep -c '^\[[0-9]*/' "$log" || true) planted bugs of which $(grep -c SURVIVES "$log" || true) survive, "
}

# The web side, beside the others: nobody watches it, and its log is shown when it is done.
web() {
  build_web
  for part in package sandbox article; do
    show "web-$part-tests" "Tests (web/$part)" npm test --silent --prefix "web/$part"
  done
}

everything() {
  local packages=(clang libclang-rt-dev valgrind python3-shapely) beside=
  if [[ ${LGS_WEB:-ON} == OFF ]]; then
    scripts/setup.sh "${packages[@]}"
    summary+='web left out, '
  else
    scripts/setup.sh "${packages[@]}" chromium-driver
    step web-setup "Set up the web's tools" scripts/web_setup.sh
  fi
  build release lgs_tested_in_release lgs_cli lgs-import
  if [[ ${LGS_WEB:-ON} != OFF ]]; then
    LGS_COMMAND=$PWD/build/release/cli/lgs web >"$logs/web.log" 2>&1 &
    beside=$!
    trap 'kill "$beside" 2>/dev/null || true' EXIT
  fi
  check release -LE once
  plant
  build asan lgs_tested
  check asan
  build tsan lgs_thread_tests
  check tsan -R '^tsan\.'
  if [[ $beside ]]; then
    printf '\nThe web side, which ran beside all this\n'
    wait "$beside" || { cat "$logs/web.log" >&2; exit 1; }
    trap - EXIT
    grep -E 'ok$|^. (tests|pass|fail)' "$logs/web.log"
    for part in package sandbox article; do
      summary+="web/$part $(sed -n 's/.*tests \([0-9]*\)$/\1/p' "$logs/web-$part-tests.log"), "
    done
  fi
}

case ${1:-} in
  quick)
    scripts/setup.sh
    export LGS_TEST_SCALE=${LGS_TEST_SCALE:-0.02}
    build release lgs_tested_quick
    check release -L quick
    ;;
  full)
    export LGS_TEST_SCALE=${LGS_TEST_SCALE:-3}
    everything
    show bugs "Planted bugs of what changed since $(since)" proptests/bugs/run.py --changed "$(since)" --minutes 120
    show fuzz "Fuzzing, half an hour" fuzz/run.sh --cpu-hours "$(awk "BEGIN { print $(nproc) / 2 }")"
    show canary "A canary, which must be found" proptests/bugs/run.py --canary "$(date +%j)"
    ;;
  "")
    export LGS_TEST_SCALE=${LGS_TEST_SCALE:-0.25}
    everything
    ;;
  *)
    sed -n '2,/^set/{/^#/p}' "$0" >&2
    exit 2
    ;;
esac
printf '\ntest.sh: all tests passed (%s) in %d s\n' "${summary%, }" "$SECONDS"
