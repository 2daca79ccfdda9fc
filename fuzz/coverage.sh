#!/usr/bin/env bash
# How much of lib/ the committed corpus reaches: by files, by targets, and by parts, all targets together.
#
#   fuzz/coverage.sh [--build DIR] [--lines FILE] [CORPUS]
#
#   --build DIR   where lgs_fuzz is built, or built already, with clang's source-based coverage; default
#                 build/fuzz-coverage
#   --lines FILE  where to write the sources with how often each line and branch was run; default
#                 out/fuzz-coverage.txt
#   CORPUS        a folder with an archive or a folder for each target; default fuzz/corpus
#
# What is counted is branches: the two ways out of each condition in the source, so `a && b` has four. These are the
# edges of the control flow where it parts. A branch is reached if any target reaches it; one in a template counts once,
# however often the template is used. Assertions are off (NDEBUG): no input can make one of them fail.
# Needs clang, llvm-profdata and llvm-cov. Exit status: 0 fine, 1 something failed, 2 bad usage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/fuzz-coverage lines=out/fuzz-coverage.txt
declare -A settings=([--build]=build [--lines]=lines)
source fuzz/options.sh
if ((${#words[@]} > 1)); then
  echo "coverage.sh: one corpus at a time; see --help" >&2
  exit 2
fi
corpus=${words[0]:-fuzz/corpus}
[[ -d $corpus ]] || { echo "coverage.sh: there is no folder $corpus" >&2; exit 2; }
cmake --preset fuzz -B "$build" -DLGS_SANITIZE= '-DLGS_FUZZ_COVERAGE=-fprofile-instr-generate;-fcoverage-mapping' \
  -DCMAKE_CXX_FLAGS_DEBUG='-O1 -g1 -DNDEBUG' >/dev/null
cmake --build "$build" --target lgs_fuzz

found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
program=$build/fuzz/lgs_fuzz
tool() { "$(clang++ -print-prog-name="$1")" "${@:2}"; }  # of the compiler's own version

# report NAME: a line for each file of lib/ with the branches that the profile NAME reaches, and has: "12 34 lib/…".
report() {
  tool llvm-cov report "$program" -instr-profile="$found/$1.profdata" -show-branch-summary |
    awk -v root="$PWD/" '{ file = $1; sub(root, "", file) } file ~ /^lib\// { print $(NF - 2) - $(NF - 1), $(NF - 2), file }'
}

for inputs in "$corpus"/*; do
  target=$(basename "$inputs" .tar)
  LLVM_PROFILE_FILE=$found/$target.profraw "$program" run "$target" "$inputs" --out "$found" >"$found/log" 2>&1 ||
    { tail -n 20 "$found/log" >&2; echo "coverage.sh: $target failed" >&2; exit 1; }
  tool llvm-profdata merge -o "$found/$target.profdata" "$found/$target.profraw"
  report "$target" >"$found/$target.files"
  awk -v t="$target" -v inputs="$(sed -n 's/^inputs *//p' "$found/log")" \
    '{ hit += $1 } END { printf "%-10s %5d inputs %6d branches of lib/\n", t, inputs, hit }' \
    "$found/$target.files"
done
tool llvm-profdata merge -o "$found/all.profdata" "$found"/*.profraw
mkdir -p "$(dirname "$lines")"
tool llvm-cov show "$program" -instr-profile="$found/all.profdata" -show-branches=count >"$lines"

echo
report all | awk '
  function line(hit, of, what) { return sprintf("%5d of %5d  %3.0f%%  %s", hit, of, 100 * hit / of, what) }
  $2 > 0 {
    part = "engine"
    if ($3 ~ /^lib\/tiled/) part = "importer"
    if ($3 ~ /^lib\/box2d/) part = "terrain for Box2D"
    if ($3 ~ /^lib\/brush/) part = "brushes"
    if ($3 ~ /^lib\/(views|pieces)/) part = "views"
    if ($3 ~ /^lib\/(falling|debug)/) part = "falling ground, debug"
    print line($1, $2, $3) | "sort -k5"
    h[part] += $1; n[part] += $2; hits += $1; all += $2
  }
  END {
    close("sort -k5")
    print ""
    for (part in n) print line(h[part], n[part], part) | "sort -k5"
    close("sort -k5")
    print line(hits, all, "all of lib/")
  }'
