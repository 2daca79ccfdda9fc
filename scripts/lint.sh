#!/usr/bin/env bash
# Checks the style of all C++ files with clang-format, and the code with clang-tidy, on a build with assertions.
# Installs what is missing. With nothing to complain about it exits with status 0.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'END'
usage: scripts/lint.sh [--format] [--since REV]

  --format     clang-format only, which takes seconds; clang-tidy takes a quarter of an hour
  --since REV  only the files that were changed since this commit, the uncommitted ones included. A header that was
               changed is looked at from the source files that include it: those of its folder, or else all.
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

# A source file that no target of this build compiles (the adapter for the other Box2D) is left out. All files together
# are looked at in the batches of a unity build, so that a header is read once for several of them. A batch includes
# source files, which is no fault here. Precompiled headers are those of g++, which clang-tidy can not read.
unity=OFF
[[ $since ]] || unity=ON
cmake --preset debug -B build/lint -DLGS_BENCH_OTHERS=ON -DCMAKE_UNITY_BUILD="$unity" \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
cmake --build build/lint --target readme_example readme_dig readme_rollback >/dev/null  # sources that the build makes
compiled=$(python3 -c 'if 1:
  import json
  print(*sorted({entry["file"] for entry in json.load(open("build/lint/compile_commands.json"))}), sep="\n")')

including() {
  local line="#include [<\"](.*/)?$(basename "$1")[>\"]"
  git grep -lE "$line" -- "$(dirname "$1")/*.cpp" || git grep -lE "$line" -- '*.cpp' || true
}
wanted() {
  local file
  for file in "${files[@]}"; do
    if [[ $file == *.cpp ]]; then echo "$file"; else including "$file"; fi
  done | sort -u | sed "s|^|$PWD/|" | grep -xFf <(echo "$compiled") || true
}
if [[ $since ]]; then mapfile -t sources < <(wanted); else mapfile -t sources < <(grep -v cmake_pch <<<"$compiled"); fi
echo "lint: clang-tidy looks at ${#sources[@]} source files and what they include"
printf '%s\0' "${sources[@]}" | xargs -0 -r -n 1 -P "$(nproc)" \
  clang-tidy -p build/lint --quiet --checks=-bugprone-suspicious-include --warnings-as-errors='*'

# What is for WebAssembly alone is compiled by clang 19, with the headers of its library: an older one can not read them.
# The headers of lib/ are looked at above. Initializers that it calls redundant silence a warning of compilers.
if printf '%s\n' "${files[@]}" | grep -q '^web/wasm/'; then
  scripts/setup.sh clang-tidy-19
  scripts/web_setup.sh --compiler
  cmake --preset web >/dev/null
  echo "lint: clang-tidy 19 looks at web/wasm"
  printf '%s\0' web/wasm/*.cpp | xargs -0 -n 1 -P "$(nproc)" clang-tidy-19 -p build/web --quiet \
    --checks=-readability-redundant-member-init --header-filter='/web/wasm/' --warnings-as-errors='*'
fi
echo "lint: clang-tidy is content"
