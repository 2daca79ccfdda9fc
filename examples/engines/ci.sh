#!/usr/bin/env bash
# A job of CI for an engine with known failures, as docs/recipes.md says:
#
#   examples/engines/ci.sh LGS LIST ENGINE-OPTION… [--fix]
#
# LIST has the failures that are known. A new one fails the job, and so does a known one that is gone; with --fix the list
# is written anew. What fails is kept in out/ci/kept, and is played first the next time. LGS_CI_SEED picks other worlds,
# for which another list is needed; LGS_CI_EDITS says how many edits are made. The exit status is that of lgs check.
set -euo pipefail
if (($# < 3)); then
  sed -n '2,/^set/{/^#/p}' "$0" >&2
  exit 2
fi
lgs=$1 list=$2
shift 2

exec "$lgs" check "$@" --known "$list" --replay out/ci/kept --report out/ci --json out/ci/results.json \
  --junit out/ci/results.xml --edits "${LGS_CI_EDITS:-10000}" --seed "${LGS_CI_SEED:-1}" --shrink 120
