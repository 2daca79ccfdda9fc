#!/usr/bin/env bash
# Slurm: scripts/farm/slurm.sh PLAN RESULTS [option of sbatch ...]
#
# Submits what is left of the plan as job arrays, a task for each unit, and waits for them. PLAN, RESULTS and this
# folder are on a disk that all nodes share; the project is built here. Slurm runs the tasks of a lost node again. For
# what else is lost give the same command again: it submits only what has no result.
set -euo pipefail
(($# >= 2)) || { sed -n '2,/^set /{/^#/s/^# \?//p}' "$0"; exit 2; }
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
plan=$(realpath "$1") results=$(realpath -m "$2")
shift 2
mkdir -p "$results"
most=$(scontrol show config | sed -n 's/^MaxArraySize *= *//p')  # indices are below it
mapfile -t left < <(scripts/farm.py show "$plan" --left "$results")
jobs=()
submit() {  # OFFSET INDEX...
  local offset=$1 list
  shift
  list=$(printf ',%s' "$@")
  jobs+=("$(sbatch --parsable --requeue --chdir "$PWD" --output "$results/slurm-%A_%a.log" --array "${list:1}" \
    "${options[@]}" --export "ALL,LGS_FARM_OFFSET=$offset" \
    --wrap "exec scripts/farm.py run '$plan' \$((LGS_FARM_OFFSET + SLURM_ARRAY_TASK_ID)) --to '$results'")")
}
options=("$@") offset=0 some=()
for index in "${left[@]}"; do
  while ((index - offset >= most)); do
    ((${#some[@]} == 0)) || submit "$offset" "${some[@]}"
    some=()
    ((offset += most))
  done
  some+=($((index - offset)))
done
((${#some[@]} == 0)) || submit "$offset" "${some[@]}"
for job in "${jobs[@]}"; do
  while [[ -n $(squeue --noheader --jobs "${job%%;*}" 2>/dev/null) ]]; do sleep 2; done
done
exec scripts/farm.py merge "$plan" "$results"
