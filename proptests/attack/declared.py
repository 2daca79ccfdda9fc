"""Every public function: of the C and C++ headers as clang's syntax tree has them, of the npm package as its sources
export them. Each is a Function: which interface, its name with the types of its arguments, and these types."""

import json
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENGINE = "lib/include"
# The headers of an interface, and the folders where they are. Of the terrain it is the one for Box2D 2.4; that for
# Box2D 3 has the same functions with other types.
CPP = {
    "C++": (["lgs/world.h", "lgs/version.h"], [ENGINE]),
    "brush": (["lgs/brush.h"], [ENGINE, "lib/brush/include"]),
    "pieces": (["lgs/pieces.h"], [ENGINE, "lib/pieces/include"]),
    "views": (["lgs/hashes.h", "lgs/islands.h", "lgs/radial_match.h", "lgs/unloaded.h"], [ENGINE, "lib/views/include"]),
    "falling": (["lgs/falling.h", "lgs/ground.h"],
                [ENGINE, "lib/views/include", "lib/brush/include", "addons/falling/include"]),
    "debug": (["lgs/debug.h"], [ENGINE, "addons/debug/include"]),
    "tiled": (["lgs/tiled/import.h"], [ENGINE, "addons/tiled/include"]),
    "box2d": (["lgs/box2d/edges.h", "lgs/box2d/hit.h", "lgs/box2d/materials.h", "lgs/box2d/terrain.h",
               "lgs/box2d/cut_out.h"],
              [ENGINE, "lib/brush/include", "addons/box2d/include", "addons/box2d/both/include", "addons/box2d/v2/names/include",
               "addons/box2d/v2/include", "addons/box2d/cut_out/include"]),
}
WEB = ROOT / "web" / "package" / "src"
FUNCTIONS = {"FunctionDecl", "CXXMethodDecl", "CXXConstructorDecl", "CXXDestructorDecl", "CXXConversionDecl"}


@dataclass(frozen=True)
class Function:
    interface: str
    name: str
    arguments: tuple[str, ...]
    may_throw: bool = False  # of C++


def clang():
    """Where the compiler is, or None."""
    return next(filter(None, map(shutil.which, ["clang++", *(f"clang++-{k}" for k in range(30, 12, -1))])), None)


# --- C and C++


