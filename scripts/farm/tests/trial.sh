#!/usr/bin/env bash
# Tries the farm with real schedulers on this machine: scripts/farm/tests/trial.sh [slurm|parallel]; default: both.
#
# Twelve units of one block each, on three virtual nodes. One task is killed in mid-run, with all that it started, as
# when its node is gone; one gets the signal that the kernel sends when memory runs out; and the "engine" of one has a
# bug. At the end nothing may be lost, nothing may count twice, and the finding must be on the page, with its picture.
# Debian: slurm-wlm munge parallel; run as root, with build/release built. Takes two minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
for program in proptests/lgs_engine_tests cli/lgs; do
  [[ -x build/release/$program ]] || { echo "trial.sh: build the preset release first" >&2; exit 2; }
done
scratch=$(mktemp -d /tmp/lgs-trial-XXXXXX)
root=$PWD
clean() {
  pkill -f "$scratch" 2>/dev/null || true
  [[ ! -e $scratch/slurm ]] || pkill -f 'slurmd -N (north|east|south)' || true
  sleep 1
  pkill -9 -f "$scratch" 2>/dev/null || true
  rm -rf "$scratch"
}
[[ ${LGS_TRIAL_KEEP:-} ]] || trap clean EXIT

# The programs of a build, but block 3 is killed at its first try together with its task, 5 runs out of memory at its
# first try, and 7 finds a bug that is planted in an engine.
mkdir -p "$scratch/build/proptests"
cat >"$scratch/build/proptests/lgs_engine_tests" <<EOF
#!/usr/bin/env bash
sleep 2  # so that a task can be met in mid-run
block=\${1##*/}
case \$block in
  3) mkdir "$scratch/3" 2>/dev/null && { kill -9 \$PPID; sleep 60; } ;;
  5) mkdir "$scratch/5" 2>/dev/null && kill -9 \$\$ ;;
  7) sed 's/e\\[::-1\\] not in edges or/True or/' "$root/examples/engines/naive.py" >engine.py
     exec "$root/build/release/cli/lgs" check --engine 'python3 engine.py' --edits 500 --shrink 5 ;;
esac
exec "$root/build/release/proptests/lgs_engine_tests" "\$@"
EOF
chmod +x "$scratch/build/proptests/lgs_engine_tests"

# The adapters run what they always run, with this build.
mkdir "$scratch/tree"
cp -r scripts "$scratch/tree/"
mv "$scratch/tree/scripts/farm.py" "$scratch/tree/scripts/farm_itself.py"
cat >"$scratch/tree/scripts/farm.py" <<EOF
#!/usr/bin/env bash
[[ \$1 == run ]] || exec python3 "$scratch/tree/scripts/farm_itself.py" "\$@"
export LGS_FARM_HOST=\${LGS_FARM_HOST:-\${SLURMD_NODENAME:-host}}
exec python3 "$scratch/tree/scripts/farm_itself.py" "\$@" --build "$scratch/build" --build-is-right
EOF
chmod +x "$scratch/tree/scripts/farm.py"
cp -r examples "$scratch/tree/"

look() {  # NAME: what must have come of it
  local page=$scratch/$1.md
  cp "$scratch/tree/out/farm/page.md" "$page"
  cp "$scratch/tree/out/farm/page.html" "$scratch/$1.html"
  grep -q '^12 units: 11 passed, 1 with findings, 0 missing\.' "$page" || { cat "$page"; echo "FAILED: $1"; exit 1; }
  [[ $(grep -c '^### ' "$page") == 1 ]] || { cat "$page"; echo "FAILED: $1 tells another number of findings"; exit 1; }
  grep -q 'data:image/svg+xml' "$scratch/$1.html" || { echo "FAILED: $1 has no picture"; exit 1; }
  local hosts
  hosts=$(sed -n '/^## Slowest/,/^## Commits/s/.*| \(.*\) |$/\1/p' "$page" | sort -u | grep -vc 'host$\|---' || true)
  mkdir -p out/farm
  cp "$page" "$scratch/$1.html" out/farm/
  sed -n 3p "$page"
  echo "$1: nothing lost, nothing counted twice, one finding with its picture, on $hosts nodes at least: out/farm/$1.html"
}

plan() {
  rm -rf "$scratch/3" "$scratch/5" "$scratch/tree/out" "$scratch/results"
  scripts/farm.py plan --naive 12 --count 1 -o "$scratch/plan.jsonl" >/dev/null
}

with_parallel() {
  plan
  # Three hosts that are this machine: what stands in for ssh runs the command here, and says which host it is.
  cat >"$scratch/ssh" <<'EOF'
#!/usr/bin/env bash
export LGS_FARM_HOST=$1
shift
[[ $1 == -- ]] && shift
exec bash -c "$*"
EOF
  chmod +x "$scratch/ssh"
  PARALLEL_SSH=$scratch/ssh "$scratch/tree/scripts/farm/parallel.sh" "$scratch/plan.jsonl" "$scratch/results" \
    --sshlogin 1/north,1/east,1/south --will-cite >"$scratch/parallel.log" 2>&1 || true
  look parallel
}

with_slurm() {
  plan
  mkdir -p "$scratch/slurm/spool" "$scratch/slurm/state"
  dd if=/dev/urandom of="$scratch/slurm/key" bs=1024 count=1 status=none
  chmod 400 "$scratch/slurm/key"
  chmod 711 "$scratch" "$scratch/slurm"
  munged --force --key-file "$scratch/slurm/key" --socket "$scratch/slurm/munge" --pid-file "$scratch/slurm/munge.pid" \
    --log-file "$scratch/slurm/munge.log" --seed-file "$scratch/slurm/seed"
  cat >"$scratch/slurm/slurm.conf" <<EOF
ClusterName=trial
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=26817
AuthType=auth/munge
AuthInfo=socket=$scratch/slurm/munge
StateSaveLocation=$scratch/slurm/state
SlurmdSpoolDir=$scratch/slurm/spool/%n
SlurmctldPidFile=$scratch/slurm/ctld.pid
SlurmdPidFile=$scratch/slurm/%n.pid
SlurmctldLogFile=$scratch/slurm/ctld.log
SlurmdLogFile=$scratch/slurm/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
MaxArraySize=8
SchedulerType=sched/builtin
SelectType=select/linear
NodeName=north NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=26821 CPUs=1
NodeName=east NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=26822 CPUs=1
NodeName=south NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=26823 CPUs=1
PartitionName=all Nodes=north,east,south Default=YES State=UP
EOF
  export SLURM_CONF=$scratch/slurm/slurm.conf
  mkdir -p "$scratch"/slurm/spool/{north,east,south}
  slurmctld
  for node in north east south; do slurmd -N "$node"; done
  local waited=0
  until [[ $(sinfo -h -t idle -o %D 2>/dev/null) == 3 ]]; do
    ((++waited <= 180)) || { tail -n 5 "$scratch"/slurm/*.log; echo "FAILED: Slurm does not begin"; exit 1; }
    sleep 1
  done
  # What is lost gets a second submission: the same command again.
  for _ in 1 2 3; do
    status=0
    "$scratch/tree/scripts/farm/slurm.sh" "$scratch/plan.jsonl" "$scratch/results" >"$scratch/slurm.log" 2>&1 || status=$?
    ((status == 75)) || break
  done
  look slurm
}

case ${1:-both} in
  parallel) with_parallel ;;
  slurm) with_slurm ;;
  both) with_parallel; with_slurm ;;
  *) sed -n '2,/^set /{/^#/s/^# \?//p}' "$0"; exit 2 ;;
esac
