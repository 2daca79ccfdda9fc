#!/usr/bin/env bash
# How many edges of lib/ the committed corpus reaches: by targets, by files, and by parts, all targets together.
#
#   fuzz/coverage.sh [--build DIR] [CORPUS]
#
#   --build DIR  programs that are built already; default: builds the preset `fuzz` without the sanitizers, whose own
#                checks count as edges, in build/fuzz-coverage
#   CORPUS       a folder with one for each target; default fuzz/corpus
#
# A function that several targets reach counts as the one that reaches most of it does, so the sum is a lower bound.
# Exit status: 0 fine, 1 a program failed or has no edges, 2 bad usage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=
declare -A settings=([--build]=build)
source fuzz/options.sh
if ((${#words[@]} > 1)); then
  echo "coverage.sh: one corpus at a time; see --help" >&2
  exit 2
fi
corpus=${words[0]:-fuzz/corpus}
for folder in "$corpus" ${build:+"$build/fuzz"}; do
  [[ -d $folder ]] || { echo "coverage.sh: there is no folder $folder" >&2; exit 2; }
done
if [[ -z $build ]]; then
  build=build/fuzz-coverage
  cmake --preset fuzz -B "$build" -DLGS_SANITIZE= >/dev/null
  cmake --build "$build" --target fuzz/all
fi

found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
for program in "$build"/fuzz/fuzz_*; do
  target=${program##*/fuzz_}
  [[ -x $program ]] || { echo "coverage.sh: there is no program in $build/fuzz" >&2; exit 2; }
  [[ -d $corpus/$target ]] || { echo "coverage.sh: there is no folder $corpus/$target" >&2; exit 2; }
  LGS_FUZZ_OUT=$found "$program" -runs=0 -print_coverage=1 -artifact_prefix="$found/" "$corpus/$target" \
    >"$found/log" 2>&1 || { tail -n 20 "$found/log" >&2; echo "coverage.sh: $program failed" >&2; exit 1; }
  # COVERED_FUNC: hits: 5 edges: 3/7 name file:line
  sed -n 's/^.*COVERED_FUNC: hits: [0-9]* edges: \([0-9]*\)\/\([0-9]*\) \(.*\) [^ ]*\/\(lib\/\(include\|geometry\|storage\|ground\|outline\|world\|tiled\|box2d\)\/[^ :]*\):[0-9]*$/\1\t\2\t\4\t\3/p' \
    "$found/log" >"$found/$target.edges"
  [[ -s $found/$target.edges ]] ||
    { echo "coverage.sh: $program counts no edges of lib/; was it built for libFuzzer, with -g1?" >&2; exit 1; }
  awk -F'\t' -v t="$target" -v inputs="$(find "$corpus/$target" -type f | wc -l)" \
    -v bytes="$(cat "$corpus/$target"/* | wc -c)" '{ hit += $1; all += $2 }
      END { printf "%-10s %5d inputs %7d bytes %6d of %6d edges of lib/\n", t, inputs, bytes, hit, all }' \
    "$found/$target.edges"
done

echo
awk -F'\t' '
  { key = $3 "\t" $4; if ($2 > all[key]) all[key] = $2; if ($1 > hit[key]) hit[key] = $1 }
  function line(hits, edges, what) { return sprintf("%5d of %5d  %3d%%  %s", hits, edges, 100 * hits / edges, what) }
  END {
    for (key in all) {
      split(key, words, "\t"); file = words[1]
      part = file ~ /^lib\/tiled/ ? "tiled" : file ~ /^lib\/box2d/ ? "box2d" : "engine"
      H[file] += hit[key]; N[file] += all[key]; h[part] += hit[key]; n[part] += all[key]
    }
    for (file in N) print line(H[file], N[file], file) | "sort -k5"
    close("sort -k5")
    print ""
    for (part in n) { print line(h[part], n[part], part) | "sort -k5"; total += n[part]; reached += h[part] }
    close("sort -k5")
    print line(reached, total, "all of lib/")
  }' "$found"/*.edges
