#!/usr/bin/env bash
# How many edges of lib/ the committed corpus reaches, file by file; all targets together and each by itself.
#
#   fuzz/coverage.sh [--build DIR] [CORPUS]      default: the preset `fuzz`, fuzz/corpus
#
# Edges are those of the build that is used. A function that several targets reach counts as the one that reaches most of
# it does, so the sum is a lower bound.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=
if [[ ${1:-} == --build ]]; then build=$2; shift 2; fi
corpus=${1:-fuzz/corpus}
if [[ -z $build ]]; then
  build=build/fuzz
  cmake --preset fuzz >/dev/null
  cmake --build --preset fuzz >/dev/null
fi
lists=()
trap 'rm -f "${lists[@]}"' EXIT
for program in "$build"/fuzz/fuzz_*; do
  target=${program##*/fuzz_}
  list=$(mktemp)
  lists+=("$list")
  # COVERED_FUNC: hits: 5 edges: 3/7 name file:line
  "$program" -runs=0 -print_full_coverage=0 -print_coverage=1 "$corpus/$target" 2>&1 |
    sed -n "s/^.*COVERED_FUNC: hits: [0-9]* edges: \([0-9]*\)\/\([0-9]*\) \(.*\) [^ ]*\/\(lib\/\(include\|src\|tiled\|box2d\)\/[^ :]*\):[0-9]*$/\1\t\2\t\4\t\3/p" >"$list"
  awk -F'\t' -v t="$target" '{ c += $1; n += $2 } END { printf "%-10s %6d of %6d edges of lib/\n", t, c, n }' "$list"
done
echo
cat "${lists[@]}" | awk -F'\t' '
  { key = $3 "\t" $4; if (!(key in total) || $2 > total[key]) total[key] = $2; if ($1 > hit[key]) hit[key] = $1 }
  END { for (key in total) { split(key, part, "\t"); h[part[1]] += hit[key]; n[part[1]] += total[key] }
        for (file in n) { printf "%5d of %5d  %3d%%  %s\n", h[file], n[file], 100 * h[file] / n[file], file; H += h[file]; N += n[file] }
        printf "%5d of %5d  %3d%%  all of lib/\n", H, N, 100 * H / N }' | sort -k5
