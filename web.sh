#!/usr/bin/env bash
# The sandbox and the article, from a fresh clone: installs what is missing (Debian 12), builds the npm package and both
# pages, and serves them on localhost until it is stopped with Ctrl+C. PORT=8080 ./web.sh takes another port.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
source scripts/web_steps.sh

build_web
printf '\n'
exec node web/sandbox/serve.js "${PORT:-8000}"
