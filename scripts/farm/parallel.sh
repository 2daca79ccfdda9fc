#!/usr/bin/env bash
# GNU parallel: scripts/farm/parallel.sh PLAN RESULTS [option of parallel ...]
#
# Without options all cores of this machine; with --sshlogin 8/hostA,8/hostB also others. A host has the project, built,
# in the same folder, and RESULTS on a disk that all share. (Otherwise bring their folders together; merge takes many.)
# What is lost is tried three times. A finding is an answer, and is not tried again.
set -euo pipefail
(($# >= 2)) || { sed -n '2,/^set /{/^#/s/^# \?//p}' "$0"; exit 2; }
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
plan=$1 results=$2
shift 2
scripts/farm.py show "$plan" --left "$results" |
  parallel --retries 3 --workdir "$PWD" "$@" "scripts/farm.py run $(printf %q "$plan") {} --to $(printf %q "$results") ||
    [ \$? -eq 42 ]" || true
exec scripts/farm.py merge "$plan" "$results"
