#!/usr/bin/env python3
"""The farm (scripts/farm.py) with programs that pass, find, crash and are killed as they are told: what is counted, what
is lost, and what is told twice. scripts/farm/tests/trial.sh does the same with real schedulers."""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "scripts/farm"))
import findings
import ledger
import page
import work
from units import Unit, read_plan, split, split_fuzz

TRACE = """lgs-trace 3
preserve 1 2
add p1 0 0 1  0 0, 1 0, 1 1/4, 0 1
add p2 0 1 2  0 0, 1 0, 0.5 1 by fill
remove p1
"""
# Does what the file `plan` beside it says of a block: a word for each attempt.
PROGRAM = r'''#!/usr/bin/env python3
import json, os, pathlib, re, signal, sys
here = pathlib.Path(__file__).parent
number = re.search(r"Reference/(\d+)", sys.argv[1])[1]
words = json.loads((here / "plan").read_text())
word = words.get(number, ["pass"])
done = here / ("tried-" + number)
tries = len(done.read_text()) if done.exists() else 0
done.write_text("x" * (tries + 1))
word = word[min(tries, len(word) - 1)]
print("100 commits, 0 compared with CGAL, 100 with the naive reference; 300 edits, 3 refused; by door: add 1")
if word == "find":
    os.makedirs("out")
    pathlib.Path("out/a.svg").write_text("<svg>the picture</svg>")
    print("Law does not hold\n\n" + pathlib.Path(here / "trace").read_text() + "\nafter edit 2: the outline differs\n"
          "missing segment: (0, 0)\n\ntrace      out/a.trace\npicture    out/a.svg\nagain      LGS_TEST_SEED=1 it")
    sys.exit(1)
if word == "kill": os.kill(os.getpid(), signal.SIGKILL)
if word == "crash": os.kill(os.getpid(), signal.SIGSEGV)
if word == "strange": sys.exit(3)
'''


def moved(trace: str, chance: random.Random) -> str:
    """The same trace elsewhere: shifted, turned or mirrored, with other names and blocks."""
    turn, (di, dj) = chance.choice(findings.SYMMETRIES), (chance.randint(-9, 9), chance.randint(-9, 9))
    is_over = findings.SYMMETRIES.index(turn) > 3
    out, numbers, blocks = [], {}, {}
    for line in trace.splitlines():
        line, by, way = line.partition(" by ")
        words = line.replace(",", " ").split()
        if words[0] == "add":
            i, j, points = int(words[2]), int(words[3]), [Fraction(w) for w in words[5:]]
            ring = [turn(i + x, j + y) for x, y in zip(points[::2], points[1::2])]
            middle = turn(i + Fraction(1, 2), j + Fraction(1, 2))
            ci, cj = middle[0].__floor__(), middle[1].__floor__()
            ring = [(x - ci, y - cj) for x, y in ring][:: -1 if is_over else 1]
            start = chance.randrange(len(ring))
            ring = ring[start:] + ring[:start]
            name = numbers.setdefault(words[1], f"q{50 + len(numbers)}")
            words = ["add", name, str(ci + di), str(cj + dj), blocks.setdefault(words[4], str(70 + len(blocks))),
                     *(str(v) for point in ring for v in point)]
        elif words[0] == "remove":
            words[1] = numbers[words[1]]
        elif words[0] == "preserve":
            words[1:] = [blocks.setdefault(word, str(70 + len(blocks))) for word in words[1:]]
        out.append(" ".join(words) + by + way)
    return "\n".join(out) + "\n"


