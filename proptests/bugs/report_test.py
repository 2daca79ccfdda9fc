#!/usr/bin/env python3
"""run.py --report writes into the tables of a page, and leaves everything else as it was."""

import unittest

import tables
from listed import Bug, Group

GROUPS = {"law1": Group("Law 1", "tests", ("A.",)), "law2": Group("Law 2", "tests", ("B.",))}
BUGS = [Bug("law1", name, f"a game with {name}", f"lib/ground/{name}.cpp", "x", "y", None)
        for name in ("one", "two", "new")]
BUGS.append(Bug("law2", "other", "a game", "lib/outline/other.cpp", "x", "y", None))
PAGE = """# Planted bugs

Written by hand.

<!-- planted: summary -->
7 bugs are listed.
<!-- end -->

## Law 1

By hand, too.

<!-- planted: law1 -->
| bug | what a game suffers | in | found by | case | edits |
|---|---|---|---|---:|---:|
| one | old words | `old.cpp` | `A.Finds` | 3 | 2 |
| two | old words | `two.cpp` | `A.Finds`, which crashes |  |  |
| gone | old words | `gone.cpp` | `A.Finds` | 1 | 1 |
<!-- end -->

The end, by hand.
"""
FOUND = {"verdict": "found", "test": "A.FindsIt", "cases": 7, "shrunk_edits": 1}


class Report(unittest.TestCase):
    def setUp(self):
        self.page = tables.planted(PAGE, GROUPS, BUGS, {BUGS[1]: FOUND})

    def test_leaves_what_people_wrote(self):
        for words in ("Written by hand.\n", "## Law 1\n\nBy hand, too.\n", "\nThe end, by hand.\n"):
            self.assertIn(words, self.page)

    def test_keeps_the_outcome_of_a_bug_that_was_not_tried(self):
        self.assertIn("| one | a game with one | `one.cpp` | `A.Finds` | 3 | 2 |\n", self.page)

    def test_has_the_new_outcome_of_one_that_was(self):
        self.assertIn("| two | a game with two | `two.cpp` | `A.FindsIt` | 7 | 1 |\n", self.page)
        self.assertNotIn("crashes", self.page)

    def test_has_a_row_for_a_bug_that_came_and_none_for_one_that_went(self):
        self.assertIn("| new | a game with new | `new.cpp` | not in a run yet |  |  |\n", self.page)
        self.assertNotIn("gone", self.page)

    def test_has_a_table_for_a_group_that_came(self):
        self.assertIn("## Law 2\n\n<!-- planted: law2 -->\n| bug |", self.page)

    def test_counts(self):
        self.assertIn("4 bugs are listed; 2 were found, 2 of them by a test of their law; 2 not in a run yet.\n",
                      self.page)

    def test_does_nothing_the_second_time(self):
        self.assertEqual(tables.planted(self.page, GROUPS, BUGS, {}), self.page)


if __name__ == "__main__":
    unittest.main()
