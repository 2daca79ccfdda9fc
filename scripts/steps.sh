# Sourced by verify.sh, test.sh and others: steps with a time each, a log for what is long, and a progress line on a
# terminal. Before sourcing: cd to the project's root. Afterwards: $logs, a folder for the logs of this run.
# shellcheck shell=bash

logs=$PWD/out/logs/$(basename "$0" .sh)
rm -rf "$logs"
mkdir -p "$logs"
SECONDS=0
export NINJA_STATUS='[%f/%t] '
export CLICOLOR_FORCE=0

# progress LOG TITLE: until it is killed, or the script is gone, shows the last line of a log.
progress() {
  local begin=$SECONDS
  while kill -0 $$ 2>/dev/null; do
    printf '\r\033[K%-44s %4d s  %.60s' "$2" $((SECONDS - begin)) "$(tail -n 1 "$1" 2>/dev/null | tr -d '\r\t')"
    sleep 0.3
  done
}

# step LOG TITLE COMMAND...: runs the command with its output in $logs/LOG.log; on a terminal the log's last line shows
# what it is doing. Ends the script, with the end of the log, when the command fails.
step() {
  local log=$logs/$1.log title=$2 begin=$SECONDS status=0 reporter=
  shift 2
  if [[ -t 1 ]]; then
    progress "$log" "$title" &
    reporter=$!
  else
    printf '%s …\n' "$title"
  fi
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [[ $reporter ]]; then
    kill "$reporter"
    wait "$reporter" 2>/dev/null || true
    printf '\r\033[K'
  fi
  if ((status != 0)); then
    tail -n 40 "$log" >&2
    finished "$title" "$begin" "FAILED (status $status); all of its output: $log" >&2
    exit "$status"
  fi
  finished "$title" "$begin" ok
}

finished() { printf '%-44s %4d s  %s\n' "$1" $((SECONDS - $2)) "$3"; }

# show LOG TITLE COMMAND...: the same for a command whose output is worth seeing: it goes to the screen and to the log.
show() {
  local log=$logs/$1.log title=$2 begin=$SECONDS status=0
  shift 2
  printf '\n%s\n' "$title"
  "$@" </dev/null | tee "$log" || status=$?
  if ((status != 0)); then
    finished "" "$begin" "FAILED (status $status): $*" >&2
    exit "$status"
  fi
  finished "" "$begin" ok
}

# build PRESET TARGET...: configures and builds with a preset of CMakePresets.json.
build() {
  local preset=$1
  shift
  step "configure-$preset" "Configure ($preset)" cmake --preset "$preset"
  step "build-$preset" "Build ($preset)" cmake --build --preset "$preset" -j "$(nproc)" --target "$@"
}
