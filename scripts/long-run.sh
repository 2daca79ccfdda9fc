#!/usr/bin/env bash
# The bulk of the random tests, longer than in ./test.sh: scripts/long-run.sh [SCALE [SEED]], one shard a core, at low
# priority. SCALE 25 (the default) makes 5,000,000 comparisons with CGAL and more than 20,000,000 with the naive
# reference. Ends with the numbers for docs/reports/long-runs.md. On a farm each machine runs what stands in the loop below,
# with a GTEST_SHARD_INDEX of its own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() { sed -n '2,/^set /{/^#/s/^# \?//p}' scripts/long-run.sh; }
wrong() { printf 'long-run.sh: %s\n\n' "$1" >&2; usage >&2; exit 2; }
[[ ${1:-} == -h || ${1:-} == --help ]] && { usage; exit; }
(($# <= 2)) || wrong "two arguments at most, not $#"
[[ ${1:-25} =~ ^[0-9]{1,6}(\.[0-9]+)?$ && ${1:-25} =~ [1-9] ]] ||
  wrong "SCALE is a number above 0 and below 1000000, such as 0.2 or 25, not '$1'"
[[ ${2:-1} =~ ^[0-9]{1,19}$ ]] || wrong "SEED is a whole number of at most 19 digits, not '$2'"
source scripts/steps.sh

export LGS_TEST_SCALE=${1:-25} LGS_TEST_SEED=${2:-1}
tests=${LGS_TESTS:-build/release/proptests/lgs_engine_tests}
[[ ${LGS_TESTS:-} ]] || build release lgs_engine_tests

export GTEST_TOTAL_SHARDS
GTEST_TOTAL_SHARDS=$(nproc)
shards=()
for ((k = 0; k < GTEST_TOTAL_SHARDS; ++k)); do
  GTEST_SHARD_INDEX=$k nice -n 19 "$tests" --gtest_filter='Bulk*' >"$logs/shard-$k.log" 2>&1 &
  shards+=($!)
done
status=0
for shard in "${shards[@]}"; do wait "$shard" || status=1; done

grep -h FAILED -B 40 "$logs"/shard-*.log >&2 || true
cat "$logs"/shard-*.log | awk -v seconds=$SECONDS -v scale="$LGS_TEST_SCALE" -v seed="$LGS_TEST_SEED" '
  / commits, .* compared with CGAL/ {
    blocks++; commits += $1; cgal += $3; naive += $7; edits += $12; refused += $14; cases += $16
  }
  END {
    printf "scale %s, seed %s: %d blocks, %d cases, %d edits (%d refused), %d commits\n",
      scale, seed, blocks, cases, edits, refused, commits
    printf "compared %d times with CGAL, %d with the naive reference, in %d s\n", cgal, naive, seconds
  }'
((status == 0)) && echo "no mismatch"
exit "$status"
