"""The plots of docs/timings.md, as SVG files. This is the only part of the report that needs matplotlib."""

from math import ceil, floor, log10

import matplotlib
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from tables import NAMES, PUBLISHED, RECOMPUTE, SIZES, WORLDS
from words import count, duration

# The colours of the project's other pictures (oracle/draw/colours.h).
PAGE, PAPER, INK, MUTED, GRID = "#fbfaf6", "#ffffff", "#1f2a3d", "#667085", "#98a2b3"
COLOURS = ["#0b5fb0", "#d1490c", "#b5267b", "#b7791f", "#2f7d6b", "#6b4fa0", "#7a5c3e", "#1f2a3d"]
STYLE = {
    "axes.edgecolor": GRID,
    "axes.facecolor": PAPER,
    "axes.grid": True,
    "axes.labelcolor": MUTED,
    "figure.facecolor": PAGE,
    "font.sans-serif": ["DejaVu Sans", "Segoe UI", "Helvetica Neue", "sans-serif"],
    "font.size": 8.5,
    "grid.alpha": 0.35,
    "grid.color": GRID,
    "svg.fonttype": "none",  # text stays text
    "svg.hashsalt": "lgs",  # the same ids in every run
    "text.color": INK,
    "xtick.labelcolor": MUTED,
    "xtick.major.pad": 7,
    "xtick.major.size": 0,
    "ytick.labelcolor": MUTED,
    "ytick.major.pad": 7,
    "ytick.major.size": 0,
}


def plain(name):
    return name.replace("*", "").replace("`", "")


def duration_of_decade(time, _position):
    """A power of ten, in nanoseconds: '10 µs'."""
    return duration(time).replace(".0 ", " ")


def set_decades(axis, words):
    """A tick at every power of ten, and none between."""
    axis.set_major_locator(LogLocator(numticks=20))
    axis.set_major_formatter(FuncFormatter(words))
    axis.set_minor_locator(NullLocator())


def begin(title, text, height):
    """A figure with a heading. The height is in inches, like matplotlib's."""
    figure = Figure(figsize=(9, height))
    figure.text(0.03, 1 - 0.38 / height, title, fontsize=13.5, weight="semibold")
    figure.text(0.03, 1 - 0.64 / height, text, fontsize=9.5, color=MUTED)
    return figure


def save(figure, path):
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None, "Title": figure.texts[0].get_text()})


def spread(heights, gap):
    """Moves sorted heights from 0 to 1 apart, so that there is a gap between each two."""
    heights = list(heights)
    for k in range(1, len(heights)):
        heights[k] = max(heights[k], heights[k - 1] + gap)
    for k in reversed(range(len(heights))):
        heights[k] = min(heights[k], 1 - gap * (len(heights) - 1 - k))
    return heights


def log_log(path, title, text, lines):
    """Draws lines over the size of the world, with both axes logarithmic. Each line is (name, {cells: ns}, colour,
    style), and its name stands beside its end."""
    lines = [line for line in lines if line[1]]
    times = [time for _, points, _, _ in lines for time in points.values()] or [1, 10]
    low, high = floor(log10(min(times))), max(ceil(log10(max(times))), floor(log10(min(times))) + 1)
    figure = begin(title, text, 5.5)
    axes = figure.add_axes((0.1, 0.1, 0.64, 0.73))
    for _, points, colour, style in lines:
        cells, times = zip(*sorted(points.items()))
        axes.plot(cells, times, style, color=colour, marker="o", markersize=4, linewidth=1.5, clip_on=False)
    axes.set(xscale="log", yscale="log", xlabel="cells of the world", ylim=(10**low, 10**high))
    axes.margins(x=0)
    set_decades(axes.xaxis, lambda cells, _: count(cells))
    set_decades(axes.yaxis, duration_of_decade)

    def height(line):
        last = line[1][max(line[1])]
        return (log10(last) - low) / (high - low)

    lines.sort(key=height)
    for line, label in zip(lines, spread(map(height, lines), 0.04)):
        name, points, colour, _ = line
        axes.annotate(
            name,
            (max(points), points[max(points)]),
            (1.025, label),
            textcoords="axes fraction",
            color=colour,
            verticalalignment="center",
            arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.75, "alpha": 0.5, "shrinkB": 4},
        )
    save(figure, path)


