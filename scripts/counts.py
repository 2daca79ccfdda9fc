"""What there is to count in the project, as the documents have it: for scripts/claims.py."""
import json
import re
import runpy
from collections import Counter

from links import tracked

# Folders whose own folders have rows in the table of folders, too.
DEEP = ("bench", "examples", "lib", "oracle", "web")
FOLDERS_PAGE, CONTRACT, LONG_RUNS = "docs/internals/folders.md", "docs/contract.md", "docs/reports/long-runs.md"
BUGS_PAGE, FUZZ_RUNS, MUTANTS = "docs/reports/planted-bugs.md", "docs/reports/fuzz-runs.md", "docs/reports/mutants.md"
COVERAGE, PLATFORMS, INSTALL = "docs/reports/coverage.md", "docs/platforms.md", "docs/install.md"


def text(root, name):
    return (root / name).read_text(encoding="utf-8")


def table(head, rows):
    return "".join("| " + " | ".join(map(str, row)) + " |\n" for row in [head, ["---"] * len(head), *rows])


def rows_of(page, first):
    """The rows of the first table of a page whose head begins so; each a list of cells."""
    lines = page.splitlines()
    begin = next(k for k, line in enumerate(lines) if line.startswith(f"| {first}"))
    rows = []
    for line in lines[begin + 2:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.replace(r"\|", "/").strip().strip("|").split("|")])
    return rows


def whole(cell):
    """A number with commas; 0 if the cell is none."""
    return int(cell.replace(",", "")) if re.fullmatch(r"[\d,]+", cell) else 0


# --- What is there ----------------------------------------------------------------------------------------------------


def laws(root):
    return [int(number) for number in re.findall(r"^(\d+)\. \*", text(root, CONTRACT), re.M)]


def planted(root):
    """The names of the planted bugs, by the file that lists them."""
    files = sorted((root / "proptests/bugs").glob("*.toml"))
    name = re.compile(r"""^\[\[bug\]\]\nname = (?:"(.*)"|'(.*)')$""", re.M)
    listed = {file.stem: name.findall(file.read_text(encoding="utf-8")) for file in files}
    return {stem: [a or b for a, b in names] for stem, names in listed.items() if names}


def calls(root):
    return int(re.search(r"kKinds = (\d+);", text(root, "oracle/calls/call.h"))[1])


def platforms(root):
    rows = re.search(r"^rows='\n(.*?)'", text(root, "scripts/everywhere.sh"), re.M | re.S)[1]
    return [row.partition("|")[0] for row in rows.splitlines()]


def folders(root):
    parts = [file.parts for file in tracked(root) if not file.parts[0].startswith(".")]
    return ({f"{p[0]}/" for p in parts if len(p) > 1}
            | {f"{p[0]}/{p[1]}/" for p in parts if len(p) > 2 and p[0] in DEEP})


def presets(root):
    return {preset["name"]: preset for preset in json.loads(text(root, "CMakePresets.json"))["configurePresets"]
            if not preset.get("hidden")}


def options(root):
    """Name, comment and default of each option of CMake."""
    return re.findall(r'option\((LGS_\w+) "([^"]*)"\s+(\S+)\)', text(root, "CMakeLists.txt"))


def fuzz_targets(root):
    return {path.name for path in (root / "fuzz/corpus").iterdir() if path.is_dir()}


def regressions(root):
    return len(list((root / "proptests/regressions").glob("*.trace")))


# --- Blocks: what stands between markers ------------------------------------------------------------------------------


def summary_of_bugs(root):
    return re.search(r"<!-- planted: summary -->\n(.*?)\n<!-- end -->", text(root, BUGS_PAGE), re.S)[1]


def found(root):
    return re.search(r"(\d+) were found", summary_of_bugs(root))[1]


def totals(root):
    return table(["what there is", "how many"], [
        ["laws, all of them tested on random cases", len(laws(root))],
        ["kinds of calls that random cases make, each held against a model", calls(root)],
        ["planted bugs, each of which a test must find; run, and found",
         f"{sum(map(len, planted(root).values()))}; {found(root)}"],
        ["fuzz targets; traces that once showed a bug", f"{len(fuzz_targets(root))}; {regressions(root)}"],
        ["systems, compilers and options that must give the same ids", len(platforms(root))],
    ])


REBUILT = "before it was rebuilt"  # what a row of an earlier engine says of itself


