#!/usr/bin/env bash
# Plants bugs in a copy of the project, one at a time, and lets a target search for each on one core: targets that read
# records from nothing, those that read texts from their corpus, as it takes millions of tries to hit on a whole map. Each
# must be found within a minute.
#
#   fuzz/canary.sh [--seconds S] [--out DIR] [NAME...]
#
#   --seconds S  how long to search for each; default 60. With 0 nothing is built: only whether each applies is seen
#   --out DIR    for the copy, its build, logs and findings; default out/canary
#
# A bug is a substitution that must apply. Exit status: 0 all found, 1 one was not found or does not apply, 2 bad usage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# name | target | file | text | text instead | law and break
bugs=(
  'touch-covers|edits|lib/src/boundary.h| && facing->begin <= at;|;|1: a neighbour that begins further on counts as covering'
  'uncut|edits|lib/src/boundary.h|std::min(interval.end, cut->at)|interval.end|1: an edge is not cut where a corner of the neighbour touches it'
  'uncut-off-grid|edits|lib/src/boundary.h|std::min(interval.end, cut->at)|(cut->at % 4096 == 0 ? std::min(interval.end, cut->at) : interval.end)|1: the same, only for corners off the grid of sixteenths that touch a wall'
  'uncut-slope|edits|lib/geometry/ring.h|if (isInside(p, a, b))|if (isInside(p, a, b) \&\& (a.x == b.x or a.y == b.y))|1: a slanted edge is not cut where another polygon of the cell touches it'
  'no-cancel-inside|edits|lib/src/content.cpp|if (!std::binary_search(preserved.begin(), preserved.end(), contact)) continue;||1: an overlap inside a cell is not cancelled'
  'coincident|edits|lib/src/radial_match.h| \|\| fan[at].direction == spoke.direction||2: a coincident direction is not skipped; shows under a preserve relation only'
  'many-wedges|edits|lib/src/content.cpp|  std::vector<Spoke> fan;|  if (directed.size() > 5) std::swap(directed[4], directed[5]);  std::vector<Spoke> fan;|2: a rare contact: three wedges of one cell meet in one point'
  'relink|edits|lib/src/linking.cpp|!sameEnd(pool_[before], pool_[now])|sameEnd(pool_[before], pool_[now])|6: relinked successors are reported the wrong way round'
  'self-touch|polygons|lib/geometry/ring.h|segmentsMeet(a, b, |crossProperly(a, b, |7: a polygon whose vertex touches its own edge is accepted'
  'blame|polygons|lib/src/polygon.cpp|order[k - 1], order[k]};|order[k - 1], order[k] - 1};|7: a refusal names a vertex that is not repeated'
  'swallowed|polygons|lib/geometry/relation.h| \|\| sightOf(b, a).inside||7: a polygon around another is accepted'
  'executor|edits|lib/src/build.cpp|r.touching \|= touching;|r.touching = touching;|4: a build by an executor forgets all but the last corner touched'
  'round-trip|trace|oracle/trace/trace.cpp|"preserve {} {}\n", a, b)|"preserve {} {}\n", a, a)|trace: a pair that is preserved is printed wrong'
  'overlap|tiled|lib/tiled/src/placer.cpp|relation(part, shapes_[entries_[other].shape]) != Relation::apart|relation(part, shapes_[entries_[other].shape]) == Relation::inside|tiled: a polygon that sticks out of another one of its cell is taken for apart'
  'ghost|box2d|lib/box2d/src/edges.cpp|slot.edge.ghost1 == ghost1 \&\& slot.edge.ghost2 == ghost2|slot.edge.ghost1 == ghost1|box2d: a fixture keeps its second ghost'
)

seconds=60 out=out/canary
declare -A settings=([--seconds]=seconds [--out]=out)
source fuzz/options.sh
wanted=("${words[@]}")
if [[ ! $seconds =~ ^[0-9]+$ ]]; then
  echo "canary.sh: --seconds takes a number" >&2
  exit 2
