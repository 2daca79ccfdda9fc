#!/usr/bin/env python3
"""The farm (scripts/farm.py) with programs that pass, find, crash, hang and are killed as they are told: what is counted,
what is lost, and what is told once."""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "scripts/farm"))
import ledger
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
import json, os, pathlib, re, signal, sys, time
here = pathlib.Path(__file__).parent
number = re.search(r"Reference/(\d+)", sys.argv[1])[1]
words = json.loads((here / "plan").read_text())
word = words.get(number, ["pass"])
done = here / ("tried-" + number)
tries = len(done.read_text().split()) if done.exists() else 0
with done.open("a") as file: file.write(f"{os.getpid()} ")
word = word[min(tries, len(word) - 1)]
print("100 commits, 0 compared with CGAL, 100 with the naive reference; 300 edits, 3 refused; by door: add 1")
if word == "find":
    print("Law does not hold\n\n" + pathlib.Path(here / "trace").read_text() + "\nafter edit 2: the outline differs\n"
          "missing segment: (0, 0)\n\ntrace      out/a.trace\npicture    out/a.svg\nagain      LGS_TEST_SEED=1 it")
    sys.exit(1)
if word == "kill": os.kill(os.getpid(), signal.SIGKILL)
if word == "crash": os.kill(os.getpid(), signal.SIGSEGV)
if word == "strange": sys.exit(3)
if word == "hang": time.sleep(600)
'''


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
        self.plan, self.results = self.folder / "plan.jsonl", self.folder / "results"
        self.plan.write_text("".join(unit.line() + "\n" for unit in split("c" * 40, "naive", 5, 1.0, 1, 1)))

    def told(self, words):
        (self.folder / "proptests/plan").write_text(json.dumps(words))
        for path in (self.folder / "proptests").glob("tried-*"):
            path.unlink()

    def farm(self, *words):
        return subprocess.run([sys.executable, ROOT / "scripts/farm.py", *map(str, words)], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def words_to_run(self, *words):
        return ["run", self.plan, *words, "--to", self.results, "--build", self.folder, "--build-is-right", "--jobs", 2]

    def run_units(self, *words):
        return self.farm(*self.words_to_run(*words))

    def merge(self):
        return self.farm("merge", self.plan, self.results)

    def test_all_pass_and_are_counted_once(self):
        self.told({})
        self.assertEqual(self.run_units("0-2").returncode, 0)
        merged = self.merge()
        self.assertEqual(merged.returncode, 75, "two are missing")
        self.assertEqual(merged.stdout.count("never begun"), 2)
        again = self.run_units()
        self.assertIn("3 units passed before; 2 to do", again.stdout)
        twins = list(self.results.glob("*.json"))
        (self.results / "twin.json").write_text(twins[0].read_text())
        (self.results / "half.part").write_text('{"unit": ')
        merged = self.merge()
        self.assertEqual(merged.returncode, 0, merged.stdout)
        self.assertIn("5 passed, 0 with findings, 0 missing. 500 commits", merged.stdout)

    def test_what_is_lost_is_neither_and_is_run_again(self):
        self.told({"1": ["kill", "pass"], "2": ["strange", "strange", "pass"]})
        self.assertEqual(self.run_units().returncode, 75)
        left = self.farm("show", self.plan, "--left", self.results).stdout
        self.assertEqual(left, "1\n2\n")
        self.assertRegex(self.merge().stdout, r"naive-1-n1[^\n]*killed by SIGKILL\n.*naive-2-n1[^\n]*exit status 3")
        self.assertEqual(self.run_units().returncode, 75)
        self.assertEqual(self.run_units().returncode, 0)
        self.assertEqual(self.merge().returncode, 0)

    def test_a_finding_is_told_once(self):
        self.told({"1": ["find"], "3": ["find"], "4": ["crash"]})
        ran = self.run_units("0", "1")
        self.assertEqual(ran.returncode, 42, ran.stdout)
        self.assertEqual(self.run_units("2-4").returncode, 42)
        merged = self.merge()
        self.assertEqual(merged.returncode, 42)
        self.assertEqual(re.findall(r"^## Found (\d) times", merged.stdout, re.M), ["1", "2"], merged.stdout)
        self.assertIn(TRACE + "\nafter edit 2: the outline differs\nmissing segment: (0, 0)\n```", merged.stdout)

    def test_a_unit_that_passes_and_fails_is_shown(self):
        self.told({"1": ["pass"]})
        self.run_units("1")
        result = json.loads(next(self.results.glob("*.json")).read_text())
        ledger.write(self.results, result | {"outcome": work.FINDING, "finding": "x"})
        self.assertIn("passed and failed", self.merge().stdout)

    def test_one_interrupt_ends_it_at_once_and_keeps_what_passed(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            self.told({"1": ["hang"], "2": ["hang"]})  # two at work: units 3 and 4 are never begun
            words = [sys.executable, ROOT / "scripts/farm.py", *map(str, self.words_to_run())]
            farm = subprocess.Popen(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            hanging = [self.folder / f"proptests/tried-{k}" for k in (1, 2)]
            for _ in range(600):
                if all(path.is_file() and path.read_text() for path in hanging):
                    break
                time.sleep(0.05)
            begin = time.monotonic()
            farm.send_signal(signal_number)
            out, _ = farm.communicate(timeout=20)
            self.assertEqual(farm.returncode, 130, out)
            self.assertLess(time.monotonic() - begin, 5)
            self.assertEqual([path.name.split(".")[0].split("-")[2] for path in self.results.glob("*.json")], ["0"])
            for path in hanging:
                with self.assertRaises(ProcessLookupError):
                    os.kill(int(path.read_text().split()[-1]), 0)
        self.told({})
        self.assertIn("1 units passed before; 4 to do", self.run_units().stdout)

    def test_a_canary_that_lives_makes_the_run_red(self):
        unit = Unit("c" * 40, "canary", 0, 1, 0.25, 5)
        result = {"unit": unit.key, "outcome": work.FINDING, "why": "", "finding": "x", "again": "", "figures": {},
                  "seconds": 1.0, "cpu": 1.0, "host": "here", "when": "2026-01-01T00:00:00Z"}
        for attempts, is_red in (([result | {"outcome": work.PASS}], False), ([result], True), ([], True)):
            known = ledger.Ledger([unit], {unit.key: attempts})
            self.assertEqual("RED" in known.told(), is_red)
            self.assertEqual(known.dead_canaries() != [], is_red)

    def test_bad_usage_says_what_is_wrong(self):
        self.told({})
        for word, sentence in (("9", "there is no unit 9"), ("x", "is no index"), ("5-3", "ends before it begins"),
                               ("0-99999999999", "there is no unit 99999999999"), ("9" * 5000, "is no index"),
                               ("-", "is no index"), ("1-", "is no index")):
            done = self.run_units(word)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(sentence, done.stdout)
            self.assertNotIn("Traceback", done.stdout)
        self.assertEqual(self.farm("run", self.folder / "none").returncode, 2)
        self.results.mkdir()
        (self.results / "bad.json").write_text("{}")
        self.assertIn("this is no result", self.merge().stdout)


if __name__ == "__main__":
    unittest.main()
