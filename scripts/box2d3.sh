#!/usr/bin/env bash
# The terrain with an installed Box2D 3: scripts/box2d3.sh PREFIX. CMake finds Box2D below PREFIX, as a game's CMake
# would. Builds into build/box2d3, and runs the tests of the terrain, the examples, a game that uses the installed
# package, and with --costs the table of costs. Another PREFIX may follow: only what needs Box2D is compiled again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
costs=
if [[ ${1-} == --costs ]]; then
  costs=yes
  shift
fi
if [[ $# != 1 || ! -d $1 ]]; then
  echo "usage: scripts/box2d3.sh [--costs] PREFIX, the folder into which Box2D 3.1 or later was installed" >&2
  exit 2
fi
prefix=$(cd "$1" && pwd)
source scripts/steps.sh

build=build/box2d3
# The package has all libraries that are installed.
targets=(lgs_installed lgs_box2d_tests box2d_3_digging digger lgs_terrain_costs)
# What an earlier run found is forgotten, as it may have been for another PREFIX.
step configure 'Configure' cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
  -Ubox2d_DIR "-DCMAKE_PREFIX_PATH=$prefix"
found=$(sed -n 's/^box2d_DIR:PATH=//p' "$build/CMakeCache.txt")
if [[ $found != "$prefix"/* ]]; then
  echo "box2d3.sh: there is no Box2D below $prefix; CMake found $found" >&2
  exit 2
fi
step build 'Build' cmake --build "$build" -j "$(nproc)" --target "${targets[@]}"
step test 'Tests, example, package' ctest --test-dir "$build" --output-on-failure --no-tests=error \
  -R '^(lgs_box2d_tests|example[.](box2d_3_|digger)|package[.](install|consumer_box2d|other_box2d))'
if [[ $costs ]]; then
  show costs 'Costs' "$build/addons/box2d/ride/lgs_terrain_costs"
fi
