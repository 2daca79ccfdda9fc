#!/usr/bin/env bash
# Fuzzes all targets on all cores with libFuzzer, under the address and undefined-behaviour sanitizers, until as much
# CPU time is spent as asked for. Ctrl-C at any time: the same command goes on where it stopped.
#
#   fuzz/run.sh [--cpu-hours H] [--jobs N] [--slice SECONDS] [--out DIR] [--build DIR] [TARGET...]
#
#   --cpu-hours H  over all targets, earlier runs in the same folder included; default 3
#   --jobs N       processes at a time; default: one a core
#   --slice S      seconds until a core goes on with the target that had least; default 600. A slice begins
#                  by running the whole corpus, which takes the sanitizers up to two minutes
#   --out DIR      corpus, findings, logs; default out/fuzz. To begin anew, delete it
#   --build DIR    programs that are built already; default: builds the preset `fuzz`
#
# Exit status: 0 no finding, 1 findings or a target that failed, 2 bad usage. More: fuzz/README.md
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

hours=3 jobs=$(nproc) slice=600 out=out/fuzz build=
declare -A settings=([--cpu-hours]=hours [--jobs]=jobs [--slice]=slice [--out]=out [--build]=build)
source fuzz/options.sh
targets=("${words[@]}")
if [[ ! $hours =~ ^[0-9]+(\.[0-9]+)?$ || ! $hours =~ [1-9] || \
  ! $jobs =~ ^[1-9][0-9]*$ || ! $slice =~ ^[1-9][0-9]*$ ]]; then
  echo "run.sh: --cpu-hours, --jobs and --slice take positive numbers" >&2
  exit 2
fi
for target in "${targets[@]}"; do
  [[ -e fuzz/corpus/$target.tar ]] ||
    { echo "run.sh: no target $target; there are $(basename -s .tar fuzz/corpus/* | xargs)" >&2; exit 2; }
done
if [[ -z $build ]]; then
  build=build/fuzz
  cmake --preset fuzz >/dev/null
  cmake --build --preset fuzz
