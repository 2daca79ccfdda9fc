#!/usr/bin/env bash
# A CI job for an engine with known failures, as docs/recipes.md says:
#
#   examples/engines/ci.sh LGS 'CAPABILITY …' FOLDER ENGINE-OPTION…
#
# In worlds that need no more than the capabilities the engine must be right. Each FOLDER/*.trace is a known failure: it
# must still fail. LGS_CI_SEED picks other worlds, LGS_CI_EDITS how many edits are made. Exit status: 0 as expected; 1 a
# new failure, or a known one that is mended; 2 bad usage.
set -uo pipefail
shopt -s nullglob
if (($# < 4)); then
  sed -n '2,/^set/{/^#/p}' "$0" >&2
  exit 2
fi
lgs=$1 works=$2 known=$3
shift 3

"$lgs" check "$@" --assume "$works" --edits "${LGS_CI_EDITS:-10000}" --seed "${LGS_CI_SEED:-1}" --out out/ci || exit

unexpected=0
for trace in "$known"/*.trace; do
  "$lgs" replay "$trace" --check "$@" >/dev/null
  status=$?
  if ((status == 0)); then
    echo "mended, make it a regression: $trace"
    unexpected=1
  elif ((status != 1)); then
    exit 2
  fi
done
((unexpected == 0)) && echo "known failures, and no others"
exit "$unexpected"
