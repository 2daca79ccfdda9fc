"""The plots of docs/timings.md, as SVG files by name."""

from math import ceil, floor, log10

from svg import COLOURS, GRID, INK, MUTED, PAPER, Svg
from tables import NAMES, PUBLISHED, RECOMPUTE, SIZES, WORLDS
from words import count, duration

WIDTH, HEIGHT = 860, 520
LEFT, TOP, RIGHT, BOTTOM = 84, 88, 640, 468  # of the frame; names stand on its right


def plain(name):
    return name.replace("*", "").replace("`", "")


def decade_in_words(decade):
    """10 to this, in nanoseconds: '10 µs'."""
    return duration(10**decade).replace(".0 ", " ")


class LogLog:
    """A frame with a logarithmic scale on both axes: decades on the grid, a name beside the end of each line."""

    def __init__(self, title, description, lines):
        """`lines`: (name, {x: y}, colour, dashes) each."""
        lines = [line for line in lines if line[1]]
        self.svg = Svg(WIDTH, HEIGHT, title, description)
        xs = [x for _, points, _, _ in lines for x in points] or [1, 10]
        ys = [y for _, points, _, _ in lines for y in points.values()] or [1, 10]
        self.x0, self.x1 = log10(min(xs)), max(log10(max(xs)), log10(min(xs)) + 1)
        self.y0, self.y1 = floor(log10(min(ys))), max(ceil(log10(max(ys))), floor(log10(min(ys))) + 1)
        self._frame()
        for _, points, colour, dashes in lines:
            path = [self._at(x, y) for x, y in sorted(points.items())]
            self.svg.line(path, stroke=colour, stroke_width=2, stroke_dasharray=dashes, stroke_linejoin="round")
            for x, y in path:
                self.svg.dot(x, y, 3.0, fill=colour)
        self._names(lines)

    def _at(self, x, y):
        return (
            LEFT + (log10(x) - self.x0) / (self.x1 - self.x0) * (RIGHT - LEFT),
            BOTTOM - (log10(y) - self.y0) / (self.y1 - self.y0) * (BOTTOM - TOP),
        )

    def _frame(self):
        self.svg.rect(LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP, fill=PAPER, stroke=GRID, stroke_opacity=0.5)
        for decade in range(self.y0, self.y1 + 1):
            _, y = self._at(10**self.x0, 10**decade)
            self.svg.line([(LEFT, y), (RIGHT, y)], stroke=GRID, stroke_opacity=0.35, stroke_width=0.75)
            self.svg.text(LEFT - 8, y + 4, decade_in_words(decade), fill=MUTED, anchor="end")
        for decade in range(ceil(self.x0), floor(self.x1) + 1):
            x, _ = self._at(10**decade, 10**self.y0)
            self.svg.line([(x, TOP), (x, BOTTOM)], stroke=GRID, stroke_opacity=0.35, stroke_width=0.75)
            self.svg.text(x, BOTTOM + 18, count(10**decade), fill=MUTED, anchor="middle")
        self.svg.text((LEFT + RIGHT) / 2, BOTTOM + 38, "cells of the world", fill=MUTED, anchor="middle")

    def _names(self, lines):
        """Beside the ends of the lines, pushed apart where they would overlap, with a thin line where they moved."""
        ends = []
        for name, points, colour, _ in lines:
            x, y = self._at(max(points), points[max(points)])
            ends.append([y, x, y, name, colour])
        ends.sort()
        for k in range(1, len(ends)):
            ends[k][0] = max(ends[k][0], ends[k - 1][0] + 15)
        for k in range(len(ends) - 1, -1, -1):
            ends[k][0] = min(ends[k][0], BOTTOM - 15 * (len(ends) - 1 - k))
        for label, x, y, name, colour in ends:
            self.svg.line([(x + 5, y), (RIGHT + 10, label)], stroke=colour, stroke_width=0.75, stroke_opacity=0.5)
            self.svg.text(RIGHT + 14, label + 4, name, fill=colour)


def edit_time(results):
    lines = []
    for (world, name), colour in zip(WORLDS.items(), COLOURS):
        for bench, where, dashes in (("remove-add", "anywhere", "none"), ("dig", "nearby", "5 4")):
            rows = {size: results.of(f"edit/{bench}/{world}/{size}") for size in SIZES}
            points = {size: row["first_median_ns"] for size, row in rows.items() if row}
            lines.append((f"{name}, {where}", points, colour, dashes))
    text = "Removing the content of one cell, with commit and change list: median. Nearby: as a player digs."
    return LogLog("An edit's time against the world's size", text, lines).svg.finish()


def incremental(results):
    def points(scenario, subject):
        found = {side: results.median(f"{scenario}-{side}", subject) for side in (10, 32, 100, 316, 1000)}
        return {side * side: time for side, time in found.items() if time}

    lines = [(plain(NAMES[s]), points("ramp", s), c, "none") for s, c in zip(RECOMPUTE, COLOURS[1:])]
    lines.append(("published algorithm, an edit", points("edit-ramp", "published-port"), COLOURS[7], "none"))
    lines.append(("engine, an edit", points("edit-ramp", "engine-shapes"), COLOURS[0], "none"))
    lines.append(("engine, from nothing", points("ramp", "engine-shapes"), COLOURS[0], "5 4"))
    text = "Random ramps: the whole outline again, or one polygon removed or added and committed. Median."
    return LogLog("Incremental against full recompute", text, lines).svg.finish()


def build_time(results):
    """A bar for each row of the article's table and each library, in each of the two worlds."""
    worlds = (("full-100", "full blocks", 1), ("ramp-100", "random ramps", 3))
    rows = []
    for subject in ("engine-fill", "engine-shapes", "engine-polygons", "published-port", *RECOMPUTE):
        rows.append((plain(NAMES[subject]), [results.median(world, subject) for world, _, _ in worlds]))
    for name, times in PUBLISHED.items():
        rows.append((f"published, other machine: {name}", [times[at] * 1e6 for _, _, at in worlds]))
    rows = [row for row in rows if any(row[1])]
    known = [t for _, times in rows for t in times if t]
    low, high = floor(log10(min(known))), ceil(log10(max(known)))
    left, right, top, step = 270, 780, 100, 36
    height = top + step * len(rows) + 50
    svg = Svg(WIDTH, height, "100×100 cells from nothing", "Median; the scale is logarithmic. Polygons are made beforehand.")
    for k, (_, world, _) in enumerate(worlds):
        svg.rect(560 + 120 * k, 52, 11, 11, fill=COLOURS[k])
        svg.text(577 + 120 * k, 62, world)
    for decade in range(low, high + 1):
        x = left + (decade - low) / (high - low) * (right - left)
        svg.line([(x, top - 8), (x, height - 42)], stroke=GRID, stroke_opacity=0.4, stroke_width=0.75)
        svg.text(x, height - 24, decade_in_words(decade), fill=MUTED, anchor="middle")
    for r, (name, times) in enumerate(rows):
        y = top + step * r
        svg.text(left - 10, y + 17, name, anchor="end")
        for k, time in enumerate(times):
            if not time:
                svg.text(left + 4, y + 11 + 13 * k, "–", fill=MUTED)
                continue
            width = (log10(time) - low) / (high - low) * (right - left)
            svg.rect(left, y + 1 + 13 * k, width, 11, fill=COLOURS[k], rx=1.5)
            svg.text(left + width + 5, y + 11 + 13 * k, duration(time), fill=INK, size=10.5)
    return svg.finish()


PLOTS = {"edit-time": edit_time, "incremental": incremental, "build-time": build_time}
