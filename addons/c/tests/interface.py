#!/usr/bin/env python3
"""What programs in C that are linked already rely on, against a committed list: interface.txt beside this script.

    ctest --preset release -R c.interface -V     # exit status 1, and a diff, if interface.txt says something else
    cmake --build build/release --target lgs_c_interface  # writes it: from 1.0 on only with more lines than before

The list has the declarations of the headers (constants, types, functions; lgs_engine.h is among them), for each struct
its size and where its fields lie if pointers have 64 bits, for each function of the library the version of its symbol.
"""
import argparse
import difflib
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LISTED = Path(__file__).resolve().parent / "interface.txt"
HEADERS = ["lgs/c/values.h", "lgs/c/world.h", "lgs/c/edit.h", "lgs/c/read.h", "lgs/lgs_views.h", "lgs/lgs_falling.h", "lgs/lgs_engine.h"]
STRUCT = re.compile(r"typedef struct (\w+) \{ (.*); \}")


def declarations(text):
    """One line for each, without comments, and with single blanks."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    for name, value in re.findall(r"^#define (LGS_(?!API|NOTHROW|C_|ENGINE_EXPORT)\w+) (\S+)", text, flags=re.M):
        yield f"#define {name} {value}"
    text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
    text = re.sub(r'extern "C" \{|^\}$', "", text, flags=re.M)
    for mark in ("LGS_API ", "LGS_ENGINE_EXPORT ", " LGS_NOTHROW"):
        text = text.replace(mark, "")
    text = re.sub(r"\{[^}]*\}", lambda body: body.group(0).replace(";", "\0"), text)  # a struct is one declaration
    for declaration in text.split(";"):
        line = " ".join(declaration.replace("\0", ";").split())
        if line:
            yield line


def layout_program(found):
    """A program that prints a line for each struct: its name, its size, the offset of each field."""
    yield from (f"#include <{header}>" for header in ["lgs/lgs.h", *HEADERS[4:], "stddef.h", "stdio.h"])
    yield "int main(void) {"
    for name, fields in STRUCT.findall("\n".join(found)):
        yield f'  printf("{name} {name}: %d bytes", (int)sizeof({name}));'
        fields = re.sub(r"\(\*(\w+)\)\([^)]*\)", r"\1", fields)  # a pointer to a function
        for field in re.findall(r"(\w+)(?:\[\d+\])?(?:[;,]|$)", fields):
            yield f'  printf(", {field} at %d", (int)offsetof({name}, {field}));'
        yield '  printf("\\n");'
    yield "  return 0;\n}"


def layouts(found, compiler, includes):
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "layout"
        subprocess.run([compiler, "-std=c99", *(f"-I{path}" for path in includes), "-xc", "-", "-o", program],
                       input="\n".join(layout_program(found)), text=True, check=True)
        lines = subprocess.run([program], text=True, check=True, stdout=subprocess.PIPE).stdout.splitlines()
    return dict(line.split(" ", 1) for line in lines)


def versions(library, nm):
    """Each symbol that the shared library shows, and its version. (llvm-nm gives the version itself one.)"""
    shown = subprocess.run([nm, "-D", "--defined-only", library], text=True, check=True, stdout=subprocess.PIPE).stdout
    symbols = [line.split(" ", 2)[1:] for line in shown.splitlines()]
    return {name.partition("@@")[0]: name.partition("@@")[2] for kind, name in symbols if kind != "A"}


def lines_of(arguments):
    texts = {h: next(p / h for p in arguments.include if (p / h).is_file()).read_text(encoding="utf-8") for h in HEADERS}
    found = {header: list(declarations(text)) for header, text in texts.items()}
    layout = layouts([line for lines in found.values() for line in lines], arguments.cc, arguments.include)
    shown = versions(arguments.library, arguments.nm)
    for header, lines in found.items():
        for line in lines:
            struct, function = STRUCT.match(line), re.match(r"(?!typedef).*?(\w+)\(", line)
            is_shown = function and header != "lgs/lgs_engine.h"
            yield line + (f" @{shown.pop(function[1], 'not in the library')}" if is_shown else "")
            if struct:
                yield f"    {layout[struct[1]]}"
    for name, version in sorted(shown.items()):
        yield f"not in the headers: {name} {version}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", help="liblgs.so")
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--include", type=Path, nargs="+", required=True, help="folders of the headers")
    parser.add_argument("--write", action="store_true", help="write interface.txt anew")
    arguments = parser.parse_args()
    found = list(lines_of(arguments))
    if arguments.write:
        LISTED.write_text("\n".join(found) + "\n", encoding="utf-8")
        return 0
    expected = LISTED.read_text(encoding="utf-8").splitlines()
    if found == expected:
        print(f"{len(found)} lines: as interface.txt says")
        return 0
    print("Headers and library show something else than interface.txt says:")
    print("\n".join(difflib.unified_diff(expected, found, "listed", "found", lineterm="", n=0)))
    return 1


if __name__ == "__main__":
    sys.exit(main())
