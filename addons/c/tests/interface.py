#!/usr/bin/env python3
"""What the C headers declare, against a committed list: constants, types, functions. lgs_engine.h is among them.

    addons/c/tests/interface.py             # exit status 1, and a diff, if interface.txt says something else
    addons/c/tests/interface.py --write     # writes interface.txt: from 1.0 on only with more lines than before
    addons/c/tests/interface.py --layout    # prints a program in C that prints where the fields of all structs lie

symbols.txt has the names that the library shows, and layout.txt where the fields of structs lie; neither knows the
arguments of a function, nor the number behind a constant.
"""
import difflib
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
HEADERS = [ROOT / f"addons/c/include/lgs/c/{name}.h" for name in ("values", "world", "edit", "read")]
HEADERS.append(ROOT / "addons/c/include/lgs/lgs_views.h")
HEADERS.append(ROOT / "oracle/engine/include/lgs/lgs_engine.h")


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


def layout(found):
    """A program that prints the size of each struct, then the offset of each field."""
    yield "#include <lgs/lgs.h>\n#include <lgs/lgs_engine.h>\n#include <lgs/lgs_views.h>\n#include <stdio.h>"
    yield "int main(void) {"
    for name, fields in re.findall(r"typedef struct (\w+) \{ (.*); \}", "\n".join(found)):
        yield f'  printf("{name} %d\\n", (int)sizeof({name}));'
        fields = re.sub(r"\(\*(\w+)\)\([^)]*\)", r"\1", fields)  # a pointer to a function
        for field in re.findall(r"(\w+)(?:\[\d+\])?(?:[;,]|$)", fields):
            yield f'  printf("  {field} %d\\n", (int)offsetof({name}, {field}));'
    yield "  return 0;\n}"


def main():
    found = [line for header in HEADERS for line in declarations(header.read_text(encoding="utf-8"))]
    if sys.argv[1:] == ["--layout"]:
        print("\n".join(layout(found)))
        return 0
    text = "\n".join(found) + "\n"
    listed = HERE / "interface.txt"
    if sys.argv[1:] == ["--write"]:
        listed.write_text(text, encoding="utf-8")
        return 0
    expected = listed.read_text(encoding="utf-8")
    if text == expected:
        print(f"{len(found)} declarations: as interface.txt says")
        return 0
    print("The headers declare something else than addons/c/tests/interface.txt says:")
    print("\n".join(difflib.unified_diff(expected.splitlines(), found, "listed", "declared", lineterm="", n=0)))
    return 1


if __name__ == "__main__":
    sys.exit(main())
