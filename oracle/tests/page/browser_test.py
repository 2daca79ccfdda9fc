#!/usr/bin/env python3
"""The page in a headless Chromium: steps, keys, pointers, sizes, colours, screenshots.

    oracle/tests/page/browser_test.py WRITE_PAGES [TEST...]    # WRITE_PAGES: the program of write_pages.cpp

Exit status 77, with a word, where Chromium or its driver is not installed.
"""
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

from browser import Browser, colours_of, missing

BLUE, ORANGE = (11, 95, 176), (194, 65, 12)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)

    def open(self, name="uncut-wall", width=1200, height=900, **features):
        self.browser.window(width, height, **features)
        self.browser.open(PAGES / f"{name}.html")

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [], "the browser complains")

    def run_script(self, expression, *arguments):
        return self.browser.run(f"return {expression}", *arguments)

    def text(self, selector):
        self.assertTrue(self.run_script("document.querySelector(arguments[0]).checkVisibility()", selector), selector)
        return self.run_script("document.querySelector(arguments[0]).innerText", selector)

    def texts(self, selector):
        return self.run_script("[...document.querySelectorAll(arguments[0])].map((e) => e.textContent)", selector)

    def count(self, selector):
        return self.run_script("document.querySelectorAll(arguments[0]).length", selector)

    def middle(self, selector):
        box = self.run_script("document.querySelector(arguments[0]).getBoundingClientRect().toJSON()", selector)
        return box["left"] + box["width"] / 2, box["top"] + box["height"] / 2

    def hover(self, selector):
        self.browser.pointer(("move", *self.middle(selector)))

    def hit(self, words):
        """The segment whose label begins like this."""
        return f'.hit[aria-label^="{words}"]'

    def assert_step(self, number):
        self.assertTrue(self.text("#status").startswith(f"Step {number} of 7"), self.text("#status"))
        self.assertEqual(self.run_script("document.querySelector('[aria-current]').dataset.step"), str(number))

    # --- Steps ---

    def test_begins_at_the_mismatch(self):
        self.open()
        self.assert_step(7)
        self.assertEqual(self.text("h1"), "the outline differs from the naive reference's")
        self.assertEqual(self.text("#findings"), "7 differences")
        self.assertEqual(self.count("#differences button"), 7)
        self.assertEqual([self.count(f"#drawing .segment.{kind}") for kind in ("same", "missing", "extra", "other")],
                         [2, 2, 1, 4])

    def test_steps_by_keys(self):
        self.open()
        for key, step in (("Left", 6), ("Left", 5), ("Right", 6), ("Home", 0), ("Left", 0), ("End", 7), ("Right", 7)):
            self.browser.press(key)
            self.assert_step(step)

    def test_steps_by_buttons(self):
        self.open()
        for button, step in (("#back", 6), ("#first", 0), ("#next", 1), ("#last", 7), ('[data-step="3"]', 3)):
            self.browser.click(button)
            self.assert_step(step)
        self.browser.click("#first")
        self.assertEqual([self.run_script("document.querySelector(arguments[0]).disabled", button)
                          for button in ("#first", "#back", "#next", "#last")], [True, True, False, False])

    def test_shows_the_world_of_each_step(self):
        self.open()
        found = []
        self.browser.press("Home")
        for _ in range(8):
            found.append((self.count(".solid"), self.count(".added"), self.count(".removed"), self.count(".hit")))
            self.browser.press("Right")
        # Polygons that stood there, that are added, that are removed; segments of the last commit.
        self.assertEqual(found, [(0, 0, 0, 0), (0, 1, 0, 0), (1, 0, 0, 4), (1, 1, 0, 4), (2, 0, 0, 4), (2, 1, 0, 4),
                                 (2, 0, 1, 4), (2, 0, 0, 9)])

    def test_says_when_the_outline_is_an_older_one(self):
        self.open()
        self.browser.press("Left")
        self.assertIn("not committed: the outline is of commit 1", self.text("#status"))
        self.assertEqual(self.text("#differences"), "Not committed yet.")
        self.assertEqual(self.count(".outline.past"), 1)

    def test_plays_by_space_and_stops_at_the_end(self):
        self.open()
        self.browser.press("Home", "Right", "Right", "Right", "Right", "Right", "Space")
        self.assertEqual(self.text("#play"), "Stop")
        deadline = time.monotonic() + 20
        while self.text("#play") == "Stop" and time.monotonic() < deadline:
            time.sleep(0.1)
        self.assert_step(7)
        self.assertEqual(self.text("#play"), "Play")

    # --- Segments and sentences ---

    def test_hovering_a_segment_tells_all_of_it(self):
        self.open()
        self.hover(self.hit("(0, 1) → (0, 0)"))
        words = self.text("#segment")
        for part in ("(0, 1) → (0, 0)", "the left side of cell (0, 0)", "block", "floor, cell (0, 0)", "ghost1 ≠",
                     "(0.5, 1)", "(1, 1)", "ghost2", "naive reference", "engine"):
            self.assertIn(part, words)
        self.assertEqual(self.count(".halo"), 1)
        self.assertEqual(self.texts(".highlight text"), ["ghost1 expected", "ghost1 actual", "ghost2"])
        self.assertEqual([self.count(f".dot.{kind}") for kind in ("missing", "extra", "plain")], [1, 1, 1])
        self.browser.press("1")
        self.assertEqual(self.texts(".highlight text"), ["ghost1 expected", "ghost2 expected"])
        self.browser.pointer(("move", 5, 5))
        self.assertEqual(self.count(".halo") + self.count(".dot"), 0)

    def test_a_sentence_lights_its_segment(self):
        self.open()
        self.hover("#differences li:first-child button")
        lit = self.run_script("document.querySelector('.hit.lit').ariaLabel")
        self.assertTrue(lit.startswith("(0.5, 1) → (0, 1)"), lit)
        self.assertEqual(self.count(".lit"), 2)

    def test_a_segment_lights_its_sentences(self):
        self.open()
        self.hover(self.hit("(0.5, 1) → (1, 1.5)"))
        self.assertEqual(self.count("#differences .lit"), 1)
        self.assertTrue(self.text("#differences .lit").startswith("wrong ghost1 at (0.5, 1)"))

    def test_the_keyboard_reaches_segments_and_follows_links(self):
        self.open()
        self.browser.run("document.querySelector(arguments[0]).focus()", self.hit("(0, 1) → (0, 0)"))
        self.assertIn("(0, 1) → (0, 0)", self.text("#segment"))
        self.browser.press("n")
        self.assertIn("(0, 0) → (1, 0)", self.text("#segment"))
        self.browser.press("p", "p")
        self.assertIn("(1, 1) → (0, 1)", self.text("#segment"), "the engine's predecessor is the extra segment")
        self.browser.press("Tab")
        self.assertNotIn("(1, 1) → (0, 1)", self.text("#segment"))

    def test_shows_one_outline_or_both(self):
        self.open()
        self.browser.click("#expected")
        self.assertEqual((self.count(".hit"), self.count(".segment.expected"), self.count(".ring")), (8, 8, 0))
        self.browser.press("2")
        self.assertEqual((self.count(".hit"), self.count(".segment.actual")), (7, 7))
        self.assertEqual(self.run_script("document.querySelector('#actual').ariaPressed"), "true")
        self.browser.press("3")
        self.assertEqual((self.count(".hit"), self.count(".ring")), (9, 3))

    def test_points_out_what_is_to_blame_where_no_outline_differs(self):
        self.open("wrong-refusal")
        self.assertEqual(self.count(".marked"), 1)
        self.assertIn("in the report", self.text("#differences"))
        self.assertIn("add c is refused", self.text("#report"))
        self.assertEqual(self.text("#preserve"), "preserve 1 2")
        self.assertGreater(self.count(".link.one-sided"), 0)

    def test_says_when_there_is_one_outline_only(self):
        self.open("crash")
        self.assertEqual(self.text("#differences"), "There is only one outline, that of the naive reference.")
        self.assertEqual(self.count("#drawing .segment.same"), 8)
        self.assertFalse(self.run_script("document.querySelector('#expected').checkVisibility()"))

    # --- The view ---

    def test_drags_and_zooms(self):
        self.open()
        x, y = self.middle(self.hit("(0, 1) → (0, 0)"))
        self.browser.pointer(("move", x + 60, y), ("down",), ("move", x + 160, y + 50), ("up",))
        moved = self.middle(self.hit("(0, 1) → (0, 0)"))
        self.assertAlmostEqual(moved[0], x + 100, delta=1)
        self.assertAlmostEqual(moved[1], y + 50, delta=1)
        height = "document.querySelector(arguments[0]).getBBox().height"
        before = self.run_script(height, self.hit("(0, 1) → (0, 0)"))
        self.browser.press("+")
        self.assertAlmostEqual(self.run_script(height, self.hit("(0, 1) → (0, 0)")), 1.5 * before, delta=0.1)
        self.browser.press("0")
        self.assertAlmostEqual(self.middle(self.hit("(0, 1) → (0, 0)"))[0], x, delta=1)

    def test_shows_far_cells_as_exactly_as_near_ones(self):
        self.open("ends-of-the-world")
        self.browser.run("""
            const drawing = document.querySelector("#drawing");
            const { left, top } = drawing.getBoundingClientRect();
            const corner = document.querySelector('.hit[aria-label^="(1073741824+1/65536, 1073741824)"]');
            const { x, y, height } = corner.getBBox();
            const cornerAt = { clientX: left + x, clientY: top + y + height };
            drawing.dispatchEvent(new WheelEvent("wheel", { deltaY: -2300, ...cornerAt }));
            """)  # about 300 times as large, around the corner
        lines = self.run_script("[...document.querySelectorAll('.grid')].map(line => line.getAttribute('d'))[0]")
        corner = self.run_script("document.querySelector('.hit').getAttribute('d')")
        line, start = float(lines[1:].split(" ")[0]), float(corner[1:].split(" ")[0])
        self.assertTrue(0.3 < start - line < 1, f"a lattice unit from {line} to {start}")

    def test_goes_where_the_step_is(self):
        self.open("ends-of-the-world")
        self.assertEqual(self.count('[data-polygon="east"]'), 1)
        self.browser.press("Home", "Right")
        self.assertEqual((self.count('[data-polygon="west"]'), self.count('[data-polygon="east"]')), (1, 0))

    def test_says_that_a_long_trace_is_an_excerpt(self):
        self.open("long")
        self.assertIn("too long to show all of it", self.text("#note"))
        self.browser.press("Left", "Left")
        self.assertTrue(self.text("#status").startswith("Step 998 of 1000"))
        scrolled = self.run_script("document.querySelector('#edits').scrollTop > 1000 && window.scrollY === 0")
        self.assertTrue(scrolled, "the list goes along, and the page stays")

    # --- Texts, sizes, colours ---

    def test_texts_do_not_become_markup(self):
        self.open("markup")
        self.assertIn("</script><img/src=x/onerror=window.broken=1>&amp;", self.text("h1"))
        self.assertIn("</script><img", self.text('[data-step="1"]'))
        self.assertEqual(self.text("#expected"), "<b>expected</b>")
        self.assertEqual(self.count("img") + self.count("#expected b"), 0)
        self.assertIsNone(self.run_script("window.broken"))

    def test_loads_nothing(self):
        self.open()
        self.assertEqual(self.run_script("performance.getEntriesByType('resource').length"), 0)
        blocked = self.browser.run("return fetch('data:,x').then(() => 'loaded', () => 'blocked')")
        self.assertEqual(blocked, "blocked", "the page's policy")
        self.assertIn("Content Security Policy", " ".join(self.browser.complaints()))

    def test_fits_a_phone(self):
        for name in ("uncut-wall", "markup", "long"):
            self.open(name, 360, 740)
            self.assertLessEqual(self.run_script("document.documentElement.scrollWidth"), 360, name)
            self.assertGreater(self.run_script("document.querySelector('#drawing').clientWidth"), 320)

    def test_can_be_read_in_light_and_dark(self):
        contrast = """
            const linear = (part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
            const light = (colour) => {
              const [r, g, b] = colour.match(/[0-9.]+/g).map((part) => linear(part / 255));
              return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05;
            };
            const page = light(getComputedStyle(document.body).backgroundColor);
            return arguments[0].map((selector) => {
              const ink = light(getComputedStyle(document.querySelector(selector)).color);
              return Math.max(ink, page) / Math.min(ink, page);
            });"""
        texts = ["h1", "#differences button", "strong.missing", "strong.extra", ".quiet", ".wrong", "#legend"]
        for scheme in ("light", "dark"):
            self.open(color_scheme=scheme)
            for selector, ratio in zip(texts, self.browser.run(contrast, texts)):
                self.assertGreater(ratio, 4.5, f"{selector}, {scheme}")  # WCAG AA

    def test_honours_reduced_motion(self):
        self.open()
        self.browser.run("""
            window.moves = [];
            addEventListener("animationstart", ({ animationName }) => moves.push(animationName));""")
        frames = """
            new Promise((done) => {
              requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)));
            })"""
        for motion, moves in (("no-preference", ["arrive"]), ("reduce", ["arrive"])):
            self.browser.window(1200, 900, reduced_motion=motion)
            self.browser.press("Home", "Right")
            self.run_script(frames.strip())  # an animation begins with a frame
            self.assertEqual(self.run_script("moves"), moves, motion)

    def test_the_screen_shows_what_differs(self):
        self.open()
        x, y = map(round, self.middle(self.hit("(0.5, 1) → (0, 1)")))
        for key, there, other in (("1", BLUE, ORANGE), ("2", ORANGE, BLUE)):
            self.browser.press(key)
            seen = colours_of(self.browser.screenshot(x + 14, y - 3, 14, 6))  # beside the arrows
            self.assertIn(there, seen, key)
            self.assertNotIn(other, seen, key)


if __name__ == "__main__":
    if missing():
        print(f"skipped: {' and '.join(missing())} not installed (scripts/setup.sh chromium-driver)")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        PAGES = pathlib.Path(folder)
        subprocess.run([sys.argv.pop(1), folder], check=True, stdout=subprocess.DEVNULL)
        unittest.main()
