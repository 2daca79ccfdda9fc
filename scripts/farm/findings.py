"""Findings: what a unit saw go wrong. The same fault is told once, however often and wherever it is found."""

import hashlib
import re
import shlex
from fractions import Fraction
from pathlib import Path

TRACE = re.compile(r"^lgs-trace [123]\n(?:(?:preserve|add|remove|commit|paint|carve)\b.*\n?)*", re.M)
PICTURE = re.compile(r"^picture    (\S+\.svg)$", re.M)
AGAIN = re.compile(r"^again      (.+)$", re.M)
# The sentences of a mismatch that say what kind of fault it is, those that say most first.
FAULTS = [re.compile(pattern, re.M) for pattern in (
    r"^(missing segment|extra segment|wrong ghost[12]|wrong block)", r"(\bcrashed with SIG\w+|\bhung for\b)",
    r"(refused, but is good|accepted, but is bad)", r"(the outline differs)")]
# The symmetries of the square, each as what becomes of a point of the world. The last four turn it over.
SYMMETRIES = [lambda x, y: (x, y), lambda x, y: (-y, x), lambda x, y: (-x, -y), lambda x, y: (y, -x),
              lambda x, y: (-x, y), lambda x, y: (y, x), lambda x, y: (x, -y), lambda x, y: (-y, -x)]


def numbers(words: list[str]) -> list[Fraction]:
    return [Fraction(word) for word in words]


def pairs(values: list[Fraction]) -> list[tuple[Fraction, Fraction]]:
    return list(zip(values[::2], values[1::2], strict=True))


def from_least(ring: list, is_turned_over: bool) -> list:
    """A ring from its least vertex on, the way round that it had."""
    ring = ring[::-1] if is_turned_over else ring
    least = ring.index(min(ring))
    return ring[least:] + ring[:least]


class Moved:
    """A trace seen from elsewhere: shifted, turned, mirrored, with names and blocks numbered as they come."""

    def __init__(self, symmetry: int, origin: tuple[int, int]):
        self.symmetry, self.origin = symmetry, origin
        self.names: dict[str, str] = {}
        self.blocks: dict[str, str] = {}

    def point(self, x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        return SYMMETRIES[self.symmetry](x - self.origin[0], y - self.origin[1])

    def ring(self, points: list) -> str:
        ring = from_least([self.point(x, y) for x, y in points], self.symmetry > 3)
        return ", ".join(f"{x} {y}" for x, y in ring)

    def name(self, name: str) -> str:
        return self.names.setdefault(name, f"p{len(self.names) + 1}")

    def block(self, block: str) -> str:
        return self.blocks.setdefault(block, str(len(self.blocks) + 1))

    def line(self, line: str) -> str:
        """How an edit is made, which comes after `by`, stays; it stands before the edit."""
        edit, _, way = line.partition(" by ")
        return f"{way} {self.edit(edit)}"

    def edit(self, line: str) -> str:
        words = line.replace(",", " ").replace("|", " | ").split()
        if words[0] == "add":
            i, j = int(words[2]), int(words[3])
            polygon = [(i + x, j + y) for x, y in pairs(numbers(words[5:]))]
            return f"add {self.name(words[1])} {self.block(words[4])}: {self.ring(polygon)}"
        if words[0] == "remove":
            return f"remove {self.name(words[1])}"
        if words[0] == "preserve":
            return " ".join(["preserve", *sorted(map(self.block, words[1:]))])
        if words[0] in ("paint", "carve"):
            head = [words[0], self.block(words[1]), words[2]] if words[0] == "paint" else ["carve"]
            rings = " ".join(words[len(head):]).split("|")
            return " ".join(head) + ": " + " | ".join(self.ring(pairs(numbers(ring.split()))) for ring in rings)
        return line


def normal(trace: str) -> str:
    """The least of all ways to see a trace. Traces that differ only by shift, turn, mirror, names or blocks are equal."""
    lines = [line for line in map(str.strip, trace.splitlines()[1:]) if line and not line.startswith("#")]
    cells = [tuple(map(int, line.replace(",", " ").split()[2:4])) for line in lines if line.startswith("add ")]
    origins = {(min(i for i, _ in cells), min(j for _, j in cells))} if cells else {(0, 0)}
    seen = []
    for symmetry in range(len(SYMMETRIES)):
        for origin in origins:
            moved = Moved(symmetry, origin)
            text = [moved.line(line) for line in lines]
            seen.append("\n".join(shifted(text)))
    return min(seen)


def shifted(lines: list[str]) -> list[str]:
    """The least cell that a turned trace reaches becomes (0, 0)."""
    places = [pairs(numbers(re.sub(r"[,|]", " ", line.partition(": ")[2]).split())) for line in lines]
    points = [point for ring in places for point in ring]
    if not points:
        return lines
    low_x, low_y = min(x for x, _ in points).__floor__(), min(y for _, y in points).__floor__()

    def move(line: str) -> str:
        head, colon, rest = line.partition(": ")
        rings = [", ".join(f"{x - low_x} {y - low_y}" for x, y in pairs(numbers(ring.replace(",", " ").split())))
                 for ring in rest.split("|")] if colon else []
        return head + colon + " | ".join(rings)

    return [move(line) for line in lines]


def name_of(kind: str, normalised: str) -> str:
    return hashlib.sha256(f"{kind}\n{normalised}".encode()).hexdigest()[:12]


def fault_of(text: str) -> str:
    found = [match[1] for match in (pattern.search(text) for pattern in FAULTS) if match]
    return found[0] if found else "a law does not hold"


def read(text: str, folder: Path) -> list[dict]:
    """What a program printed of its findings, with the picture that it saved below the folder."""
    result = []
    for trace in TRACE.finditer(text):
        words = text[trace.start():trace.end() + 2_000]
        fault = fault_of(text[max(0, trace.start() - 2_000):trace.end() + 2_000])
        picture, again = PICTURE.search(words), AGAIN.search(words)
        svg = (folder / picture[1]) if picture else None
        result.append({"id": name_of(fault, normal(trace[0])), "fault": fault, "trace": trace[0], "words": words,
                       "again": again[1] if again else "",
                       "picture": svg.read_text(encoding="utf-8") if svg and svg.is_file() else ""})
    return list({finding["id"]: finding for finding in result}.values())


def without_trace(kind: str, text: str, words: list[str], extra: dict[str, str]) -> dict:
    """Of a unit that failed and showed no trace: a law of other things than worlds, a bug that nothing found."""
    failed = re.findall(r"^\[  FAILED  \] ([\w/.]+)|: (.*(?:SURVIVES|lives).*)$", text, re.M)
    fault = sorted({"".join(pair) for pair in failed})[0] if failed else f"{kind} failed"
    again = " ".join([*(f"{k}={v}" for k, v in extra.items()), shlex.join(words)])
    return {"id": name_of(kind, fault), "fault": fault, "trace": "", "words": text[-4_000:], "again": again, "picture": ""}
