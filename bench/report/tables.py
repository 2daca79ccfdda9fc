"""The tables of docs/timings.md and README.md, as Markdown, by the names of their places there."""

import textwrap

from words import count, digits, duration, ratio, table

NONE = "–"
SIZES = (100, 10_000, 1_000_000, 10_000_000)
WORLDS = {"full": "full blocks", "ramp": "random ramps", "map": "the project's map", "mix": "degenerate mix"}
NAMES = {
    "published-port": "the port as published",
    "published-port-new-sets": "the port, without the cost of clearing its sets",
    "published-arrays": "the optimised one",
    "engine-bulk": "engine, by shapes, in one call",
    "engine-polygons": "**engine, by polygons**",
    "engine-shapes": "**engine, by shapes**",
    "engine-fill": "**engine, by fill**",
    "geos-coverage": "GEOS CoverageUnion",
    "geos": "GEOS UnaryUnion",
    "clipper": "Clipper 6",
    "boost": "Boost.Geometry",
    "cgal": "CGAL `Polygon_set_2`, EPECK",
    "polygon-clipping": "polygon-clipping (JavaScript)",
}
RECOMPUTE = ("geos-coverage", "clipper", "boost", "cgal", "polygon-clipping", "geos")
# The article's figures in milliseconds: polygons and segments of FullBlock, polygons and segments of RAMP.
PUBLISHED = {
    "TypeScript": (11.73, 29.02, 9.57, 43.44),
    "baseline C++": (1.26, 5.28, 0.85, 23.28),
    "optimised C++": (0.91, 3.87, 0.68, 18.42),
}


def duration_or_none(ns):
    return NONE if ns is None else duration(ns)


def ratio_or_none(a, b):
    return NONE if not a or not b else ratio(a / b)


def about(results):
    """Where the figures come from."""
    a = results.about
    return textwrap.fill(
        f"Measured on {a['date']}: {a['machine']}; {a['compiler']}; commit {a['commit']}; by `{a['command']}`. "
        "One core; absolute times drift, ratios are of one run.",
        120,
        break_long_words=False,
        break_on_hyphens=False,
    )


def article(results):
    scenarios = ("polygons-full-100", "full-100", "polygons-ramp-100", "ramp-100")
    rows = [
        [f"{name}, *published, on another machine*", *(f"{ms} ms" for ms in times), NONE, NONE]
        for name, times in PUBLISHED.items()
    ]
    for subject in ("published-port", "published-arrays", "engine-polygons", "engine-shapes", "engine-bulk", "engine-fill"):
        times = [results.median(scenario, subject) for scenario in scenarios]
        if not any(times):
            continue
        segments = scenarios[1::2]
        against = [ratio_or_none(results.median(s, "published-port"), results.median(s, subject)) for s in segments]
        rows.append([NAMES[subject], *map(duration_or_none, times), *against])
    head = ["", "FullBlock, polygons", "FullBlock, segments", "RAMP, polygons", "RAMP, segments"]
    return table([*head, "port as published ÷ this, FullBlock", "RAMP"], rows)


def recompute(results):
    rows = []
    for subject in ("engine-shapes", "published-port", *RECOMPUTE):
        cells = [NAMES[subject]]
        for world, edit in (("full-100", "edit-100"), ("ramp-100", "edit-ramp-100")):
            time = results.median(world, subject)
            cells += [
                duration_or_none(time),
                ratio_or_none(time, results.median(world, "engine-shapes")),
                ratio_or_none(results.median(edit, subject), results.median(edit, "engine-shapes")),
            ]
        rows.append(cells)
    return table(["", "full blocks", "÷ engine's build", "÷ engine's edit", "ramps", "÷ build", "÷ edit"], rows)


def edits(results):
    rows = []
    for side in (100, 1000):
        for where, kind in (("anywhere", "edit"), ("nearby", "dig")):
            for subject in ("published-port", "published-port-new-sets", "published-arrays", "engine-shapes"):
                cells = [f"{count(side * side)} cells, {where}: {NAMES[subject]}"]
                for scenario in (f"{kind}-{side}", f"{kind}-ramp-{side}"):
                    row = results.comparison.get((scenario, subject))
                    port = results.median(scenario, "published-port-new-sets")
                    times = (row["median_ns"], row["p99_ns"]) if row else (None, None)
                    against = None if subject == "published-port" else row and row["median_ns"]
                    cells += [*map(duration_or_none, times), ratio_or_none(port, against)]
                if set(cells[1:]) != {NONE}:
                    rows.append(cells)
    return table(["", "full blocks: median", "p99", "port ÷ this", "ramps: median", "p99", "port ÷ this"], rows)


