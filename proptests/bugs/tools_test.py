#!/usr/bin/env python3
"""What becomes of an attempt to plant a bug, and what is said of a list that is wrong."""

import argparse
import contextlib
import shutil
import tempfile
import unittest
import unittest.mock
from dataclasses import dataclass
from pathlib import Path

import bugs
import finished
import trying
import workshop
from bugs import Wrong
from finders import Tests
from workshop import DoesNotBuild

class Lists(unittest.TestCase):
    def test_faults(self):
        listed = bugs.read("law", """# Law
found by: lgs_tests NoSuchSuite.
README.md
  one [fuzz none]
    LocalGridSeg ==> x
  same
    # LocalGridSeg ==> # LocalGridSeg
  same
    no such text ==>
none.cpp
  gone
    a ==>
""")
        for fault, said in zip(bugs.faults(listed), (
                "no test begins with NoSuchSuite", "one: to be found once", "no fuzz target none",
                "same: changes nothing", "same: to be found once", "none.cpp", "2 bugs are called: same"), strict=True):
            self.assertIn(said, fault)


@dataclass(frozen=True)
class Looks:
    """Finds what has one of its words in it."""
    words: tuple[str, ...]
    kind = "tests"
    targets = {"program": "program"}

    def search(self, _, program) -> dict:
        found = any(word in program("program").read_text() for word in self.words)
        return {"verdict": "found" if found else "passes", "by": self.words[0], "seconds": 1}


class Shop:
    """Makes a program of the code, which has only small letters; does not build where it says so."""
    def __init__(self, folder: Path):
        self.folder = self.tree = folder
        (folder / "a.cpp").write_text("good code")
        self.build("tests", "program")

    @contextlib.contextmanager
    def changed(self, file: str, text: str):
        (self.tree / file).write_text(text)
        yield
        (self.tree / file).write_text("good code")

    def build(self, _, target: str) -> float:
        text = (self.tree / "a.cpp").read_text()
        if "error" in text:
            raise DoesNotBuild("error: here")
        (self.folder / target).write_text(text.lower())
        return 1

    def program(self, _, name: str) -> Path:
        return self.folder / name


class Programs(unittest.TestCase):
    def search(self, script: str) -> dict:
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program"
            program.write_text("#!/bin/sh\necho '[ RUN      ] A.B'\n" + script)
            program.chmod(0o755)
            shop = argparse.Namespace(folder=Path(folder))
            return Tests("program", "A.*").search(shop, lambda _: program) | {"seconds": 0}

    def test_how_tests_end(self):
        found = {"verdict": "found", "by": "A.B", "seconds": 0}
        self.assertEqual(self.search("exit 0"), {"verdict": "passes", "seconds": 0})
        self.assertEqual(self.search("echo '[  FAILED  ] A.B (3 ms)'; exit 1"), found)
        self.assertEqual(self.search("kill -SEGV $$"), found | {"how": "crashes"})
        self.assertEqual(self.search("echo 'hung for 60 s'; echo '[  FAILED  ] A.B'; exit 1")["verdict"], "time-out")


class Attempts(unittest.TestCase):
    def attempt(self, replace: str, *words: str, each: bool = False, score: bool = False) -> dict:
        bug = bugs.Bug("law", bugs.Group("", "", ("x",), each), "a.cpp", "bug", None, (("good", replace),))
        with tempfile.TemporaryDirectory() as folder:
            bench = trying.Bench(Shop(Path(folder)), argparse.Namespace(score=score, built=None, suite=None), None)
            bench.finders = lambda _: [Looks((word,)) for word in words]
            outcome = bench.attempt(bug)
            self.assertEqual((Path(folder) / "a.cpp").read_text(), "good code")
            return outcome

    def test_verdicts(self):
        for replace, verdict in (("bad", "found"), ("other", "passes"), ("GOOD", "same code"),
                                 ("error", "does not compile")):
            self.assertEqual(self.attempt(replace, "bad", "worse")["verdict"], verdict, replace)
        self.assertEqual(self.attempt("bad", "none", "bad"),
                         {"verdict": "found", "by": "bad", "seconds": 2, "built": 1})

    def test_what_the_command_does_not_have_it_does_not_find(self):
        self.assertEqual(self.attempt("GOOD", "bad", score=True)["verdict"], "passes")

    def test_where_each_must_find_it_one_is_not_enough(self):
        self.assertEqual(self.attempt("bad and worse", "bad", "worse", each=True)["verdict"], "found")
        self.assertEqual(self.attempt("bad", "bad", "worse", each=True)["verdict"], "passes")

    def test_what_finds_something_without_a_bug_finds_nothing(self):
        with self.assertRaisesRegex(Wrong, "without any bug"):
            self.attempt("bad", "code")


BUILD = """rule compile
  command = c++ -I{0}/lib -MD -MF $out.d -o $out -c $in
  deps = gcc
  depfile = $out.d
rule archive
  command = ar rcs $out $in
rule link
  command = c++ $in -o $out lib/liba.a
build lib/a.o: compile {0}/lib/a.cpp
build lib/liba.a: archive lib/a.o
build cli/main.o: compile {0}/cli/main.cpp
build program: link cli/main.o | lib/liba.a
"""


@unittest.skipUnless(shutil.which("ninja") and shutil.which("c++"), "without Ninja or a compiler")
class FinishedBuild(unittest.TestCase):
    def test_a_program_is_linked_with_the_bug_and_nothing_else_changes(self):
        with tempfile.TemporaryDirectory() as name, contextlib.ExitStack() as patched:
            root = Path(name).resolve()
            for module in ("finished.ROOT", "finished.FOLDER"):
                patched.enter_context(unittest.mock.patch(module, root / ("." if module.endswith("ROOT") else "bugs")))
            for file, text in (("lib/b.h", "inline int g() { return 1; }"), ("oracle/none.h", ""), ("bench/none.h", ""),
                               ("lib/a.cpp", '#include "b.h"\nint f() { return g(); }'),
                               ("cli/main.cpp", "int f();\nint main() { return f(); }"),
                               ("build/build.ninja", BUILD.format(root))):
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text(text)
            workshop.make(["ninja", "-C", root / "build", "program"])
            shop = finished.Finished(root / "build")
            for file, text in (("lib/a.cpp", "int f() { return 2; }"), ("lib/b.h", "inline int g() { return 2; }"),
                               ("cli/main.cpp", "int main() { return 2; }")):
                with shop.changed(file, text):
                    shop.build("", "program")
                    self.assertEqual(workshop.run([shop.program("", "program")], 5).status, 2)
                self.assertEqual(workshop.run([shop.program("", "program")], 5).status, 1)
            self.assertEqual((root / "lib/b.h").read_text(), "inline int g() { return 1; }")


if __name__ == "__main__":
    unittest.main()
