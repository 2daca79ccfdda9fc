#!/usr/bin/env python3
"""Asks `lgs oracle` about small worlds, as a test suite of others would. The answers are worked out by hand.

    oracle/tests/engines/oracle_client_test.py LGS [TEST...]
"""
import pathlib
import subprocess
import sys
import threading
import unittest

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/harness.md"
U = 65536  # lattice units, in a cell
SQUARE = "0 0 1 0 1 1 0 1"


class Oracle:
    """A client: write(), then answer() for each commit, and end()."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([LGS, "oracle", *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.limit = threading.Timer(20, self.process.kill)  # a read that waits in vain fails then
        self.limit.daemon = True
        self.limit.start()

    def write(self, *lines):
        self.process.stdin.write("".join(line + "\n" for line in lines).encode())
        self.process.stdin.flush()

    def read(self):
        """The next line. The input stays open, so there is none if the oracle does not flush."""
        return self.process.stdout.readline().decode().rstrip("\n")

    def answer(self):
        """What was refused, and the outline: {(start x, y, end x, y): (ghost 1, ghost 2, block)}."""
        refused, outline = [], {}
        for word, *rest in map(str.split, iter(self.read, "end")):
            if word == "refused":
                refused.append((rest[0], " ".join(rest[1:])))
            elif word == "segment":
                outline[tuple(map(int, rest[:4]))] = " ".join(rest[4:6]), " ".join(rest[6:8]), int(rest[8])
            else:
                raise ValueError(" ".join([word, *rest]))
        return refused, outline

    def end(self):
        """The exit status, and what was left to read."""
        rest, _ = self.process.communicate()
        self.limit.cancel()
        return self.process.returncode, rest.decode()


class Client(unittest.TestCase):
    def ask(self, *lines, oracle="both"):
        """The answer to one commit of a new oracle, which must be all that it says."""
        asked = Oracle("--oracle", oracle)
        asked.write(*lines, "commit")
        answer = asked.answer()
        self.assertEqual(asked.end(), (0, ""))
        return answer

    def test_greets(self):
        for which, preserve in (("both", "preserve "), ("naive", "preserve "), ("cgal", "")):
            oracle = Oracle("--oracle", which)
            oracle.write("lgs-engine 1")
            self.assertEqual(oracle.read(), f"lgs-engine 1 oracle ghosts blocks several slants {preserve}refuses")
            self.assertEqual(oracle.end(), (0, ""))

    def test_says_what_the_page_says(self):
        passage = PAGE.read_text(encoding="utf-8").split("## Ask the oracle\n")[1]
        _, asked, _, answered, _ = passage.split("```\n", 4)
        done = subprocess.run([LGS, "oracle"], input=asked, stdout=subprocess.PIPE, text=True, check=True)
        self.assertEqual(done.stdout, answered)

    def test_refuses_in_the_order_of_the_edits(self):
        refused, outline = self.ask(
            "remove ghost", f"add a 0 0 1 {SQUARE}", "add b 0 0 2 0 0 1 0 1 1", "add a 5 5 1 0 0 1 0 1 1",
            "add c 0 1 1 0 0 1 1 1 0", "add d 0 1 1 0 0 2 0 1 1", "add e 0 1 1 0 0 1 0", "add f 0 1 1",
            "add g 0 1 1 0 0 1 0 1/2 0", "add h 0 1 1 0 0 1 0 1 0 1 1", "add i 0 1 1 0 0 1 0 0.25 0.5 1 1")
        self.assertEqual(refused, [
            ("ghost", "unknown name"), ("b", "overlap"), ("a", "name in use"), ("c", "clockwise"),
            ("d", "outside the cell"), ("e", "too few vertices"), ("f", "too few vertices"), ("g", "zero area"),
            ("h", "repeated vertex"), ("i", "self-intersecting")])
        self.assertEqual(len(outline), 4)

    def test_a_refusal_is_told_once_and_changes_nothing(self):
        oracle = Oracle()
        oracle.write(f"add a 0 0 1 {SQUARE}", f"add b 0 0 2 {SQUARE}", "commit", "commit")
        first, second = oracle.answer(), oracle.answer()
        self.assertEqual(first[0], [("b", "overlap")])
        self.assertEqual(second, ([], first[1]))
        oracle.write("remove a", f"add b 0 0 2 {SQUARE}", "commit")
        refused, outline = oracle.answer()
        self.assertEqual(refused, [])
        self.assertEqual({block for _, _, block in outline.values()}, {2})
        self.assertEqual(oracle.end(), (0, ""))

    def test_reset_forgets(self):
        oracle = Oracle()
        oracle.write("preserve 1 2", f"add a 0 0 1 {SQUARE}", f"add a 0 0 1 {SQUARE}", "reset", "commit")
        self.assertEqual(oracle.answer(), ([], {}))
        oracle.write("reset # and the relation", f"add a 0 0 1 {SQUARE}", f"add b 1 0 2 {SQUARE}", "commit")
        refused, outline = oracle.answer()
        self.assertEqual((refused, len(outline)), ([], 6))
        self.assertEqual(oracle.end(), (0, ""))

    def test_takes_what_traces_may_have(self):
        _, outline = self.ask("# a comment", "", " \t", "reset\r", "add a\t0 0 1  0 0, 1 0, 2/2 1.0, 0 1e0  # so\r")
        self.assertEqual(sorted(outline), [(0, 0, U, 0), (0, U, 0, 0), (U, 0, U, U), (U, U, 0, U)])

    def test_a_bad_line_is_named_and_changes_nothing(self):
        good = "preserve 1 2", f"add a 0 0 1 {SQUARE}", f"add b 1 0 2 {SQUARE}"
        right = self.ask(*good)
        for line, says in (
                ("hello", "unknown word; a line starts with lgs-engine, reset, preserve, add, remove, commit or #"),
                ("lgs-engine 2", "the greeting is 'lgs-engine 1'; this is the only version there is"),
                ("reset now", "reset stands alone on its line"),
                ("preserve 1 3", "preserve must stand before the first edit; reset begins a new world"),
                ("preserve 1", "preserve needs two blocks; found 1"),
                ("add c 0 0 1 0 0 1", "3 coordinates: they come in pairs x y, so one is missing or one too many"),
                ("add c 0 0 1 0 0 1 0 x 1", "the x of vertex 2, 'x': not a number"),
                ("remove", "remove needs one name; found 0"),
                ("remove a b", "remove needs one name; found 2"),
                ("commit b", "commit stands alone on its line; found 'b' after it"),
                ("remove a\0", "byte 0x00 in the line: a trace is plain text"),
                ("remove " + "a" * (1 << 21), "the line is longer than 1048576 bytes")):
            with self.subTest(line=line[:40]):
                oracle = Oracle()
                oracle.write(*good, line)
                self.assertEqual(oracle.read(), f"error 4: {says}")
                oracle.write("commit")
                self.assertEqual(oracle.answer(), right)
                self.assertEqual(oracle.end(), (2, ""))

    def test_cgal_alone_knows_no_preserve_relation(self):
        oracle = Oracle("--oracle", "cgal")
        oracle.write("preserve 1 2")
        self.assertEqual(oracle.read(), "error 1: CGAL alone can not judge a preserve relation; "
                                        "start lgs oracle with --oracle both or naive")
        self.assertEqual(oracle.end(), (2, ""))

    def test_what_is_not_committed_has_no_answer(self):
        oracle = Oracle()
        oracle.write(f"add a 0 0 1 {SQUARE}", f"add a 0 0 1 {SQUARE}")
        self.assertEqual(oracle.end(), (0, ""))


if __name__ == "__main__":
    LGS = sys.argv.pop(1)
    unittest.main()