fi
bin=$build/fuzz
((${#targets[@]})) || for program in "$bin"/fuzz_*; do targets+=("${program##*/fuzz_}"); done
for target in "${targets[@]}"; do
  [[ -x $bin/fuzz_$target ]] || { echo "run.sh: there is no $bin/fuzz_$target" >&2; exit 2; }
done

# A line for each slice: target, CPU seconds, executions, edges at its start and end, exit status.
table=$out/slices.tsv
mkdir -p "$out/logs" "$out/findings"
touch "$table"
for target in "${targets[@]}"; do
  mkdir -p "$out/corpus/$target"
  tar --skip-old-files -xf "fuzz/corpus/$target.tar" -C "$out/corpus/$target"
done
export LGS_FUZZ_OUT=$out/findings

# one TARGET SEED: one slice, and its line in the table.
one() {
  local target=$1 log=$out/logs/$1-$2.log cpu=$out/logs/$1-$2.cpu status=0 dictionary=fuzz/dictionaries/$1.dict
  local options=(-max_len=1024)  # 64 records; a text needs more to say as much, and what is cut off its end spoils it
  [[ ! -e $dictionary ]] || options=(-max_len=4096 "-dict=$dictionary")
  TIMEFORMAT='%U %S'
  { time nice "$bin/fuzz_$target" -seed="$2" -max_total_time="$slice" -timeout=60 -rss_limit_mb=2048 -reload=1 \
    -print_final_stats=1 -artifact_prefix="$out/findings/$target-" "${options[@]}" \
    "$out/corpus/$target" >"$log" 2>&1; } 2>"$cpu" || status=$?
  if ((status != 0 && status != 72)); then  # 72: interrupted
    local input
    input=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
    if [[ -n $input ]]; then
      "$bin/lgs_fuzz" report "$target" "$input" --out "$out/findings" >"$input.txt" 2>&1 || true
    else
      { printf '\nrun.sh: %s failed (status %s) and is left out; the end of %s:\n' "$target" "$status" "$log"
        tail -n 5 "$log"; } >&2
      status=failed
    fi
  fi
  record "$target" "$log" "$cpu" "$status"
}

record() {
  local executions first last
  executions=$(sed -n 's/^#\([0-9]*\).*/\1/p; s/^stat::number_of_executed_units: *//p' "$2" | tail -n 1)
  first=$(sed -n 's/.*INITED cov: \([0-9]*\).*/\1/p' "$2" | head -n 1)
  last=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$2" | tail -n 1)
  printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$(awk 'END { print $1 + $2 }' "$3")" "${executions:-0}" "${first:-0}" \
    "${last:-0}" "$4" >>"$table"
  rm -f "$3"
}

spent() { awk -F'\t' '{ s += $2 } END { printf "%d", s }' "$table"; }

# Those that failed since this run began.
failed() { awk -F'\t' -v begin="$begin" 'NR > begin && $6 == "failed" { print $1 }' "$table" | sort -u | xargs; }

# The target with the least CPU time, none if all failed. Those that run now count as if they had their slice, and a
# slice that ends at once with a finding as if it had a tenth of it, so that the others have their turn.
next() {
  { cat "$table"; for target in "${targets[@]}" "${running[@]}"; do printf '%s\t%s\n' "$target" 0; done
    for target in "${running[@]}"; do printf '%s\t%s\n' "$target" "$slice"; done; } |
    awk -F'\t' -v wanted=" ${targets[*]} " -v failed=" $(failed) " -v least="$((slice / 10))" '
      index(wanted, " " $1 " ") && !index(failed, " " $1 " ") { s[$1] += $6 == "" || $2 > least ? $2 : least }
      END { for (t in s) if (best == "" || s[t] < s[best] || (s[t] == s[best] && t < best)) best = t; print best }'
}

# Not what libFuzzer only finds slow.
findings() { find "$out/findings" -type f ! -name '*.*' ! -name '*-slow-unit-*' | wc -l; }

# What the slices that run now, each a process group, have done so far: CPU seconds, executions.
seconds_now() {
  ps -eo pgid=,cputimes= |
    awk -v groups=" ${!slot[*]} " 'index(groups, " " $1 " ") { s += $2 } END { print s + 0 }'
}
executions_now() {
  for slice_name in "${slot[@]}"; do
    awk '/^#[0-9]+\t/ { n = substr($1, 2) } END { print n + 0 }' "$out/logs/$slice_name.log" 2>/dev/null
  done | awk '{ s += $1 } END { print s + 0 }'
}

status_line() {
  local text
  text=$(printf '%5.1f of %g CPU minutes, %s executions, %s findings; now' \
    "$(awk -v s="$(($(spent) + $(seconds_now)))" 'BEGIN { print s / 60 }')" \
    "$(awk -v h="$hours" 'BEGIN { print h * 60 }')" \
    "$(awk -F'\t' -v now="$(executions_now)" '{ s += $3 } END { print s + now }' "$table")" "$(findings)")
  for target in "${running[@]}"; do text+=" $target"; done
  if [[ -t 1 ]]; then printf '\r\033[K%s' "$text"; else echo "$text"; fi
}

summary() {
  printf '\n%-10s %8s %12s %12s %10s %8s\n' target CPU-min executions 'edges first' 'edges now' inputs
  local target
  for target in "${targets[@]}"; do
    awk -F'\t' -v t="$target" -v n="$(find "$out/corpus/$target" -type f | wc -l)" '
      $1 == t { cpu += $2; runs += $3; if (first == "" && $4 > 0) first = $4; if ($5 > last) last = $5 }
      END { printf "%-10s %8.1f %12d %12d %10d %8d\n", t, cpu / 60, runs, first, last, n }' "$table"
  done
  echo "findings   $(findings), in $out/findings"
  [[ -z $(failed) ]] || echo "failed     $(failed): see $out/logs"
}

# The exit status.
verdict() { (($(findings) == 0)) && [[ -z $(failed) ]]; }

declare -A slot=()  # process: TARGET-SEED, the name of its slice
running=()
begin=$(wc -l <"$table")
seed=$((begin + 1))
due=0  # when to print the status next, where it is no terminal
stop() {
  trap - INT TERM
  for process in "${!slot[@]}"; do kill -INT -- "-$process" 2>/dev/null || true; done
  wait
  summary
  verdict
  exit
}
trap stop INT TERM

limit=$(awk -v h="$hours" 'BEGIN { printf "%d", h * 3600 }')
share=$((limit / (${#targets[@]} > jobs ? ${#targets[@]} : jobs)))  # every target has its turn in a short run
((slice <= share)) || slice=$((share > 0 ? share : 1))
while :; do
  for process in "${!slot[@]}"; do kill -0 "$process" 2>/dev/null || unset "slot[$process]"; done
  running=("${slot[@]%-*}")
  while ((${#slot[@]} < jobs && $(spent) + ${#slot[@]} * slice < limit)); do
    target=$(next)
    [[ -n $target ]] || break
    set -m  # a group for each slice, so that Ctrl-C stops it after the others are told
    one "$target" "$seed" &
    set +m  # or bash would print of each that it is done
    slot[$!]=$target-$seed
    running+=("$target")
    seed=$((seed + 1))
  done
  ((${#slot[@]})) || break
  if [[ -t 1 ]] || ((SECONDS >= due)); then
    status_line
    due=$((SECONDS + 30))
  fi
  sleep 1
done
summary
verdict
