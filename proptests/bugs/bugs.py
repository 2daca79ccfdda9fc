"""The lists of planted bugs. CONTRIBUTING.md says how a bug is written.

    bugs.py NAME FOLDER    writes the file that has the bug of this name into the folder, with the bug
"""

import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


LISTS = ("proptests/bugs/*.bugs", "addons/*/*.bugs", "web/package/*.bugs")


class Wrong(Exception):
    """The list is at fault, or the code is as it stands: nothing can be tried."""


@dataclass(frozen=True)
class Group:
    title: str
    program: str  # that has the tests; "node" runs those of the npm package; "lgs" checks, or replays traces
    tests: tuple[str, ...]  # how their names begin, those most to the point first
    each: bool  # whether each of them must find it, not only one


@dataclass(frozen=True)
class Bug:
    list: str  # the file that lists it, without its ending
    group: Group
    file: str
    name: str
    fuzz: str | None  # the fuzz target that must find it, too
    changes: tuple[tuple[str, str], ...]  # text, and what stands there instead

    def __str__(self) -> str:
        return f"{self.list}: {self.name}"

    def plant(self, text: str) -> str:
        for find, replace in self.changes:
            places = list(re.finditer(r"\s+".join(map(re.escape, find.split())), text))
            if len(places) != 1:
                raise Wrong(f"{self}: to be found once in {self.file}, found {len(places)} times: {find}")
            text = text[:places[0].start()] + laid_out(places[0][0], replace) + text[places[0].end():]
        return text


def laid_out(found: str, replace: str) -> str:
    """The replacement, with the line breaks of what was found where both begin and end with the same words."""
    old, new = re.findall(r"\s*\S+", " " + found), replace.split()
    same = [word.strip() for word in old]
    head = len(os.path.commonprefix([same, new]))
    tail = len(os.path.commonprefix([same[head:][::-1], new[head:][::-1]]))
    middle = " ".join(new[head:len(new) - tail])
    blank = re.match(r"\s*", old[head])[0] if head < len(old) else " "
    return "".join([*old[:head], blank + middle if middle else "", *old[len(old) - tail:]]).strip()


def read_all() -> list[Bug]:
    paths = [path for pattern in LISTS for path in sorted(ROOT.glob(pattern))]
    return [bug for path in paths for bug in read(path.stem, path.read_text())]


def read(name: str, text: str) -> list[Bug]:
    """A line says by its indentation what it is: a file, a bug in it, a substitution."""
    bugs: list[Bug] = []
    title, group, file, bug = "", None, "", None
    for number, line in enumerate(text.splitlines(), 1):
        depth, words = len(line) - len(line.lstrip()), line.strip()
        if not words:
            continue
        if words.startswith("# ") and not depth:
            title, group, file, bug = words[2:], None, "", None
        elif title and not group:
            said = re.fullmatch(r"found by( each)?: (\S+) (.+)", words)
            if not said:
                raise Wrong(f"{name}.bugs:{number}: not 'found by: PROGRAM TESTS': {line}")
            group = Group(title, said[2], tuple(said[3].split()), bool(said[1]))
        elif group and not depth:
            file, bug = words, None
        elif file and depth == 2:
            said = re.fullmatch(r"(.*?)(?: \[fuzz (\w+)\])?", words)
            bug = Bug(name, group, file, said[1], said[2], ())
            bugs.append(bug)
        elif bug and depth == 4 and " ==>" in line:
            find, _, replace = words.partition(" ==>")
            bug = bugs[-1] = Bug(name, group, file, bug.name, bug.fuzz, (*bug.changes, (find, replace.strip())))
        else:
            raise Wrong(f"{name}.bugs:{number}: neither title, file, bug (2 blanks) nor TEXT ==> TEXT (4): {line}")
    return bugs


ROOMS = ("proptests", "addons", "oracle", "cli", "bench", "examples", "packaging")  # that have tests
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|LGS_LAW)\((\w+),\s*(\w+)", re.M)


def faults(bugs: list[Bug]) -> list[str]:
    """What is wrong with the list, as far as it can be told without building anything."""
    there = {"check", *(path.stem for path in (ROOT / "proptests/regressions").glob("*.trace"))}
    there |= {path.name for path in (ROOT / "web/package/test").glob("*.test.js")}
    there |= {f"{suite}.{name}" for room in ROOMS for path in (ROOT / room).rglob("*.cpp")
              for suite, name in TEST.findall(path.read_text())}
    found = []
    for group in dict.fromkeys(bug.group for bug in bugs):
        for prefix in group.tests:
            begin = prefix.rstrip("/").split("/")[-1].partition(":")[0]
            if not any(test.startswith(begin) for test in there):
                found.append(f"{group.title}: no test begins with {prefix}")
    for bug in bugs:
        try:
            text = (ROOT / bug.file).read_text()
            if bug.plant(text) == text:
                found.append(f"{bug}: changes nothing")
        except (OSError, Wrong) as error:
            found.append(str(error))
        if bug.fuzz and not (ROOT / "fuzz" / "corpus" / f"{bug.fuzz}.tar").is_file():
            found.append(f"{bug}: there is no fuzz target {bug.fuzz}")
    names = [bug.name for bug in bugs]
    twice = [name for name in dict.fromkeys(names) if names.count(name) > 1]
    return found + [f"{names.count(name)} bugs are called: {name}" for name in twice]


def write(name: str, folder: str) -> None:
    bug = next(bug for bug in read_all() if bug.name == name)
    target = Path(folder) / bug.file
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(bug.plant((ROOT / bug.file).read_text()))


if __name__ == "__main__":
    write(*sys.argv[1:])
