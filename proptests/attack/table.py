#!/usr/bin/env python3
"""The doors: every public function of C++, C and JavaScript is attacked with hostile values. Exit status 1 if one is not.

The functions are those of the headers and of the package's sources (declared.py). Those of C++ and C need a door() in
proptests/attack; web/package/test/attack goes through all of JavaScript. doors.txt has the few that a test tries instead.
"""
import re
import sys

import declared
from declared import ROOT

ATTACK = ROOT / "proptests" / "attack"


def excepted():
    """What doors.txt has: a function by interface and name, and the test that tries it. Types of JavaScript have bars, too."""
    text = (ATTACK / "doors.txt").read_text(encoding="utf-8")
    rows = re.findall(r"^(?!#)(\S+) \| (.*) \| (\S+)$", text, re.M)
    return {(interface, name): test for interface, name, test in rows}


def attacked():
    """The doors of the attack."""
    text = "".join(path.read_text(encoding="utf-8") for folder in (ATTACK, ROOT / "addons")
                   for path in sorted(folder.rglob("doors_*.cpp")))
    return set(re.findall(r'\bdoor\(\s*"([^"]+)"', text))


def tests():
    names = {path.name for path in (ROOT / "web" / "package" / "test").glob("*.test.js")}
    names |= {path.name for path in (ROOT / "addons/c/tests").glob("*_test.c")}
    for path in (path for folder in ("proptests", "addons") for path in (ROOT / folder).rglob("*_test.cpp")):
        text = path.read_text(encoding="utf-8")
        names |= {".".join(pair) for pair in re.findall(r"^(?:TEST|TEST_F|TEST_P|LGS_LAW)\((\w+),\s*(\w+)", text, re.M)}
    return names


# What is there to be left half changed. When memory runs out the program ends; an exception would go on with it.
STATE = "World Transaction Loops Islands Pieces GroundHashes Terrain TerrainBase"


def leaves_half(function):
    """Whether a function could go on with an exception from the middle of a change."""
    changes = any(re.fullmatch(rf"(?!const )({STATE.replace(' ', '|')})(<.*>)?&", t) for t in function.arguments)
    is_member = function.name.removeprefix("box2d::").partition("::")[0] in STATE.split()
    return function.may_throw and (changes or (is_member and "::" in function.name.partition("(")[0]))


def complaints(functions):
    doors, others, known = attacked(), excepted(), tests()
    for function in functions:
        is_attacked = function.interface == "JavaScript" or function.name in doors
        is_excepted = (function.interface, function.name) in others
        if not is_attacked and not is_excepted:
            yield f"{function.interface} {function.name}: no door() of proptests/attack, and no row of doors.txt"
        if function.name in doors and is_excepted:
            yield f"{function.interface} {function.name}: is attacked, so doors.txt need not have it"
        if leaves_half(function):
            yield f"{function.interface} {function.name}: is not noexcept, so it can leave a world half changed"
    names = {(function.interface, function.name) for function in functions}
    for row in others.keys() - names:
        yield f"{' '.join(row)}: a row of doors.txt, but no public function"
    for name in doors - {name for _, name in names}:
        yield f"{name}: a door of proptests/attack, but no public function"
    for row, test in others.items():
        if test not in known:
            yield f"{' '.join(row)}: nothing attacks it, as there is no test {test}"


def untried():
    """Rows of the contract's table of what goes together that name no test, or one that is not there."""
    text = (ROOT / "docs/contract.md").read_text(encoding="utf-8")
    table = text.partition("## What goes together")[2].partition("\n## ")[0]
    known = tests()
    for row in re.findall(r"^\| (?![-|])(.*) \|$", table, re.M):
        tried = re.findall(r"`([A-Z]\w+\.[A-Z]\w+|[\w/.]+/\w+\.[\w.]+)`", row.rpartition(" | ")[2])
        if not tried:
            yield f"docs/contract.md: nothing tries {row[:60]}"
        for test in tried:
            if test not in known and not (ROOT / test).is_file():
                yield f"docs/contract.md: there is no {test}"


def main():
    if declared.clang() is None:
        print("skipped: there is no clang++ to read the headers")
        return 77
    functions = declared.all_functions()
    found = sorted({*complaints(functions), *untried()})
    print("\n".join(found) or f"{len(functions)} public functions, each with what tries it")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
