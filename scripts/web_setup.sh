#!/usr/bin/env bash
# What the web side is built with, on Debian 12: the compiler for WebAssembly, Node, the sources that the importer needs,
# and the packages of web/package-lock.json. Only what is missing. With --compiler: what the module is compiled with, and
# no Node.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fetch_sources() {
  local sources=build/web-sources
  if [[ ! -e $sources/complete ]]; then
    rm -rf "$sources"
    scripts/debian_source.sh "$sources" pugixml zlib libzstd
    touch "$sources/complete"
  fi
}

# clang finds binaryen's wasm-opt by itself, and has it shrink the module: by 5 % with gzip.
packages=(binaryen bzip2 xz-utils clang-19 lld-19 llvm-19 libc++-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc)
if [[ ${1:-} == --compiler ]]; then
  scripts/setup.sh "${packages[@]}"
  fetch_sources
  exit 0
fi
# Node and Chromium may be here from elsewhere. Debian's npm would not install beside another Node.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
scripts/setup.sh "${packages[@]}"

if (($(node -p 'process.versions.node.split(".")[0]') < 18)); then
  echo "web_setup: Node 18 or newer is needed, and here is $(node --version)" >&2
  exit 1
fi
fetch_sources
# npm notes in node_modules what it has installed.
if [[ ! web/node_modules/.package-lock.json -nt web/package-lock.json ]]; then
  npm ci --prefix web --no-progress
fi
