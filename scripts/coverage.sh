#!/usr/bin/env bash
# Which lines and branches of lib/ the tests in proptests/ reach: scripts/coverage.sh [SCALE], SCALE being that of the
# random work (LGS_TEST_SCALE, default 0.25). Builds into build/coverage and ends with two tables for each part of lib/,
# lines and branches, and the path of a report in HTML. Branches of exceptions are left out: lib/ is compiled without
# them, but what it inlines of the standard library is not free of them. Assertions are off: their failing is no branch
# that a test could take. Fails below 99 % of lines or 95 % of branches.
# Needs gcovr (Debian: gcovr).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/steps.sh
command -v gcovr >/dev/null || { echo "coverage: gcovr is missing: apt-get install gcovr" >&2; exit 2; }

build=$PWD/build/coverage
# What is inlined counts its branches where it was called. Counters that threads share are atomic, or they go wrong.
flags='-O1 -g1 -DNDEBUG --coverage -fno-inline -fprofile-update=atomic'
step configure 'Configure (coverage)' cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
  "-DCMAKE_CXX_FLAGS_DEBUG=$flags" -DCMAKE_EXE_LINKER_FLAGS=-Wl,-u,__gcov_dump  # for child processes: isolated.cpp
step build 'Build (coverage)' cmake --build "$build" --target lgs_engine_tests lgs_view_tests lgs_brush_tests \
  lgs_tiled_tests lgs_debug_tests lgs_box2d_tests
find "$build" -name '*.gcda' -delete

export LGS_TEST_SCALE=${1:-0.25}
step engine 'Tests of the engine' "$build/proptests/lgs_engine_tests"
step views 'Tests of views' "$build/proptests/lgs_view_tests"
step brush 'Tests of brushes' "$build/proptests/brush/lgs_brush_tests"
step tiled "Tests of the importer" "$build/addons/tiled/tests/lgs_tiled_tests"
step debug "Tests of traces and pictures" "$build/addons/debug/tests/lgs_debug_tests"
step box2d 'Tests of the terrain for Box2D' "$build/addons/box2d/tests/lgs_box2d_tests"

# Gathered once. A report then is two tables of the files that match: lines, and branches.
gathered=$build/coverage.json
step gather 'Gather' gcovr --root . --filter lib/ --filter addons/ --exclude-throw-branches --exclude-unreachable-branches --json "$gathered" \
  "$build"
report() {
  local title=$1 filter=$2
  printf '\n%s: lines\n' "$title"
  gcovr --root . --add-tracefile "$gathered" --filter "$filter"
  printf '\n%s: branches\n' "$title"
  gcovr --root . --add-tracefile "$gathered" --filter "$filter" --branches --print-summary
}
mkdir -p out/coverage
report 'The importer' 'addons/tiled/'
report 'The terrain for Box2D' 'addons/box2d/'
report 'Brushes' 'lib/brush/'
report 'The engine' 'lib/(include|geometry|storage|ground|outline|world)/'
printf '\ncoverage.sh: all of lib/, line by line in %s/out/coverage/index.html\n' "$PWD"
gcovr --root . --add-tracefile "$gathered" --html-details out/coverage/index.html --print-summary --fail-under-line 99 \
  --fail-under-branch 95
