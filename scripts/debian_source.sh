#!/usr/bin/env bash
# Fetches the source of Debian packages, as it was before Debian's changes, and unpacks it: FOLDER/NAME-VERSION.
# For code that is built for other machines than Debian's. Needs no root; apt-get checks the signatures.
#   scripts/debian_source.sh FOLDER PACKAGE...
set -euo pipefail
folder=$(realpath -m "$1")
shift
lists=$folder/apt
mkdir -p "$lists/sources" "$lists/lists/partial" "$lists/cache/archives/partial"

# Where this system has its packages from, there it has their sources from.
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  if [[ -f $file ]]; then sed -n 's/^deb /deb-src /p' "$file" >"$lists/sources/$(basename "$file" .list).list"; fi
done
for file in /etc/apt/sources.list.d/*.sources; do
  if [[ -f $file ]]; then sed 's/^Types: .*/Types: deb-src/' "$file" >"$lists/sources/$(basename "$file")"; fi
done
apt=(apt-get -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$lists/sources"
  -o "Dir::State::lists=$lists/lists" -o "Dir::Cache=$lists/cache" -o "APT::Sandbox::User=$(id -un)")
"${apt[@]}" update
cd "$folder"
# A mirror may list an update before it has its files. What is the same before Debian's changes is in the release, too.
release=$(source /etc/os-release && echo "${VERSION_CODENAME:-}")
"${apt[@]}" source --download-only "$@" || "${apt[@]}" source --download-only "${@/%//$release}"
for archive in *.orig.tar.*; do
  if [[ $archive != *.asc ]]; then tar xf "$archive"; fi
done
rm -rf "$lists"
