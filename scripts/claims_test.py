"""Plants what each check of scripts/claims.py must find, in a small project, and expects that and no more."""
import json
import pathlib
import subprocess
import tempfile

import claims

FILES = {
    "README.md": "[a](docs/a.md) [b](docs/contract.md) [c](docs/internals/folders.md) [d](fuzz/README.md)\n"
                 "[f](docs/install.md) "
                 "[e](docs/reports/planted-bugs.md)\n\n<!-- counted: presets -->\n<!-- end -->\n",
    "docs/a.md": "[back](../README.md)\n",
    "docs/contract.md": "1. *One.* A law.\n2. *Two.* A law.\n",
    "docs/internals/folders.md": "| folder | |\n|---|---|\n| `cmake/`, `docs/`, `fuzz/` | |\n"
                                 "| `lib/`, `lib/ground/` | |\n"
                                 "| `proptests/` | |\n",
    "docs/reports/planted-bugs.md": "| bug | game | in | found by |\n|---|---|---|---|\n"
                                    "| a bug | x | `a.cpp` | `A.B` |\n",
    "docs/install.md": "| component | |\n|---|---|\n| `lgs` | |\n| `c` | |\n",
    "cmake/LocalGridSegConfig.cmake.in": "set(LocalGridSeg_components lgs c)\n",
    "fuzz/README.md": "| target | |\n|---|---|\n| `edits` | |\n",
    "fuzz/corpus/edits/one": "",
    "proptests/bugs/law1.toml": "law = 'Law 1'\n\n[[bug]]\nname = \"a bug\"\n",
    "CMakePresets.json": json.dumps({"configurePresets": [{"name": "release", "displayName": "Release"}]}),
    "lib/ground/a.cpp": "".join(f"int a{k};\n" for k in range(100)),
}
FIGURES = "<!-- figures: some commit={} paths=lib/ground within=20% -->\n| a table |\n{}<!-- end -->\n"


def git(root, *words):
    who = ["-c", "user.name=test", "-c", "user.email=test@example.org", "-c", "commit.gpgsign=false"]
    return subprocess.run(["git", *who, *words], cwd=root, check=True, capture_output=True, text=True).stdout.strip()


class Project:
    def __init__(self, folder):
        self.root = pathlib.Path(folder)
        for name, text in FILES.items():
            self.put(name, text)
        claims.write(self.root)
        git(self.root, "init", "-q")
        self.first = self.commit()

    def put(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text, encoding="utf-8")

    def commit(self):
        git(self.root, "add", "-A")
        git(self.root, "commit", "-q", "--allow-empty", "-m", "a commit")
        return git(self.root, "rev-parse", "HEAD")

    def read(self, name):
        return (self.root / name).read_text(encoding="utf-8")


def planted():
    """What is planted: a name, what plants it, and what must be said; None if nothing may be said."""
    page = "docs/a.md"

    def add(name, text):
        return lambda p: p.put(name, p.read(name) + text)

    def swap(name, old, new):
        return lambda p: p.put(name, p.read(name).replace(old, new))

    def changed(lines, text=""):
        def plant(p):
            p.put(page, p.read(page) + FIGURES.format(p.first, text))
            p.put("lib/ground/a.cpp", "".join(f"int {'b' if k < lines else 'a'}{k};\n" for k in range(100)))
            p.commit()
        return plant

    yield "nothing", lambda p: None, None
    yield "a wide line", add(page, "x" * 121 + "\n"), "the line has 121 characters"
    yield "120 characters of three bytes", add(page, "→" * 120 + "\n"), None
    yield "a wide row of a table", add(page, "| " + "x" * 130 + " |\n"), None
    yield "a page that is not linked", lambda p: p.put("docs/b.md", "[self](b.md)\n"), "docs/b.md:1: no other page"
    yield "a counted block that is old", swap("README.md", "| `release` |", "| `debug` |"), "'presets' is not what"
    yield "a preset that came", lambda p: p.put("CMakePresets.json", json.dumps({"configurePresets": [
        {"name": "release", "displayName": "Release"}, {"name": "asan", "displayName": "Asan"}]})), "'presets' is not"
    yield "a block that nothing counts", add(page, "<!-- counted: stars -->\n<!-- end -->\n"), "nothing counts 'stars'"
    yield "a marker without an end", add(page, "<!-- counted: presets -->\n"), "a marker that can not be read"
    yield "a folder that came", lambda p: p.put("lib/outline/b.cpp", ""), "does not name lib/outline/"
    yield "a folder that is gone", add("docs/internals/folders.md", "| `gone/` | |\n"), "it names gone/"
    yield "a law that is left out", swap("docs/contract.md", "2. *Two.*", "3. *Two.*"), "of laws, it"
    yield "a bug without a row", add("proptests/bugs/law1.toml", "[[bug]]\nname = 'new'\n"), "does not name new"
    yield "a row without a bug", add("docs/reports/planted-bugs.md", "| old | x | `a.cpp` | `A.B` |\n"), "it names old"
    yield "a component without a row", swap("cmake/LocalGridSegConfig.cmake.in", "lgs c", "lgs c tiled"), "name tiled"
    yield "a fuzz target without a row", lambda p: p.put("fuzz/corpus/trace/one", ""), "does not name trace"
    yield "figures of code that changed", changed(30), "30 lines of a hundred have changed"
    yield "the same, and the page says so", changed(30, claims.OLD + "\n"), None
    yield "figures of code that changed a little", changed(10), None
    yield "the same, and the page calls them old", changed(10, claims.OLD + "\n"), "no older than is allowed"
    yield "figures of no commit", add(page, FIGURES.format("abcdef0", "")), "which is not in this history"


def says_of_a_clone(*how):
    """What is said of figures that are too old, in a copy without their history."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "copy"
        subprocess.run([*how, str(copy)], check=True, capture_output=True)
        return claims.history(copy), list(claims.complaints(copy))


def run():
    faults = []
    for name, plant, expected in planted():
        with tempfile.TemporaryDirectory() as folder:
            project = Project(folder)
            plant(project)
            found = list(claims.complaints(project.root))
            if not (found and all(expected in words for words in found) if expected else not found):
                faults.append(f"{name}: expected {expected}, found {found}")
            if name == "figures of code that changed":
                shallow = ("git", "clone", "-q", "--depth", "1", f"file://{folder}")
                archive = ("sh", "-c", f"mkdir \"$1\" && git -C {folder} archive HEAD | tar -x -C \"$1\"", "sh")
                for how, reason in ((shallow, "this is a shallow clone"), (archive, "this is no clone")):
                    if says_of_a_clone(*how) != (reason, []):
                        faults.append(f"{reason}: {says_of_a_clone(*how)}")
    print(*faults, sep="\n", end="\n" if faults else "")
    return 1 if faults else 0
