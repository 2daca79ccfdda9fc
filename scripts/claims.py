#!/usr/bin/env python3
"""Checks what the Markdown documents claim: counts and lists against what is there, figures against their commit.

    scripts/claims.py           # exit status 0: all is well; 1: what does not hold, with file and line
    scripts/claims.py --write   # first writes the counted blocks anew, and the rows of planted bugs
    scripts/claims.py --test    # each check finds what it is for, planted in a folder of its own

- No line is wider than 120 characters. Rows of tables may be, and so may the texts of licences.
- Each page is linked from another page.
- Between <!-- counted: NAME --> and <!-- end --> stands what scripts/counts.py says, to the letter.
- A list in a page names all that it is about, and nothing else (LISTS in scripts/counts.py).
- <!-- figures: NAME commit=HASH paths=A,B within=N% --> says that the figures up to <!-- end --> are of that commit,
  and that they speak for the code below these paths until N lines of a hundred have changed there. After that the text
  before <!-- end --> must say "Older than the code", and only then. Where the history is not there (an archive, a
  shallow clone), this can not be seen: the script says so, and goes on.
"""
import argparse
import pathlib
import re
import subprocess
import sys

import counts
from links import LINK, prose_and_code, tracked

WIDTH = 120
LICENCES = {"web/package/NOTICES.md"}  # texts of others, word for word
COUNTED = re.compile(r"(<!-- counted: ([\w-]+) -->\n)(.*?)(<!-- end -->)", re.S)
FIGURES = re.compile(r"<!-- figures: (\S+) commit=(\w+) paths=(\S+) within=(\d+)% -->(.*?)<!-- end -->", re.S)
MARKER = re.compile(r"<!-- (?:counted|figures)\b.*")
OLD = "Older than the code"


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def wide_lines(pages):
    for page, text in pages.items():
        for number, line in enumerate(text.splitlines(), 1):
            if len(line) > WIDTH and not line.lstrip(" >").startswith(("|", "<!-- figures")) and page not in LICENCES:
                yield f"{page}:{number}: the line has {len(line)} characters; {WIDTH} are allowed"


def lonely_pages(root, pages):
    linked = set()
    for page, text in pages.items():
        for link in LINK.finditer(prose_and_code(text)[0]):
            target = (root / page).parent / link[1].partition("#")[0]
            linked |= {target.resolve()} - {(root / page).resolve()}
    for page in pages:
        if page != "README.md" and (root / page).resolve() not in linked:
            yield f"{page}:1: no other page links this one"


def wrong_counts(root, pages):
    for page, text in pages.items():
        for block in COUNTED.finditer(text):
            if block[2] not in counts.BLOCKS:
                yield f"{page}:{line_of(text, block.start())}: nothing counts '{block[2]}'"
            elif block[3] != counts.BLOCKS[block[2]](root):
                yield f"{page}:{line_of(text, block.start())}: '{block[2]}' is not what is there: claims.py --write"


def wrong_lists(root, pages):
    for page, what, listed, there in counts.lists(root, pages):
        for name in sorted(there - listed):
            yield f"{page}:1: of {what}, it does not name {name}"
        for name in sorted(listed - there):
            yield f"{page}:1: of {what}, it names {name}, which is not there"


def git(root, *words):
    done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else None


def history(root):
    """Why the history can not be asked, or None if it can."""
    if git(root, "rev-parse", "--git-dir") is None or git(root, "rev-parse", "--show-cdup") != "":
        return "this is no clone"
    return "this is a shallow clone" if git(root, "rev-parse", "--is-shallow-repository") == "true" else None


def changed_part(root, commit, paths):
    """How many lines of a hundred have changed below the paths since that commit; None if it is not in the history."""
    if git(root, "merge-base", "--is-ancestor", commit, "HEAD") is None:
        return None
    rows = [row.split("\t") for row in (git(root, "diff", "--numstat", commit, "--", *paths) or "").splitlines()]
    changed = sum(max(int(added), int(removed)) for added, removed, _ in rows if added != "-")
    files = (git(root, "ls-files", "--", *paths) or "").splitlines()
    lines = sum((root / file).read_bytes().count(b"\n") for file in files if (root / file).is_file())
    return 100 * changed / max(lines, 1)


def old_figures(root, pages):
    for page, text in pages.items():
        for block in FIGURES.finditer(text):
            name, commit, paths, within = block[1], block[2], block[3].split(","), int(block[4])
            where = f"{page}:{line_of(text, block.start())}"
            part = changed_part(root, commit, paths)
            if part is None:
                yield f"{where}: the figures '{name}' name commit {commit}, which is not in this history"
            elif part > within and OLD not in block[5]:
                yield (f"{where}: the figures '{name}' are of commit {commit}; {part:.0f} lines of a hundred have "
                       f"changed since below {' '.join(paths)}, and {within} may: measure again, or say '{OLD}'")
            elif part <= within and OLD in block[5]:
                yield f"{where}: the figures '{name}' are no older than is allowed, but the page says '{OLD}'"


def broken_markers(pages):
    for page, text in pages.items():
        good = {match.start() for form in (COUNTED, FIGURES) for match in form.finditer(text)}
        for marker in MARKER.finditer(text):
            if marker.start() not in good:
                yield f"{page}:{line_of(text, marker.start())}: a marker that can not be read, or has no end"


def pages_of(root):
    return {str(file): (root / file).read_text(encoding="utf-8") for file in tracked(root) if file.suffix == ".md"}


def complaints(root):
    pages = pages_of(root)
    yield from wide_lines(pages)
    yield from lonely_pages(root, pages)
    yield from broken_markers(pages)
    yield from wrong_counts(root, pages)
    yield from wrong_lists(root, pages)
    if history(root) is None:
        yield from old_figures(root, pages)


def write(root):
    """Writes the counted blocks anew, and returns the pages that changed. New planted bugs get their rows first."""
    listing = root / "proptests/bugs/run.py"
    if listing.is_file():
        subprocess.run([sys.executable, listing, "--list", "--report", root / counts.BUGS_PAGE], check=False,
                       stdout=subprocess.DEVNULL)
    changed = []
    for page, text in pages_of(root).items():
        new = COUNTED.sub(lambda m: m[1] + (counts.BLOCKS[m[2]](root) if m[2] in counts.BLOCKS else m[3]) + m[4], text)
        if new != text:
            (root / page).write_text(new, encoding="utf-8")
            changed.append(page)
    return changed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="write the counted blocks anew")
    parser.add_argument("--test", action="store_true", help="check the checks: plant what each must find")
    arguments = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    if arguments.test:
        import claims_test
        return claims_test.run()
    if arguments.write:
        for page in write(root):
            print(f"claims: {page} is written anew")
    found = list(complaints(root))
    print(*found, sep="\n", end="\n" if found else "")
    if (reason := history(root)) is not None:
        print(f"claims: {reason}, so the age of figures was not looked at")
    if not found:
        print(f"claims: all hold in {len(pages_of(root))} documents")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
