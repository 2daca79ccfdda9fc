#!/usr/bin/env bash
# Installs what the project is built with, on Debian 12 and its relatives: only what is missing, with apt-get.
# Nothing missing: it says so and is done at once. Never asks a question. With --check as the first argument: only what the
# preset `check` is built with, the lgs command to check an engine of yours. Further arguments: packages to add.
set -euo pipefail

packages=(
  g++ cmake ninja-build python3                   # the tool chain, and the example of an engine
  libexpected-dev                                 # the engine
  libcgal-dev libboost-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpugixml-dev  # the references and the lgs command
)
if [[ ${1:-} == --check ]]; then
  shift
else
  packages+=(
    libpcre2-dev libfast-float-dev zlib1g-dev libzstd-dev  # the importer of maps
    libbox2d-dev                                  # the terrain for Box2D
    libpolyclipping-dev libgeos-dev libbenchmark-dev  # the timings
    libgtest-dev libgmock-dev librapidcheck-dev   # the tests
    libsqlite3-dev                                # worlds in files, an example
  )
fi
packages+=("$@")                                  # what a script needs beyond that

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is not a Debian system; nothing installed. If CMake misses something, it is one of:"
  echo "       ${packages[*]}"
  exit 0
fi

# A package that was never installed is an error of dpkg-query's, and no line of its output.
installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "${packages[@]}" 2>/dev/null || true)"
missing=()
for package in "${packages[@]}"; do
  [[ $installed == *" installed:$package "* ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "setup: all ${#packages[@]} packages are here"
  exit 0
fi

install=(apt-get install -y --no-install-recommends "${missing[@]}")
as_root=(env DEBIAN_FRONTEND=noninteractive)
if (($(id -u) != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup: ${#missing[@]} packages are missing, and this is neither root nor is there sudo. As root, please:" >&2
    echo "       apt-get update && ${install[*]}" >&2
    exit 1
  fi
  as_root=(sudo "${as_root[@]}")
  [[ -t 0 ]] || as_root=(sudo -n "${as_root[@]:1}")  # nobody there to type a password
fi

echo "setup: installing ${missing[*]}"
log=$(mktemp "${TMPDIR:-/tmp}/lgs-setup.XXXXXX")
wait_for_lock=(-o DPkg::Lock::Timeout=300)
if ! { "${as_root[@]}" apt-get "${wait_for_lock[@]}" update &&
       "${as_root[@]}" apt-get "${wait_for_lock[@]}" "${install[@]:1}"; } >"$log" 2>&1 </dev/null; then
  tail -n 20 "$log" >&2
  echo "setup: that failed (all of it: $log). By hand, as root:" >&2
  echo "       apt-get update && ${install[*]}" >&2
  exit 1
fi
rm -f "$log"
