#!/usr/bin/env python3
"""Writes the engine and the brushes as two files, localgridseg.h and localgridseg.cpp.

A game compiles the one and includes the other: no build system has to know of this library. tl::expected, which the
public headers need, is put into the header whole, under its own licence.
"""
import argparse
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PUBLIC = [ROOT / "lib/include", ROOT / "lib/brush/include"]
SOURCES = [ROOT / "lib" / room for room in ("geometry", "storage", "ground", "outline", "world", "brush/src")]
INCLUDE = re.compile(r'#include ([<"])([^>"]+)[>"]')


class Writer:
    """Puts the text of files together. What a file includes comes before it, and everything once."""

    def __init__(self, expected, done=()):
        self.expected, self.done, self.lines = expected, set(done), []

    def resolve(self, name, place):
        if name == "tl/expected.hpp":
            return self.expected
        for folder in [place.parent, *PUBLIC, ROOT / "lib"]:
            if (folder / name).is_file():
                return folder / name
        return None

    def add(self, path):
        if path in self.done:
            return
        self.done.add(path)
        body, conditions = [], 0
        for line in path.read_text(encoding="utf-8").splitlines():
            conditions += line.startswith("#if") - line.startswith("#endif")
            include = INCLUDE.match(line)
            if include is None:
                if line != "#pragma once":
                    body.append(line)
                continue
            found = self.resolve(include[2], path)
            if found is not None:
                self.add(found)
            elif include[1] == "<" and conditions != 0:
                body.append(line)  # it is for some systems only
            elif include[1] == "<":
                self.include_once(line)
            else:
                sys.exit(f"{path.relative_to(ROOT)} includes {include[2]}, which is not there")
        name = path.relative_to(ROOT) if path.is_relative_to(ROOT) else f"{path.parent.name}/{path.name}"
        text = re.sub(r"\n{3,}", "\n\n", "\n".join(body)).strip("\n")
        if path == self.expected:
            text = QUIET.format(text)
        self.lines += ["", f"// ---- {name} ----", "", text]

    def include_once(self, line):
        if line not in self.done:
            self.done.add(line)
            self.lines.append(line)


# Without exceptions tl::expected has a parameter that it does not use. A game should see no warning of it.
QUIET = """\
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
{}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif"""

# lib/ is compiled with -ffp-contract=off. Here the file itself has to ask for it.
NO_CONTRACTION = """
// Some machines work out a * b + c with a single rounding. Then answers in double would depend on the machine.
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif
"""


def version():
    return re.search(r"project\(LocalGridSeg VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


def banner(what):
    licence = (ROOT / "LICENSE").read_text(encoding="utf-8").rstrip("\n")
    return [f"// LocalGridSeg {version()}: {what}", "// Made by scripts/amalgamate.py from lib/; change it there.", "//",
            *(f"// {line}".rstrip() for line in licence.splitlines())]


def write(path, text):
    if not path.is_file() or path.read_text(encoding="utf-8") != text:  # what is made of it need not be made again
        path.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, help="where to write the files")
    parser.add_argument("--expected", type=Path, default=Path("/usr/include/tl/expected.hpp"),
                        help="the header of tl::expected; default: %(default)s")
    args = parser.parse_args()
    if not args.expected.is_file():
        sys.exit(f"{args.expected} is not there. Install libexpected-dev, or name the header with --expected.")

    header = Writer(args.expected)
    for folder in PUBLIC:
        for path in sorted(folder.rglob("*.h")):
            header.add(path)
    source = Writer(args.expected, header.done)
    for folder in SOURCES:
        for path in sorted(folder.glob("*.cpp")):
            source.add(path)

    args.folder.mkdir(parents=True, exist_ok=True)
    for name, lines in (
            ("localgridseg.h", banner("the engine and the brushes.") + ["#pragma once"] + header.lines),
            ("localgridseg.cpp", banner("what to compile; C++20.") + [NO_CONTRACTION, '#include "localgridseg.h"'] + source.lines)):
        write(args.folder / name, "\n".join(lines) + "\n")


main()