class Findings(unittest.TestCase):
    def test_a_trace_is_the_same_wherever_it_stands(self):
        chance = random.Random(1)
        for _ in range(200):
            self.assertEqual(findings.normal(TRACE), findings.normal(moved(TRACE, chance)))

    def test_other_traces_are_others(self):
        others = [TRACE.replace("1/4", "1/3"), TRACE.replace("remove p1", "remove p2"),
                  TRACE.replace("by fill", "by many"),
                  TRACE.replace("p2 0 1 2", "p2 0 1 1"), TRACE.replace("remove p1", "commit\nremove p1"),
                  TRACE.replace("add p1 0 0", "add p1 1 0"), TRACE.replace("preserve 1 2\n", "")]
        self.assertEqual(len({findings.normal(trace) for trace in [TRACE, *others]}), len(others) + 1)

    def test_strokes_are_moved_too(self):
        stroke = "lgs-trace 2\nadd p1 0 0 1  0 0 1 0 1 1 0 1\ncarve 0 0, 2 0, 2 1/2 | 1 1, 3 1, 2 3\n"
        shifted = "lgs-trace 2\nadd p1 5 7 1  0 0 1 0 1 1 0 1\ncarve 5 7, 7 7, 7 15/2 | 6 8, 8 8, 7 10\n"
        self.assertEqual(findings.normal(stroke), findings.normal(shifted))
        self.assertNotEqual(findings.normal(stroke), findings.normal(stroke.replace("1/2", "1/3")))


class Plans(unittest.TestCase):
    def test_units_share_the_work_out(self):
        units = split("c" * 40, "naive", 1001, 0.5, 7, 100) + split_fuzz("c" * 40, 100, 7)
        blocks = [k for unit in units if unit.kind == "naive" for k in range(unit.number, unit.number + unit.count)]
        self.assertEqual(blocks, list(range(1001)))
        self.assertEqual(len({unit.key for unit in units}), len(units))

    def test_a_bad_plan_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "plan"
            unit = Unit("c", "naive", 0, 1, 1, 1)
            for text in ("{", "[]", '{"kind": 1}', unit.line() + "\n" + unit.line(), unit.line().replace("naive", "xx")):
                path.write_text(text)
                with self.assertRaises(ValueError):
                    read_plan(path)


