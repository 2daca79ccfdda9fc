#!/usr/bin/env bash
# The main job on real input, from a fresh clone: installs what is missing, builds in Release, imports the project's
# Tiled map, digs and refills it with each commit checked, then random degenerate worlds, then a short table of
# incremental against full recompute. Ends with the path of a picture. Exit status: that of the first step that fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh

map=examples/maps/landscape.tmx
lgs=build/release/cli/lgs
out=out/verify
rm -rf "$out"
mkdir -p "$out"

scripts/setup.sh
build release lgs_cli lgs-import lgs-bench

show import "1. A Tiled map becomes a world" \
  "$lgs" import "$map" --block class -o "$out/map.trace" --svg "$out/map.svg"
# Each commit: the segments around its edits against CGAL and the naive reference, the change list for the whole world.
# Each tenth commit: the whole map's segments, links and loops against both.
show dig "2. It is dug and refilled; each commit is checked against CGAL, each tenth over the whole map" \
  "$lgs" check --map "$out/map.trace" --edits 4000 --whole-every 10 --svg "$out/dug.svg" --out "$out"
show worlds "3. Random degenerate worlds; each commit is checked as a whole against CGAL and the naive reference" \
  "$lgs" check --oracle both --edits 20000 --out "$out"
show bench "4. Incremental against full recompute" \
  "$lgs" bench --rounds 3

cat <<END

verify.sh: no mismatch, $SECONDS s
  the map        $(sed -n 's/^commits *//p' "$logs/dig.log") commits, $(sed -n 's/^segments *\([0-9]*\).*/\1 segments compared/p' "$logs/dig.log")
  random worlds  $(sed -n 's/^commits *//p' "$logs/worlds.log") commits, $(sed -n 's/^segments *\([0-9]*\).*/\1 segments compared/p' "$logs/worlds.log")
  worth a look   $PWD/$out/dug.svg  (in a browser; the map before the digging: map.svg beside it)
END
