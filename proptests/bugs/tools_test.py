#!/usr/bin/env python3
"""How a list of bugs is read and planted, what becomes of an attempt, and which mutants are made of a line of code."""

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
import mutants
import run
import trying
import workshop
from bugs import Wrong
from finders import Tests, shrunk
from results import Results, changed_since, git
from rules import changes_of
from workshop import DoesNotBuild

LIST = """# Law 1
found by: lgs_tests Suite. Other.

lib/a.cpp
  the wrong one is taken [fuzz edits]
    f(a, b) ==> f(b, a)
  nothing is done
    g(); h(); ==>
    if (x) ==> if (true)

# Law 2
found by each: node a.test.js:x b.test.js
web/b.ts
  never
    return true ==> return false
"""


class Lists(unittest.TestCase):
    def test_what_is_read(self):
        one, two, three = bugs.read("law", LIST)
        self.assertEqual((str(one), one.file, one.fuzz), ("law: the wrong one is taken", "lib/a.cpp", "edits"))
        self.assertEqual(one.group, bugs.Group("Law 1", "lgs_tests", ("Suite.", "Other."), False))
        self.assertEqual(two.changes, (("g(); h();", ""), ("if (x)", "if (true)")))
        self.assertEqual((three.file, three.group.each), ("web/b.ts", True))

    def test_what_is_refused(self):
        for line in ("lib/a.cpp\n   three blanks", "lib/a.cpp\n    a ==> b", "lib/a.cpp\n  a bug\n    no arrow"):
            with self.assertRaisesRegex(Wrong, r"law.bugs:\d:"):
                bugs.read("law", "# Law 1\nfound by: lgs_tests A.\n" + line)
        with self.assertRaisesRegex(Wrong, "found by"):
            bugs.read("law", "# Law 1\nlib/a.cpp\n")

    def planted(self, text: str, find: str, replace: str) -> str:
        return bugs.Bug("law", bugs.Group("", "", (), False), "a.cpp", "bug", None, ((find, replace),)).plant(text)

    def test_blanks_of_the_text_are_blanks_or_line_breaks_of_the_code(self):
        self.assertEqual(self.planted("a;\n  b;\n  c;", "a; b;", "a;"), "a;\n  c;")
        self.assertEqual(self.planted("a;\n  b;\n  c;", "a; b; c;", "a; x; c;"), "a;\n  x;\n  c;")
        self.assertEqual(self.planted("if (a)\n  b;", "b;", "c; b;"), "if (a)\n  c; b;")
        self.assertEqual(self.planted("f(a); g();", "f(a);", ""), " g();")

    def test_the_text_must_be_there_once(self):
        for text in ("f(a) + f(a)", "f(b)"):
            with self.assertRaisesRegex(Wrong, "to be found once in a.cpp"):
                self.planted(text, "f(a)", "")

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


