#!/usr/bin/env bash
# The sandbox, from a fresh clone: installs what is missing (Debian 12), builds the npm package and the sandbox, and
# serves the sandbox on localhost until it is stopped with Ctrl+C. PORT=8080 ./web.sh takes another port.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source scripts/steps.sh
source scripts/web_steps.sh

build_web
printf '\n'
exec node web/sandbox/serve.js "${PORT:-8000}"
