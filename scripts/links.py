#!/usr/bin/env python3
"""Checks what the Markdown documents point at: links lead to files and headings, and files named in `code` exist.
Also, each page is linked from another one, and no line is wider than 120 characters (but rows of tables).

    scripts/links.py           # exit status 0: all is well; 1: what leads nowhere, with file and line

A word of `code`, or of a block of code, is taken for a file's name if it has a slash or ends as the project's sources
do. The name may be cut short from the left (`ground/grid.h`) or stand for several files (`*_test.cpp`). It may also lie in
a build folder: for `build/release/cli/lgs` the folder `cli/` must exist.
"""
import fnmatch
import pathlib
import re
import subprocess
import sys

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
UPWARD = re.compile(r"`(\.\./[\w./*-]+)`")  # a path from the page
NAME = re.compile(r"(?<![\w/.$:<>{}-])[A-Za-z_*][\w.*+-]*(?:/[\w.*+-]+)*/?(?![\w/<>{}(])")
# Names without a slash that are looked for. Those of traces, pictures and maps are mostly the reader's own.
SOURCE = re.compile(r".*\.(h|cpp|py|sh|md|toml|cmake)$")
# What is no file of the project: what running something makes, and what the reader is to fill in.
OTHER = re.compile(r"localgridseg\.(?:h|cpp)$|out/|build/bugs/|fuzz/all$|origin/|projects/localgridseg/|localgridseg/[\w-]+$|build/web|package/dist|sandbox/dist|dist/|.*/(?:NAME|name)\b")
WIDTH = 120
LICENCES = ["web/package/NOTICES.md"]  # texts of others, word for word
HEADING = re.compile(r"#+ +(.*?) *$")


def anchor(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-")


def tracked(root):
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root,
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0 and listed.stdout:
        return [pathlib.PurePosixPath(line) for line in listed.stdout.splitlines() if (root / line).is_file()]
    found = [path.relative_to(root) for path in root.rglob("*") if path.is_file()]  # an archive, no clone
    return [pathlib.PurePosixPath(path) for path in found if not {"build", "out", "node_modules"} & {*path.parts}]


def ends_of(files):
    """Every file and folder, whole and cut short from the left."""
    paths = {path for file in files for path in (file, *file.parents)}
    return {"/".join(path.parts[k:]) for path in paths for k in range(len(path.parts))}


def exists(name, ends):
    parts = name.rstrip("/").split("/")
    if parts[0] == "build":
        return len(parts) < 3 or parts[2] in ends  # build/PRESET/FOLDER/PROGRAM
    name = "/".join(parts)
    return name in ends or ("*" in name and any(fnmatch.fnmatchcase(end, name) for end in ends))


def prose_and_code(text):
    """The two halves of a document, each with the other's lines empty. Code is indented, or between fences."""
    prose, code, is_fenced = [], [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            is_fenced = not is_fenced
        is_code = is_fenced or bool(re.match(r"    [^ |*-]", line))
        prose.append("" if is_code else line)
        code.append(line if is_code else "")
    return "\n".join(prose), "\n".join(code)


def names_in(prose, code):
    """Each name of a file, with its line."""
    spans = [(code, 0)] + [(span[1], prose.count("\n", 0, span.start())) for span in CODE.finditer(prose)]
    for text, line in spans:
        for found in NAME.finditer(text):
            if ("/" in found[0] or SOURCE.match(found[0])) and not OTHER.match(found[0]):
                yield found[0], line + text.count("\n", 0, found.start()) + 1


def complaints(root, files):
    ends, linked = ends_of(files), {root / "README.md"}
    pages = [file for file in files if file.suffix == ".md"]
    for file in pages:
        text = (root / file).read_text(encoding="utf-8")
        prose, code = prose_and_code(text)
        found = []
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > WIDTH and not line.lstrip(" >").startswith("|") and str(file) not in LICENCES:
                found.append((number, f"the line has {len(line)} characters; {WIDTH} are allowed"))
        for link in LINK.finditer(prose):
            there = ((root / file).parent / link[1].partition("#")[0]).resolve()
            linked |= {there} - {(root / file).resolve()}
            fault = fault_of_link(root, file, link[1])
            if fault:
                found.append((prose.count("\n", 0, link.start()) + 1, f"{fault}: {link[1]}"))
        for upward in UPWARD.finditer(prose):
            if not any((root / file.parent).glob(upward[1])):
                found.append((prose.count("\n", 0, upward.start()) + 1, f"there is no such file: {upward[1]}"))
        for name, line in names_in(prose, code):
            if not exists(name, ends):
                found.append((line, f"there is no such file: {name}"))
        for line, complaint in sorted(found):
            yield f"{file}:{line}: {complaint}"
    for file in pages:
        if (root / file).resolve() not in linked:
            yield f"{file}:1: no other page links this one"


def fault_of_link(root, file, target):
    if re.match(r"[a-z]+:", target):
        return None
    path, _, fragment = target.partition("#")
    there = root / file.parent / path if path else root / file
    if not there.exists():
        return "the link leads nowhere"
    if fragment:
        headings = [HEADING.match(line) for line in there.read_text(encoding="utf-8").splitlines()]
        if fragment not in [anchor(heading[1]) for heading in headings if heading]:
            return "the link leads to no heading"
    return None


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    files = tracked(root)
    found = list(complaints(root, files))
    for complaint in found:
        print(complaint)
    if not found:
        print(f"links: all lead somewhere in {sum(file.suffix == '.md' for file in files)} documents")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