class Farm(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "proptests").mkdir()
        program = self.folder / "proptests/lgs_engine_tests"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        (self.folder / "proptests/trace").write_text(TRACE)
        self.plan = self.folder / "plan.jsonl"
        self.make_plan("c" * 40)

    def make_plan(self, commit, count=5):
        self.plan.write_text("".join(unit.line() + "\n" for unit in split(commit, "naive", count, 1.0, 1, 1)))

    def told(self, words):
        (self.folder / "proptests/plan").write_text(json.dumps(words))
        for path in (self.folder / "proptests").glob("tried-*"):
            path.unlink()

    def farm(self, *words):
        return subprocess.run([sys.executable, ROOT / "scripts/farm.py", *map(str, words)], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def run_units(self, *words):
        return self.farm("run", self.plan, *words, "--to", self.folder / "results", "--build", self.folder,
                         "--build-is-right", "--jobs", 2)

    def merge(self, *words):
        return self.farm("merge", self.plan, self.folder / "results", "--page", self.folder / "page", *words)

    def test_all_pass_and_are_counted_once(self):
        self.told({})
        self.assertEqual(self.run_units("0-2").returncode, 0)
        self.assertEqual(self.merge().returncode, 75, "two are missing")
        self.assertIn("## Never begun\n\n2 units.", (self.folder / "page.md").read_text())
        again = self.run_units()
        self.assertIn("3 units passed before; 2 to do", again.stdout)
        twins = list((self.folder / "results").glob("*.json"))
        (self.folder / "results" / "twin.json").write_text(twins[0].read_text())
        (self.folder / "results" / "half.part").write_text('{"unit": ')
        merged = self.merge()
        self.assertEqual(merged.returncode, 0, merged.stdout)
        self.assertIn("5 units: 5 passed, 0 with findings, 0 missing. 6 attempts. 500 commits", merged.stdout)

    def test_what_is_lost_is_neither_and_is_run_again(self):
        self.told({"1": ["kill", "pass"], "2": ["strange", "strange", "pass"]})
        self.assertEqual(self.run_units().returncode, 75)
        left = self.farm("show", self.plan, "--left", self.folder / "results").stdout
        self.assertEqual(left, "1\n2\n")
        self.assertEqual(self.run_units().returncode, 75)
        self.assertEqual(self.run_units().returncode, 0)
        self.assertEqual(self.merge().returncode, 0)
        text = (self.folder / "page.md").read_text()
        self.assertRegex(text, r"naive-1-n1[^\n]*\| 1 \| killed by SIGKILL \| yes")
        self.assertRegex(text, r"naive-2-n1[^\n]*\| 2 \| exit status 3")

    def test_a_finding_is_told_once_with_its_picture(self):
        self.told({"1": ["find"], "3": ["find"], "4": ["crash"]})
        ran = self.run_units("0", "1")
        self.assertEqual(ran.returncode, 42, ran.stdout)
        (self.folder / "proptests/trace").write_text(moved(TRACE, random.Random(3)))
        self.assertEqual(self.run_units("2-4").returncode, 42)
        merged = self.merge()
        self.assertEqual(merged.returncode, 42)
        self.assertEqual(len(re.findall(r"^finding ", merged.stdout, re.M)), 2, merged.stdout)
        self.assertRegex(merged.stdout, r"finding \w+: missing segment, 2 times")
        document = (self.folder / "page.html").read_text()
        self.assertEqual(document.count("the%20picture"), 1)
        self.assertNotRegex(document, r'(src|href)="http')

    def test_what_became_of_findings(self):
        self.told({"1": ["find"], "3": ["crash"]})
        self.run_units()
        before, old = self.folder / "before.jsonl", self.folder / "before"
        self.plan.rename(before)
        (self.folder / "results").rename(old)
        self.make_plan("d" * 40, 3)  # unit 3 is not run again
        self.told({"2": ["find"]})
        (self.folder / "proptests/trace").write_text(TRACE.replace("1/4", "1/3"))
        self.run_units()
        self.merge("--before", before, old)
        words = re.findall(r"^### .*\((\w+)\)$", (self.folder / "page.md").read_text(), re.M)
        self.assertEqual(sorted(words), ["new", "rare", "resolved"])
        self.told({"1": ["find"]})
        (self.folder / "proptests/trace").write_text(TRACE)
        self.make_plan("e" * 40, 3)
        self.run_units()
        self.merge("--before", before, old)
        self.assertIn("(ongoing)", (self.folder / "page.md").read_text())

    def test_a_unit_that_passes_and_fails_is_shown(self):
        self.told({"1": ["pass"]})
        self.run_units("1")
        result = json.loads(next((self.folder / "results").glob("*.json")).read_text())
        ledger.write(self.folder / "results", result | {"outcome": work.FINDING})
        self.merge()
        self.assertIn("## Passed and failed", (self.folder / "page.md").read_text())

    def test_a_canary_that_lives_makes_the_page_red(self):
        unit = Unit("c" * 40, "canary", 0, 1, 0.25, 5)
        result = {"unit": unit.key, "outcome": work.FINDING, "why": "", "findings": [], "figures": {}, "seconds": 1.0,
                  "cpu": 1.0, "memory": 1, "host": "here", "when": "2026-01-01T00:00:00Z"}
        for outcome, is_red in ((work.PASS, False), (work.FINDING, True)):
            shown = page.canary(ledger.Ledger([unit], [result | {"outcome": outcome}]))
            self.assertEqual(shown.startswith("RED"), is_red)
        self.assertTrue(page.canary(ledger.Ledger([unit], [])).startswith("RED"))

    def test_the_manifest_has_what_the_status_needs(self):
        text = (ROOT / "scripts/farm/kubernetes.yaml").read_text(encoding="utf-8")
        for field in ("apiVersion: batch/v1", "kind: Job", "completionMode: Indexed", "backoffLimitPerIndex: ",
                      "restartPolicy: Never", "action: FailIndex", "values: [42]", "$JOB_COMPLETION_INDEX"):
            self.assertEqual(text.count(field), 1, field)
        self.assertIn("name: " + re.search(r"containerName: (\w+)", text)[1] + "\n", text)

    def test_bad_usage_says_what_is_wrong(self):
        self.told({})
        for words in (["run", self.plan, "9", "--build-is-right"], ["run", self.plan, "x", "--build-is-right"],
                      ["run", self.folder / "none"], ["merge", self.plan, self.folder, "--before", self.plan]):
            done = self.farm(*words)
            self.assertEqual(done.returncode, 2, done.stdout)
        (self.folder / "results").mkdir()
        (self.folder / "results/bad.json").write_text("{}")
        self.assertIn("this is no result", self.merge().stdout)


if __name__ == "__main__":
    unittest.main()
