#!/usr/bin/env bash
# Reads lib/ as Microsoft's compiler would: clang-cl for x86_64-pc-windows-msvc with /W4 checks the engine, the brushes,
# the debug writer and the C interface. It compiles nothing. Its headers are those of mingw-w64, which were not made for
# it; what it says about them is left out.
#
#   scripts/clang_cl.sh    # exit status 0: nothing to say about lib/; 1: what there is
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/setup.sh clang-19 g++-mingw-w64-x86-64-posix >&2 || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tl"
cp /usr/include/tl/expected.hpp "$work/tl" || exit 1
printf '#include "%s"\n' "$PWD"/lib/{geometry,storage,ground,outline,world,brush/src}/*.cpp >"$work/engine.cpp"  # at once, as in the amalgamation

options=(--driver-mode=cl --target=x86_64-pc-windows-msvc -fsyntax-only -ferror-limit=0 /std:c++20 /W4 /EHs-c- /GR-
         -D LGS_BUILDS_SHARED -I lib -imsvc "$work")
for folder in lib/{,brush/,c/,debug/}include; do options+=(-I "$folder"); done
while read -r folder; do options+=(-imsvc "$folder"); done < <(
  x86_64-w64-mingw32-g++-posix -x c++ -E -v /dev/null 2>&1 >/dev/null | sed -n '/^#include </,/^End/s/^ //p')
found=0
for file in "$work/engine.cpp" addons/debug/src/*.cpp addons/c/src/*.cpp; do
  said=$(clang-19 "${options[@]}" -- "$file" 2>&1 | grep -E "^($PWD/)?lib/.*(error|warning):")
  [[ $said ]] && echo "$said" && found=1
done
((found)) || echo "clang-cl: nothing to say about lib/"
exit "$found"