def edit_sizes(results):
    kinds = {
        "remove": ("remove-add", "first"),
        "dig nearby": ("dig", "first"),
    }
    rows = []
    for world, name in WORLDS.items():
        for kind, (bench, half) in kinds.items():
            cells = [f"{name}: {kind}"]
            for size in SIZES:
                row = results.of(f"edit/{bench}/{world}/{size}")
                figures = [row.get(f"{half}_{figure}_ns") for figure in ("median", "p99")]
                cells.append(" / ".join(map(duration_or_none, figures)) if row else NONE)
            rows.append(cells)
    return table(["median / p99", *(f"{count(size)} cells" for size in SIZES)], rows)


def builds(results):
    rows = []
    kinds = [(world, "shapes", SIZES[1:]) for world in WORLDS]
    kinds += [(world, "shapes-2-threads", SIZES[2:]) for world in ("ramp", "mix")]
    kinds.append(("full", "fill", (*SIZES[2:], 100_000_000)))
    ways = {"shapes": "by shapes", "shapes-2-threads": "by shapes, 2 threads", "fill": "by fill"}
    for world, how, sizes in kinds:
        for size in sizes:
            row = results.of(f"build/{how}/{world}/{size}")
            if not row:
                continue
            inside = results.of(f"build/{how}/full/{size}").get("bytes", 0)
            above = (row["bytes"] - inside) / row["segments"]
            rows.append(
                [
                    f"{WORLDS[world]}, {ways[how]}: {count(size)}",
                    duration(1e9 / row["items_per_second"]),
                    digits(row["bytes"] / size),
                    digits(row["segments"] / size),
                    digits(above) if world in ("ramp", "mix") else NONE,
                ]
            )
    return table(["cells", "time a cell", "bytes a cell", "segments a cell", "bytes a segment, above full blocks"], rows)


def worst(results):
    texts = {
        "new-chunk": "first cell of a chunk (32×32 cells)",
        "new-polygon/4": "polygon never seen before, 4 vertices",
        "new-polygon/64": "the same, 64 vertices",
        "new-polygon/1024": "the same, 1,024 vertices",
        "crowded-cell/4": "one of 4 polygons in a cell, removed or put back",
        "crowded-cell/225": "one of 225 polygons in a cell",
        "comb-on-wall/8": "full cell under a comb of 8 teeth",
        "comb-on-wall/1000": "full cell under a comb of 1,000 teeth",
        "clear-all": "1,000,000 full cells cleared at once",
    }
    rows = []
    for name, text in texts.items():
        row = results.of(f"worst/{name}")
        rows.append([text, *(duration_or_none(row.get(f"{f}_ns")) for f in ("median", "p99", "max"))])
    return table(["", "median", "p99", "max"], rows)


def summary(results):
    """The README's short table: beside the strongest native neighbour that was measured; the last row is the worst."""
    arrays, rows = "the article's optimised C++, reconstructed", []
    for text, scenario in (
        ("one edit, digging in 10,000 full blocks", "dig-100"),
        ("one edit, digging in 10,000 random ramps", "dig-ramp-100"),
    ):
        engine, other = (results.median(scenario, subject) for subject in ("engine-shapes", "published-arrays"))
        rows.append([text, duration_or_none(engine), f"{arrays}: {duration_or_none(other)}", ratio_or_none(other, engine)])
    row = results.of("brush/carve/mix")
    engine, other = row.get("median_ns"), row.get("clipper_cells_median_ns")
    clipper = f"Clipper 6's difference of the touched cells: {duration_or_none(other)}"
    rows.append(["a round hole of radius 3, mixed ground", duration_or_none(engine), clipper, ratio_or_none(other, engine)])
    # By web/bench at commit 0abf6f96 (docs/timings.md, "In the browser"), which needs other tools.
    rows.append(["a tile set, both in WebAssembly (0abf6f96)", "1.01 µs", "Rapier, a voxel without outline: 147 ns", "0.15×"])
    return table(["median", "this library", "the strongest neighbour that was measured", "neighbour ÷ this"], rows)


ALL = (about, article, recompute, edits, edit_sizes, builds, worst, summary)
TABLES = {table_of.__name__: table_of for table_of in ALL}
