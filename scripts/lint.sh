#!/usr/bin/env bash
# Checks the style of all C++ files with clang-format, and the code with clang-tidy, on a build with assertions. Installs
# what is missing. With nothing to complain about it exits with status 0.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'END'
usage: scripts/lint.sh [--format] [--since REV]

  --format     clang-format only, which takes seconds; clang-tidy takes most of an hour
  --since REV  only the files that were changed since this commit, the uncommitted ones included. A header that was
               changed is looked at from the source files of the same folder that include it.
END
}

since= tidy=1
while (($# > 0)); do
  case $1 in
    --format) tidy= ;;
    --since) since=${2:?"--since needs a commit"} && shift ;;
    --help | -h) usage && exit 0 ;;
    *) usage >&2 && exit 2 ;;
  esac
  shift
done

scripts/setup.sh clang-format clang-tidy
if [[ $since ]]; then
  git rev-parse --verify --quiet "$since^{commit}" >/dev/null || { echo "lint: there is no commit '$since'" >&2 && exit 2; }
  mapfile -t files < <({ git diff --name-only --diff-filter=d "$since" && git ls-files --others --exclude-standard; } |
    grep -E '\.(h|cpp)$' | sort -u)
else
  mapfile -t files < <(git ls-files '*.h' '*.cpp')
fi
if ((${#files[@]} == 0)); then
  echo "lint: no C++ file was changed since $since"
  exit 0
fi
clang-format --dry-run -Werror "${files[@]}"
echo "lint: clang-format is content with ${#files[@]} files"
[[ $tidy ]] || exit 0

# A source file that no target of this build compiles (the adapter for the other Box2D) has no entry, and is left out.
cmake --preset debug -DLGS_BENCH_OTHERS=ON >/dev/null
cmake --build --preset debug --target readme_example readme_going_back >/dev/null  # a source that the build makes
sources() {
  local file
  for file in "$@"; do
    [[ $file == *.cpp ]] && echo "$file"
    [[ $file == *.h ]] && { grep -l "$(basename "$file")" "$(dirname "$file")"/*.cpp 2>/dev/null || true; }
  done | sort -u
}
compiled=$(python3 -c "import json; print('\n'.join(e['file'] for e in json.load(open('build/debug/compile_commands.json'))))")
mapfile -t sources < <(sources "${files[@]}" | while read -r file; do
  grep -qxF "$PWD/$file" <<<"$compiled" && echo "$file"
done)
echo "lint: clang-tidy looks at ${#sources[@]} source files and the headers that they include"
printf '%s\0' "${sources[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/debug --quiet --warnings-as-errors='*'
echo "lint: clang-tidy is content"