def syntax_trees(headers, folders, word):
    """The declarations with this word in their full names."""
    source = "".join(f"#include <{header}>\n" for header in headers)
    run = subprocess.run(
        [clang(), "-std=c++20", "-fsyntax-only", "-x", "c++", "-", *(f"-I{ROOT / folder}" for folder in folders),
         "-Xclang", "-ast-dump=json", "-Xclang", f"-ast-dump-filter={word}"],
        input=source, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SystemExit(f"clang does not take {', '.join(headers)}:\n{run.stderr}")
    decoder, at = json.JSONDecoder(), 0
    while at < len(run.stdout):
        tree, at = decoder.raw_decode(run.stdout, at)
        yield tree
        at += len(run.stdout[at:]) - len(run.stdout[at:].lstrip())


def plain(type_name):
    """A type as a reader would write it: without namespaces of ours and std's."""
    text = re.sub(r"\b(lgs::box2d::|lgs::tiled::|lgs::|std::)", "", type_name)
    return re.sub(r"\s+", " ", re.sub(r"\s*([&*])", r"\1", text)).strip()


def arguments_of(tree):
    return tuple(plain(part["type"]["qualType"]) for part in tree.get("inner", ()) if part["kind"] == "ParmVarDecl")


def functions(tree, scope, interface):
    """Those that a game may call, in a namespace or a class. What the compiler makes by itself is none."""
    access = "private" if tree.get("tagUsed") == "class" else "public"
    for part in tree.get("inner", ()):
        if part["kind"] == "AccessSpecDecl":
            access = part["access"]
        if access != "public" or part.get("isImplicit"):
            continue
        if part["kind"] in ("FunctionTemplateDecl", "ClassTemplateDecl", "FriendDecl"):
            part = next((p for p in part.get("inner", ()) if p["kind"] in FUNCTIONS | {"CXXRecordDecl"}), part)
        kind, name = part["kind"], part.get("name", "")
        if kind in FUNCTIONS:
            known = part.get("explicitlyDefaulted") or part.get("explicitlyDeleted") or "parentDeclContextId" in part
            if not known:
                after = part["type"]["qualType"].rpartition(")")[2].split()
                types = arguments_of(part)
                yield Function(interface, f"{scope}{name}({', '.join(types)})" + (" const" if "const" in after else ""),
                               types, "noexcept" not in after and not part.get("constexpr"))
        elif kind == "NamespaceDecl" and name not in ("detail", "brush"):
            yield from functions(part, f"{scope}{name}::", interface)
        elif kind == "CXXRecordDecl" and part.get("completeDefinition"):
            yield from functions(part, f"{scope}{name}::", interface)


def of_cpp():
    found = {}
    for interface, (headers, folders) in CPP.items():
        for tree in syntax_trees(headers, folders, "lgs"):
            if tree["kind"] == "NamespaceDecl" and tree.get("name") == "lgs":
                for function in functions(tree, "", interface):
                    found.setdefault(function.name, function)
    return list(found.values())


def of_c():
    trees = syntax_trees(["lgs/lgs.h", "lgs/lgs_falling.h"], ["addons/c/include"], "lgs_")
    return [Function("C", tree["name"], arguments_of(tree)) for tree in trees if tree["kind"] == "FunctionDecl"]


# --- JavaScript

# The modules that the package exports, and what of its other modules they pass on.
MODULES = ["islands", "pieces", "trace", "oracle", "draw", "planck", "box2d3"]
DECLARED = re.compile(r"^export (?:declare )?(?:const |function |class |interface )(\w+)", re.M)
ARGUMENTS = r"\(((?:[^()]|\([^()]*\))*)\)"
NOT_OURS = {"Box2D"}  # what a game hands in


def split(arguments):
    """Types of 'a: number, b?: { x: number }'."""
    types, depth, text = [], 0, ""
    for character in arguments + ",":
        depth += (character in "([{<") - (character in ")]}>" and not text.endswith("="))
        if character == "," and depth == 0:
            if text.strip():
                types.append(text.partition(":")[2].partition(" = ")[0].strip() or "number")  # by default
            text = ""
        else:
            text += character
    return tuple(" ".join(t.split()) for t in types)


def exported(module):
    """The names that a module passes on from others, and from which."""
    text = (WEB / f"{module}.ts").read_text()
    for names, origin in re.findall(r"^export \{ ([^}]*) \} from '\./([\w-]+)\.js'", text, re.M):
        yield from ((name, origin) for name in names.split(", "))
    for origin in re.findall(r"^export \* from '\./([\w-]+-api)\.js'", text, re.M):
        yield from exported(origin)


def body(text, name):
    """The lines of a class or an interface."""
    found = re.search(rf"^export (?:abstract )?(?:class|interface) {name}\b([^{{]*)\{{\n(.*?)^\}}", text, re.M | re.S)
    if not found:
        return None
    base = re.search(r"\bextends (\w+)", found.group(1))
    inherited = next(filter(None, (body(path.read_text(), base.group(1)) for path in sorted(WEB.glob("*.ts")))), "") \
        if base else ""
    return found.group(2) + inherited


def methods(text, scope):
    pattern = rf"^  (?:static )?(?:async )?(?:get )?(\w+|\[Symbol\.dispose\]){ARGUMENTS}"
    for name, arguments in re.findall(pattern, text, re.M):
        types = split(arguments)
        yield Function("JavaScript", f"{scope}.{name}({', '.join(types)})", types)


def exports(text, names, prefix=""):
    for name in names:
        if name in NOT_OURS:
            continue
        function = re.search(rf"^export (?:async )?(?:function {name}|const {name} = )(?:<[^>]*>)?{ARGUMENTS}", text, re.M)
        if function:
            types = split(function.group(1))
            yield Function("JavaScript", f"{prefix}{name}({', '.join(types)})", types)
        elif (lines := body(text, name)) is not None:
            yield from methods(lines, f"{prefix}{name}")


def of_javascript():
    found = []
    for module, name, origin in [("index", "init", "index"), ("full", "init", "full"), ("inline", "init", "inline"),
                                 ("small", "init", "small"), ("inline-islands", "init", "inline-islands"),
                                 *(("api", *pair) for pair in exported("api")),
                                 *(("full", *pair) for pair in exported("full"))]:
        found += exports((WEB / f"{origin}.ts").read_text(), [name], f"{module}/" if name == "init" else "")
    types = (WEB / "types.ts").read_text()
    found += exports(types, [name for name in DECLARED.findall(types)])
    for module in MODULES:
        text = (WEB / f"{module}.ts").read_text()
        found += exports(text, DECLARED.findall(text), f"{module}/")
        for name, origin in exported(module):
            found += exports((WEB / f"{origin}.ts").read_text(), [name], f"{module}/")
    return found


def all_functions():
    return of_cpp() + of_c() + of_javascript()


if __name__ == "__main__":  # for web/package/test/attack
    for function in of_javascript():
        print(function.name)