class Outcomes(unittest.TestCase):
    def test_the_file_has_the_last_outcome_of_each_bug_and_each_way(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "results.jsonl"
            tests, score = Results(file, "tests"), Results(file, "lgs check")
            tests.put("b", {"verdict": "passes"})
            tests.put("a", {"verdict": "found", "by": "A.B"})
            score.put("b", {"verdict": "found"})
            tests.put("b", {"verdict": "found", "by": "C.D", "output": "much"})
            self.assertEqual([(e["bug"], e["with"], e.get("by")) for e in tests.read().values()],
                             [("a", "tests", "A.B"), ("b", "lgs check", None), ("b", "tests", "C.D")])
            self.assertEqual(tests.of_now("b")["commit"], tests.commit)
            self.assertNotIn("much", file.read_text())
            tests.commit = "another"
            self.assertIsNone(tests.of_now("b"))
            self.assertEqual(tests.last("b")["by"], "C.D")

    def test_what_changed_since(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch("results.ROOT", Path(folder)):
            (Path(folder) / "a.cpp").write_text("a")
            (Path(folder) / "law.bugs").write_text("a.cpp\n  old\n")
            git("init", "-q")
            git("add", ".")
            git("-c", "user.name=x", "-c", "user.email=x", "commit", "-qm", "x")
            self.assertEqual(changed_since("HEAD"), (set(), set()))
            (Path(folder) / "law.bugs").write_text("a.cpp\n  new [fuzz edits]\n  old\n")
            self.assertEqual(changed_since("HEAD"), ({"law.bugs"}, {"new"}))
            with self.assertRaisesRegex(Wrong, "no-such"):
                changed_since("no-such")

    def test_calls_of_a_trace_are_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(shrunk(Path(folder)), {})
            (Path(folder) / "a.trace").write_text("lgs-trace 2\npreserve 1 2\n# x\nadd a 0 0 1\ncommit\n\nremove a # x")
            self.assertEqual(shrunk(Path(folder)), {"calls": 2})


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


INSIDE = "void f() {{\n  {}\n}}\n"
IN_CLASS = "struct A {{\n  {}\n}};\n"


class Rules(unittest.TestCase):
    def check(self, rule: str, line: str, *expected: str, frame: str = INSIDE) -> None:
        """The line as each mutant of the rule has it."""
        text = frame.format(line)
        begin, after = text.index(line), len(text) - text.index(line) - len(line)
        mutants = [text[begin:c.start] + c.text + text[c.end:-after] for c in changes_of(text) if c.rule == rule]
        self.assertCountEqual(mutants, expected, line)

    def test_relational(self):
        self.check("relational", "a < b;", "a <= b;", "a >= b;")
        self.check("relational", "x = std::max<int>(a, b) == c;", "x = std::max<int>(a, b) != c;")
        self.check("relational", "bool operator<(const A& b) const;", frame=IN_CLASS)

    def test_arithmetic(self):
        self.check("arithmetic", "x = a - -b;", "x = a + -b;", "x = a - b;")
        self.check("arithmetic", "for (; i; ++i) n += 2;", "for (; i; --i) n += 2;", "for (; i; ++i) n -= 2;")
        self.check("arithmetic", 'text = "a" + b + "c";')
        self.check("arithmetic", "T* p = *q;")

    def test_bits(self):
        self.check("bits", "x &= ~(a >> 3 | b);", "x |= ~(a >> 3 | b);", "x &= (a >> 3 | b);", "x &= ~(a << 3 | b);",
                   "x &= ~(a >> 3 & b);")
        self.check("bits", "T&& x = f<A<B>>(y);")
        self.check("bits", "~A();", frame=IN_CLASS)

    def test_logical(self):
        self.check("logical", "if (!a && b) return;", "if (a && b) return;", "if (!a || b) return;")

    def test_constants(self):
        self.check("constants", "x = 4'096u;", "x = 4097u;", "x = 4095u;")
        self.check("constants", "x = 0x10;", "x = 17;", "x = 15;")
        self.check("constants", "x = 0;", "x = 1;", "x = (-1);")
        self.check("constants", "x = 0.5F;", "x = 1.5F;", "x = (-0.5F);")
        self.check("constants", "x = true;", "x = false;")
        self.check("constants", "f<3>('4', \"5\");  // 6")

    def test_conditions(self):
        self.check("conditions", "while (a && b) f();", "while (!(a && b)) f();")
        self.check("conditions", "if (const T* p = g(); p) f();", "if (const T* p = g(); !(p)) f();")
        self.check("conditions", "if (const T* p = g()) f();")
        self.check("conditions", "if (a == b) f();")  # it is a relational mutant
        self.check("conditions", "x = a ? b : c;", "x = a || true ? b : c;", "x = a && false ? b : c;")

    def test_statements(self):
        self.check("statements", "f(a); ++b;", "; ++b;", "f(a); ;")
        self.check("statements", "if (a) return b;", "if (a) ;")
        self.check("statements", "if (a) { b = c; }", "if (a) { ; }")
        self.check("statements", "for (int i = 0; i < n; ++i) a.b[i] = c;", "for (int i = 0; i < n; ++i) ;")
        self.check("statements", "sort(v, [](A a) { g(a); });", ";", "sort(v, [](A a) { ; });")
        for line in ("return b;", "const int a = b;", "std::vector<int> a(b);", "T& a = b;", "using A = B;",
                     "assert(a);", "int c = A{1}.b(2);"):
            self.check("statements", line)
        self.check("statements", "A() = default;", frame=IN_CLASS)

    def test_arguments(self):
        self.check("arguments", "f(a, g(b, c));", "f(g(b, c), a);", "f(a, g(c, b));")
        self.check("arguments", "return {a, b};", "return {b, a};")
        for line in ("x = std::max(a, b);", "f(a, a);", "void g(int a, T& b);", "std::pair<A, B> p;"):
            self.check("arguments", line)

    def test_what_is_left_alone(self):
        for line in ("assert(a < b + 1);", 'static_assert(sizeof(A) == 4, "1 < 2");', "// a < b + 1",
                     "/* f(a, b); */", "#define A (1 < 2)", "template <int N = 3>", "[[maybe_unused]] int a;",
                     'const auto a = R"(1 < 2)";'):
            self.assertEqual(changes_of(INSIDE.format(line)), [], line)


class Selection(unittest.TestCase):
    def select(self, *words: str) -> list:
        return run.select(run.parser().parse_args(words))

    def test_which(self):
        everything = self.select()
        self.assertEqual(self.select("--numbers", "3-4"), everything[3:5])
        self.assertEqual(self.select("--sample", "5", "--seed", "2"), self.select("--sample", "5", "--seed", "2"))
        self.assertNotEqual(self.select("--sample", "5", "--seed", "2"), self.select("--sample", "5", "--seed", "3"))
        self.assertEqual({bug.list for bug in self.select("--only", "^law1-")}, {"law1-exposure"})
        self.assertEqual({bug.file.split("/")[0] for bug in self.select("--score")}, {"lib", "oracle"})
        self.assertTrue(all(bug.fuzz for bug in self.select("--fuzz")))
        self.assertEqual([bug.group.tests for bug in self.select("--canary", "7")], [("Bulk/",)])
        self.assertEqual({mutant.component for mutant in self.select("--mutants", "--of", "brushes")}, {"brushes"})


class Mutants(unittest.TestCase):
    def test_every_folder_has_code(self):
        for name, (folders, _) in mutants.COMPONENTS.items():
            files = {mutant.file for mutant in mutants.mutants_of(name)}
            for folder in folders:
                self.assertTrue(any(file.startswith(f"{folder}/") for file in files), folder)

    def test_explanations_of_lines_that_are_gone_are_told(self):
        (file, was, now), why = next(iter(mutants.read_explained().items()))
        self.assertEqual(mutants.stale({(file, was, now): why}), [])
        self.assertEqual(len(mutants.stale({(file, was + "x", now): why, ("gone.cpp", was, now): why})), 2)


if __name__ == "__main__":
    unittest.main()