def edit_time(results, path):
    lines = []
    for (world, name), colour in zip(WORLDS.items(), COLOURS):
        for bench, where, style in (("remove-add", "anywhere", "-"), ("dig", "nearby", "--")):
            rows = {size: results.of(f"edit/{bench}/{world}/{size}") for size in SIZES}
            points = {size: row["first_median_ns"] for size, row in rows.items() if row}
            lines.append((f"{name}, {where}", points, colour, style))
    text = "Removing the content of one cell, with commit and change list: median. Nearby: as a player digs."
    log_log(path, "An edit's time against the world's size", text, lines)


def incremental(results, path):
    def points(scenario, subject):
        found = {side: results.median(f"{scenario}-{side}", subject) for side in (10, 32, 100, 316, 1000)}
        return {side * side: time for side, time in found.items() if time}

    lines = [(plain(NAMES[s]), points("ramp", s), c, "-") for s, c in zip(RECOMPUTE, COLOURS[1:])]
    lines.append(("the port as published, an edit", points("edit-ramp", "published-port"), COLOURS[7], "-"))
    lines.append(("engine, an edit", points("edit-ramp", "engine-shapes"), COLOURS[0], "-"))
    lines.append(("engine, from nothing", points("ramp", "engine-shapes"), COLOURS[0], "--"))
    text = "Random ramps: the whole outline again, or one polygon removed or added and committed. Median."
    log_log(path, "Incremental against full recompute", text, lines)


def build_time(results, path):
    """A bar for each row of the article's table and each library, in each of the two worlds."""
    worlds = (("full-100", "full blocks", 1), ("ramp-100", "random ramps", 3))
    rows = []
    for subject in ("engine-fill", "engine-shapes", "engine-polygons", "published-port", *RECOMPUTE):
        rows.append((plain(NAMES[subject]), [results.median(world, subject) for world, _, _ in worlds]))
    for name, times in PUBLISHED.items():
        rows.append((f"published, other machine: {name}", [times[at] * 1e6 for _, _, at in worlds]))
    rows = [row for row in rows if any(row[1])]
    known = [time for _, times in rows for time in times if time]
    low, high = 10 ** floor(log10(min(known))), 10 ** ceil(log10(max(known)))

    height = 1.5 + 0.375 * len(rows)
    text = "Median; the scale is logarithmic. Polygons are made beforehand."
    figure = begin("100×100 cells from nothing", text, height)
    axes = figure.add_axes((0.32, 0.5 / height, 0.6, 1 - 1.5 / height), facecolor="none")
    for k, (_, world, _) in enumerate(worlds):
        times = [row[1][k] for row in rows]
        places = [r + 0.36 * (k - 0.5) for r in range(len(rows))]
        bars = axes.barh(places, [time or low for time in times], 0.32, color=COLOURS[k], label=world)
        axes.bar_label(bars, [duration(time) if time else "–" for time in times], padding=3)
    axes.set(xscale="log", xlim=(low, high), ylim=(len(rows) - 0.4, -0.6))
    axes.set_yticks(range(len(rows)), [name for name, _ in rows], color=INK)
    set_decades(axes.xaxis, duration_of_decade)
    axes.yaxis.grid(False)
    axes.set_axisbelow(True)
    axes.spines[:].set_visible(False)
    figure.legend(loc="upper right", bbox_to_anchor=(0.95, 1 - 0.4 / height), ncol=len(worlds), frameon=False)
    save(figure, path)


def draw(results, folder):
    """Writes timings-*.svg."""
    with matplotlib.rc_context(STYLE):
        for name, plot in {"edit-time": edit_time, "incremental": incremental, "build-time": build_time}.items():
            plot(results, folder / f"timings-{name}.svg")