fi
for name in "${wanted[@]}"; do
  [[ " ${bugs[*]%%|*} " == *" $name "* ]] || { echo "canary.sh: no bug $name; there are ${bugs[*]%%|*}" >&2; exit 2; }
done

mkdir -p "$out/logs"
out=$(cd "$out" && pwd)
rm -rf "$out/source"
mkdir "$out/source"
tar -c CMakeLists.txt cmake lib oracle bench cli fuzz LICENSE | tar -x -C "$out/source"
((seconds == 0)) || cmake -S "$out/source" -B "$out/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_COMPILER=clang++ -DLGS_BUILD_TESTS=OFF -DLGS_BUILD_FUZZERS=ON >/dev/null

# Parts of a line of `bugs`, at bars that no backslash precedes.
field() { perl -e 'my @f = split /(?<!\\)\|/, $ARGV[0], -1; $_ = $f[$ARGV[1]]; s/\\([|&])/$1/g; print' "$1" "$2"; }

# Whether the log of $name has the report of what was found, and names the trace if one is saved.
reported() {
  grep -q '^FINDING in ' "$out/logs/$name.log" || return 1
  ! compgen -G "$out/$name/*.trace" >/dev/null || grep -qE '^(trace|saved) .*\.trace$' "$out/logs/$name.log"
}

missed=0
for bug in "${bugs[@]}"; do
  name=$(field "$bug" 0) target=$(field "$bug" 1) file=$(field "$bug" 2)
  ((${#wanted[@]} == 0)) || [[ " ${wanted[*]} " == *" $name "* ]] || continue
  printf '%-18s' "$name"
  if ! FROM=$(field "$bug" 3) TO=$(field "$bug" 4) perl -0pi -e \
    'my $n = s/\Q$ENV{FROM}\E/$ENV{TO}/g; END { exit($n ? 0 : 1) }' "$out/source/$file"; then
    echo "DOES NOT APPLY to $file: mend fuzz/canary.sh"
    missed=1
    continue
  fi
  if ((seconds == 0)); then
    echo "applies to $file"
  elif ! cmake --build "$out/build" --target "fuzz_$target" lgs_fuzz >"$out/logs/$name-build.log" 2>&1; then
    echo "does not compile: $out/logs/$name-build.log"
    missed=1
  else
    rm -rf "${out:?}/$name" "$out/$name-corpus"
    mkdir "$out/$name" "$out/$name-corpus"  # what is new goes to the second, not into the project's corpus
    began=$SECONDS status=0 options=(-max_len=1024)
    [[ ! -e fuzz/dictionaries/$target.dict ]] ||
      options=(-max_len=4096 "-dict=fuzz/dictionaries/$target.dict" "$out/$name-corpus" "fuzz/corpus/$target")
    LGS_FUZZ_OUT=$out/$name LGS_FUZZ_SHRINK=5 "$out/build/fuzz/fuzz_$target" -seed=1 -max_total_time="$seconds" \
      -artifact_prefix="$out/$name/" "${options[@]}" >"$out/logs/$name.log" 2>&1 || status=$?
    input=$(sed -n 's/.*Test unit written to //p' "$out/logs/$name.log" | tail -n 1)
    if [[ -n $input ]] && ! compgen -G "$out/$name/*.trace" >/dev/null; then  # it crashed: shrunk in child processes
      "$out/build/fuzz/lgs_fuzz" report "$target" "$input" --out "$out/$name" >>"$out/logs/$name.log" 2>&1 || true
    fi
    if ((status == 0)) || [[ -z $(ls -A "$out/$name") ]]; then  # nothing saved: it failed otherwise
      echo "NOT FOUND in $seconds s, see $out/logs/$name.log: $(field "$bug" 5)"
      missed=1
    elif ! reported; then
      echo "found, but its report is lost: $out/logs/$name.log"
      missed=1
    else
      printf 'found in %3d s, shrunk to %s edits: %s\n' $((SECONDS - began)) \
        "$(cat "$out/$name/"*.trace 2>/dev/null | grep -cE '^(add|remove)')" "$(field "$bug" 5)"
    fi
  fi
  cp "$file" "$out/source/$file"
done
exit "$missed"
