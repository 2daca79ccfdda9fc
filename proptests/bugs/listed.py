"""The list of planted bugs: the *.toml files beside this one, one to each law or part of the project."""

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from workshop import ROOT


@dataclass(frozen=True)
class Group:
    title: str
    program: str  # that has the tests
    tests: tuple[str, ...]  # prefixes of GoogleTest names, those most to the point first


@dataclass(frozen=True)
class Bug:
    group: str
    name: str
    game: str  # what a game would suffer from it
    file: str
    find: str
    replace: str
    fuzz: str | None  # the fuzz target that must find it

    def change(self, text: str) -> str:
        return text.replace(self.find, self.replace)


def read_list() -> tuple[dict[str, Group], list[Bug]]:
    groups, bugs = {}, []
    for path in sorted(Path(__file__).parent.glob("*.toml")):
        listed = tomllib.loads(path.read_text())
        if "bug" not in listed:
            continue
        groups[path.stem] = Group(listed["law"], listed.get("program", "lgs_engine_tests"), tuple(listed["tests"]))
        for bug in listed["bug"]:
            file = bug["file"] if bug["file"].startswith(("addons/", "oracle/", "examples/")) else "lib/" + bug["file"]
            bugs.append(Bug(path.stem, bug["name"], bug.get("game", ""), file, bug["find"], bug["replace"],
                            bug.get("fuzz")))
    return groups, bugs


def tests_there() -> list[str]:
    """Names of tests as they stand in the sources."""
    names = re.compile(r"^(?:TEST|TEST_F|TEST_P|LGS_LAW)\((\w+),\s*(\w+)", re.M)
    sources = [*ROOT.glob("proptests/**/*.cpp"), *ROOT.glob("*/**/tests/**/*.cpp")]
    return [f"{suite}.{name}" for path in sources if "build" not in path.relative_to(ROOT).parts
            for suite, name in names.findall(path.read_text())]


def faults(groups: dict[str, Group], bugs: list[Bug]) -> list[str]:
    there = tests_there()
    found = [f"{group}.toml: no test begins with {prefix}" for group, listed in groups.items()
             for prefix in listed.tests if not any(test.startswith(prefix.rstrip("/").split("/")[-1]) for test in there)]
    for bug in bugs:
        what = f"{bug.group}: {bug.name}"
        path = ROOT / bug.file
        count = path.read_text().count(bug.find) if path.is_file() else 0
        if count != 1:
            found.append(f"{what}: to be found once in {bug.file}, found {count} times")
        if bug.find == bug.replace:
            found.append(f"{what}: changes nothing")
        if not bug.game:
            found.append(f"{what}: does not say what a game would suffer from it (game = '…')")
        if bug.fuzz and not (ROOT / "fuzz" / "corpus" / bug.fuzz).is_dir():
            found.append(f"{what}: there is no fuzz target {bug.fuzz}")
    names = [bug.name for bug in bugs]
    found += [f"{names.count(name)} bugs are called: {name}" for name in dict.fromkeys(names) if names.count(name) > 1]
    return found
