#!/usr/bin/env bash
# The committed corpora: fuzz/corpus/TARGET.tar, an archive for each target, made so that equal inputs give equal bytes.
#
#   fuzz/corpus.sh merge TARGET [FOLDER...]   what run.sh kept (out/fuzz/corpus/TARGET), or FOLDER, joins the archive: as
#                                             few inputs as can be that reach the same edges; builds the preset `fuzz`
#   fuzz/corpus.sh add TARGET FILE...         these inputs join as they are
#   tar -xf fuzz/corpus/TARGET.tar            takes one apart
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
(($# >= 2)) || { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' fuzz/corpus.sh; exit 2; }
command=$1 target=$2 archive=fuzz/corpus/$2.tar
shift 2
all=$(mktemp -d)
trap 'rm -rf "$all"' EXIT
mkdir "$all/old" "$all/new"
[[ ! -e $archive ]] || tar -xf "$archive" -C "$all/old"

case $command in
  merge)
    (($#)) || set -- "out/fuzz/corpus/$target"
    cmake --preset fuzz >/dev/null
    cmake --build --preset fuzz --target "fuzz_$target"
    "build/fuzz/fuzz/fuzz_$target" -set_cover_merge=1 -use_counters=0 -max_len=4096 "$all/new" "$all/old" "$@"
    ;;
  add)
    for file in "$all"/old/* "$@"; do
      [[ ! -f $file ]] || cp "$file" "$all/new/$(sha1sum <"$file" | cut -d ' ' -f 1)"
    done
    ;;
  *) echo "corpus.sh: there is no command $command" >&2; exit 2 ;;
esac
(cd "$all/new" && printf '%s\n' * | LC_ALL=C sort) |
  tar -cf "$archive" -C "$all/new" --files-from - --format=ustar --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=0644
echo "$archive: $(tar -tf "$archive" | wc -l) inputs"
