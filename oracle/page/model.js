// What the page knows: its data, and what stands in the world after each step. oracle/page/story.h says what the data
// hold.

const data = JSON.parse(document.getElementById("data").textContent);

// The world after each step:
//   polygons         those that stand there
//   added, removed   by this step
//   edited           cells that were edited since the commit before, as [i, j]
//   pairs            the outline of the last commit, see pairsOf()
//   commits          how many there were; isCommit: this step is one
function statesOf(steps) {
  const standing = new Set();
  let edited = new Map();
  let pairs = new Map();
  let commits = 0;
  let isCommit = true;
  return steps.map((step, index) => {
    const { added = [], removed = [] } = step;
    added.forEach((polygon) => standing.add(polygon));
    removed.forEach((polygon) => standing.delete(polygon));
    if (isCommit) edited = new Map();
    if (index > 0) {
      for (const polygon of [...added, ...removed]) {
        const cell = data.polygons[polygon].cell;
        edited.set(cell.join(), cell);
      }
    }
    isCommit = step.expected !== undefined;
    if (isCommit) pairs = pairsOf(step.expected, step.actual ?? step.expected);
    if (isCommit && index > 0) ++commits;
    const polygons = [...standing];
    return { step, index, polygons, added, removed, edited: [...edited.values()], pairs, commits, isCommit };
  });
}

const keyOf = (start, end) => `${start}>${end}`;
const keyOfSegment = (segment) => keyOf(segment.start, segment.end);

// Two outlines, with the segments that have the same ends side by side. A pair has `expected`, `actual` or both.
function pairsOf(expected, actual) {
  const pairs = new Map();
  const put = (side) => (number) => {
    const segment = data.segments[number];
    const key = keyOfSegment(segment);
    if (!pairs.has(key)) pairs.set(key, { key });
    pairs.get(key)[side] = segment;
  };
  expected.forEach(put("expected"));
  actual.forEach(put("actual"));
  return pairs;
}

const anyOf = (pair) => pair.expected ?? pair.actual;

// "same", "missing", "extra", or "other": there in both outlines, but with another ghost, block or owner.
function kindOf(pair) {
  if (!pair.actual) return "missing";
  if (!pair.expected) return "extra";
  return pair.expected === pair.actual ? "same" : "other";
}

const predecessorKey = (segment) => (segment.ghost1 === null ? null : keyOf(segment.ghost1, segment.start));
const successorKey = (segment) => (segment.ghost2 === null ? null : keyOf(segment.end, segment.ghost2));

// The links of both outlines, by their three vertices. Each has `expected` and `actual`: how many of its two segments
// know of it.
function linksOf(pairs) {
  const links = new Map();
  const count = (side, vertices) => {
    const key = vertices.join(">");
    if (!links.has(key)) links.set(key, { vertices, expected: 0, actual: 0 });
    ++links.get(key)[side];
  };
  for (const pair of pairs.values()) {
    for (const side of ["expected", "actual"]) {
      const segment = pair[side];
      if (!segment) continue;
      if (segment.ghost1 !== null) count(side, [segment.ghost1, segment.start, segment.end]);
      if (segment.ghost2 !== null) count(side, [segment.start, segment.end, segment.ghost2]);
    }
  }
  return [...links.values()];
}

// The segment that a difference is about, as a key.
const keyOfDifference = ({ expected, actual }) => keyOfSegment(data.segments[expected ?? actual]);

const differencesOf = (state) => state.step.differences ?? [];
const markedOf = (state) => (state.step.marked ?? []).map((number) => data.segments[number]);

const counted = (n, noun) => `${n.toLocaleString("en")} ${noun}${n === 1 ? "" : "s"}`;

const states = statesOf(data.steps);
