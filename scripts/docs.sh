#!/usr/bin/env bash
# Writes the documentation of all public headers, as web pages: scripts/docs.sh [FOLDER], by default out/docs. It needs
# Doxygen (Debian: doxygen). A public name without a comment is an error, and so is a comment that Doxygen can not read.
set -euo pipefail
out=$(realpath -m "${1:-$(dirname "$0")/../out/docs}")
cd "$(dirname "$0")/.."
mkdir -p "$out"

# The first page: how the README begins, up to its example and what that prints. Links to files lose their address, since
# these are not part of the pages.
{
  echo '# LocalGridSeg {#mainpage}'
  echo
  echo 'Where to begin: lgs::World, or lgs/lgs.h in C; lgs::paint() and lgs::carve(); lgs::tiled::importMap();'
  echo 'lgs::box2d::Terrain; lgs::writeSvg(). docs/contract.md has the words and the laws that all of it goes by.'
  echo
  sed -n '3,/^## How fast/p' README.md | sed '/^## How fast/d' |
    sed -E 's/(^|[^!])\[([^]]*)\]\([^)#]*\.(md|h|cpp)(#[^)]*)?\)/\1\2/g; s/\]\(docs\//](/g'
} >"$out/main.md"

{
  cat scripts/Doxyfile
  echo "PROJECT_NUMBER = $(sed -n 's/^project(LocalGridSeg VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
  echo "OUTPUT_DIRECTORY = $out"
  echo "INPUT += $out/main.md"
  echo "USE_MDFILE_AS_MAINPAGE = $out/main.md"
  echo "IMAGE_PATH = docs"
} >"$out/Doxyfile"
doxygen "$out/Doxyfile"
echo "docs: $out/html/index.html"
