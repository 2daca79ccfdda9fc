# Sourced by web.sh and test.sh, after steps.sh: sets the web side up, and builds package, sandbox and
# article.
# shellcheck shell=bash

build_web() {
  step web-setup "Set up the web's tools" scripts/web_setup.sh
  build web lgs_web lgs_web_full lgs_web_islands lgs_web_reference lgs_web_planted
  build web-small lgs_web lgs_web_oracle
  step web-package "Build the npm package" npm run build --prefix web/package
  step web-sandbox "Build the sandbox" npm run build --prefix web/sandbox
  step web-article "Build the article" npm run build --prefix web/article
  step web-api "Build the pages of the API" npm run api --prefix web/package
}
