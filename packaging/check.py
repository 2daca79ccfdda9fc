#!/usr/bin/env python3
"""Checks that the packages and the header agree with CMake: versions, components, options, targets and licence files.

    packaging/check.py    # exit status 0: all agree; 1: what does not

It needs no vcpkg, no Conan and no debhelper.
"""
import ast
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Files that tell a game or a user which version to ask for.
ASKING = ["docs/install.md", "packaging/README.md", "debian/copyright", "examples/lgs_ctypes.py",
          "packaging/tests/consumer/CMakeLists.txt", "addons/c/tests/consumer/CMakeLists.txt", "addons/c/liblgs.map"]


def text(name):
    return (ROOT / name).read_text(encoding="utf-8")


def components():
    """Those of find_package(), but for the engine itself, which is always there."""
    listed = re.search(r"set\(LocalGridSeg_components lgs ([^)]+)\)", text("cmake/LocalGridSegConfig.cmake.in"))
    return set(listed[1].split())


def conan_values():
    """The constants of the recipe, without running it."""
    found = {}
    for node in ast.walk(ast.parse(text("packaging/conan/conanfile.py"))):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            try:
                found[node.targets[0].id] = ast.literal_eval(node.value)
            except ValueError:
                pass  # it is computed
    return found


def complaints():
    version = re.search(r"project\(LocalGridSeg VERSION (\S+)", text("CMakeLists.txt"))[1]
    soversion = version if version[0] != "0" else version.rpartition(".")[0]
    asked = {found for name in ASKING
             for found in re.findall(r"(?:LocalGridSeg |liblgs\.so\.|liblocalgridseg|LGS_)(\d+\.\d+)", text(name))}
    options = set(re.findall(r"option\((LGS_\w+)", text("CMakeLists.txt")))
    port, conan = json.loads(text("packaging/vcpkg/vcpkg.json")), conan_values()
    portfile = text("packaging/vcpkg/portfile.cmake")
    features = dict(re.findall(r"^    (\w+) (LGS_BUILD_\w+)", portfile, re.MULTILINE))
    debian = re.match(r"localgridseg \(([^-]+)-", text("debian/changelog"))[1]
    control = text("debian/control")
    targets = set(re.findall(r"LocalGridSeg::(\w+)", text("packaging/vcpkg/usage")))
    dockets = set(re.findall(r"LICENSE\w*(?:\.md)?", portfile + text("packaging/conan/conanfile.py")))
    for what, is_so in [
        ("lgs/version.h has the version of CMakeLists.txt",
         f"kVersion{{{version.replace('.', ', ')}}};" in text("lib/include/lgs/version.h")),
        (f"{', '.join(ASKING)} ask for {version.rpartition('.')[0]}", asked == {version.rpartition(".")[0]}),
        ("lgs/c/values.h has the version of CMakeLists.txt",
         version == ".".join(re.findall(r"#define LGS_VERSION_\w+ (\d+)", text("addons/c/include/lgs/c/values.h")))),
        ("README.md has the version of CMakeLists.txt", f"| version | {version};" in text("README.md")),
        ("vcpkg.json has the version of CMakeLists.txt", port["version-semver"] == version),
        ("conanfile.py has the version of CMakeLists.txt", conan["version"] == version),
        ("web/package/package.json has the version of CMakeLists.txt",
         json.loads(text("web/package/package.json"))["version"] == version),
        ("debian/changelog has the version of CMakeLists.txt", debian == version),
        (f"debian/control names the library after its soname, {soversion}",
         f"Package: liblocalgridseg{soversion}\n" in control
         and (ROOT / f"debian/liblocalgridseg{soversion}.install").is_file()
         and set(re.findall(r"liblocalgridseg[\d.]+", control)) == {f"liblocalgridseg{soversion}"}),
        ("the features of vcpkg.json are the components", set(port["features"]) == components()),
        ("portfile.cmake takes each feature to its option",
         features == {name: f"LGS_BUILD_{name.upper()}" for name in components()}),
        ("conanfile.py has the components", set(conan["COMPONENTS"]) == components()),
        ("each option is one of CMakeLists.txt",
         set(re.findall(r"LGS_BUILD_[A-Z0-9]+", portfile)) <= options),
        ("usage names targets that exist", targets <= components() | {"lgs"}),
        ("the licence files exist", len(dockets) == 2 and all((ROOT / name).is_file() for name in dockets)),
    ]:
        if not is_so:
            yield what


def main():
    found = list(complaints())
    for complaint in found:
        print(f"packaging: it is not so that {complaint}")
    if not found:
        print("packaging: vcpkg, Conan and Debian agree with CMake")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