def evidence(root):
    runs = rows_of(text(root, LONG_RUNS), "what")
    earlier = [row for row in runs if REBUILT in row[0]]
    fuzzed = rows_of(text(root, FUZZ_RUNS), "on")
    mutants = next(row for row in rows_of(text(root, MUTANTS), "component") if row[0] == "all")
    covered = next(row for row in rows_of(text(root, COVERAGE), "| lines") if row[0].startswith("all"))
    commit = re.search(r"commit=(\w+)", text(root, COVERAGE))[1]
    bugs = summary_of_bugs(root)
    return table(["what was run", "outcome", "page"], [
        ["planted bugs", bugs.rstrip("."), "[planted-bugs.md](reports/planted-bugs.md)"],
        ["mutants made by rule", f"{mutants[5]} killed, {mutants[6]} lived, {mutants[4]} ran out of time, before tests "
         "were written for those that lived", "[mutants.md](reports/mutants.md)"],
        ["random commits, each compared with the naive reference; with CGAL, too",
         "; ".join(f"{when} {sum(whole(row[5]) for row in of):,}; {sum(whole(row[4]) for row in of):,}"
                   for when, of in (("of today's engine", [row for row in runs if row not in earlier]),
                                    ("before it was rebuilt in two halves", earlier)))
         + "; mismatches: " + ", ".join(sorted({row[6] for row in runs})), "[long-runs.md](reports/long-runs.md)"],
        ["fuzzing with sanitizers",
         f"{sum(whole(row[1]) for row in fuzzed) / 60:.1f} hours of a processor, "
         f"{sum(whole(row[2]) for row in fuzzed) / 1e6:.1f} million inputs, no finding",
         "[fuzz-runs.md](reports/fuzz-runs.md)"],
        [f"coverage of `lib/` by the tests, at commit {commit}",
         f"lines {covered[1].split(' (')[0]}, branches {covered[2].split(' (')[0]}",
         "[coverage.md](reports/coverage.md)"],
    ])


def bugs_by_law(root):
    titles = {stem: re.match(r"law = '(.*)'", text(root, f"proptests/bugs/{stem}.toml"))[1] for stem in planted(root)}
    rows = [[titles[stem], f"`{stem}.toml`", len(names)] for stem, names in planted(root).items()]
    return table(["what they break", "list", "bugs"], rows)


def canaries(root):
    files = sorted((root / "proptests/bugs").glob("*.toml"))
    texts = [file.read_text(encoding="utf-8") for file in files]
    named = Counter(name for listed in texts for name in re.findall(r"^fuzz = ['\"](\w+)", listed, re.M))
    return table(["fuzz target", "bugs that it must find"], [[f"`{name}`", named[name]] for name in sorted(named)])


def table_of_presets(root):
    rows = [[f"`{name}`", preset["displayName"], preset.get("description", "")]
            for name, preset in presets(root).items()]
    return table(["preset", "what it builds", "note"], rows)


def table_of_options(root):
    """Those that a game's build has, too, come first."""
    words = {"${PROJECT_IS_TOP_LEVEL}": ("OFF", "ON"), "${lgs_is_whole}": ("–", "ON")}
    rows = [[f"`{name}`", *words.get(default, ("–", default)), comment] for name, comment, default in options(root)]
    return table(["option", "in a game's build", "in the project's", "what it does"], rows)


def hashes(root):
    """Whether the table of platforms was made with the hash that is expected today."""
    made = {row[4] for row in rows_of(text(root, PLATFORMS), "name")}
    now = re.search(r"^all (\w+)", text(root, "proptests/platform/expected.txt"), re.M)[1]
    if made == {now}:
        return f"The hash of the table, {now}, is the one that `expected.txt` has today.\n"
    return (f"**Older than the code**: rows whose hash is not {now}, the one that `expected.txt` has today. The tests\n"
            "compare it on Linux by g++ and clang++.\n")


def ceilings(root):
    folder = root / "bench/instructions"
    said = runpy.run_path(str(folder / "gate.py"))["STEPS"]
    counted = json.loads((folder / "ceilings.json").read_text(encoding="utf-8"))["ceilings"]
    return table(["loop", "a step", "instructions, at most"],
                 [[f"`{name}`", said[name], f"{most:,}"] for name, most in counted.items()])


BLOCKS = {"totals": totals, "ceilings": ceilings, "evidence": evidence, "bugs": bugs_by_law, "canaries": canaries,
          "presets": table_of_presets,
          "options": table_of_options, "platforms": hashes}


# --- Lists: page, what, names in the page, names that are there -------------------------------------------------------


def lists(root, pages):
    def cells(page, first):
        return " ".join(row[0] for row in rows_of(pages[page], first))

    if FOLDERS_PAGE in pages:
        listed = set(re.findall(r"`([\w/-]+/)`", cells(FOLDERS_PAGE, "folder")))
        there = folders(root)
        yield FOLDERS_PAGE, "folders", {name for name in listed if name.count("/") == 1 or name in there}, there
    if CONTRACT in pages:
        found = laws(root)
        yield CONTRACT, "laws", set(map(str, found)), {str(k) for k in range(1, len(found) + 1)}
    if BUGS_PAGE in pages:
        rows = re.findall(r"^\| (.*?) \| .* \| `[\w.]+` \| .*\|$", pages[BUGS_PAGE], re.M)
        yield BUGS_PAGE, "planted bugs", set(rows), {name for names in planted(root).values() for name in names}
    if INSTALL in pages:
        config = re.search(r"set\(LocalGridSeg_components ([^)]+)\)", text(root, "cmake/LocalGridSegConfig.cmake.in"))
        listed = re.findall(r"`(\w+)`", cells(INSTALL, "component"))
        yield INSTALL, "components", set(listed), set(config[1].split())
    if "fuzz/README.md" in pages:
        listed = set(re.findall(r"`(\w+)`", cells("fuzz/README.md", "target")))
        yield "fuzz/README.md", "fuzz targets", listed, fuzz_targets(root)
