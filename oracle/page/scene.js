// Draws a step: the polygons, the grid, the outline with its links, and what is wrong with it.

const drawing = document.getElementById("drawing");
const fills = new Map(data.fills);

// 1, 2, 5, 10, 20, … cells: the least that leaves so many pixels.
function labelStep(pixels) {
  for (let ten = 1; ; ten *= 10) {
    const step = [ten, 2 * ten, 5 * ten].find((cells) => cells * view.scale >= pixels);
    if (step) return step;
  }
}

// The lines of an axis that are in view, as [cell, pixels].
function linesOf(centre, length, step) {
  const middle = centre / unit;
  const half = length / 2 / view.scale;
  const lines = [];
  for (let cell = Math.ceil((middle - half) / step) * step; cell <= middle + half; cell += step) {
    lines.push([cell, ((cell * unit - centre) / unit) * view.scale]);
  }
  return lines;
}

function drawGrid() {
  const step = view.scale >= 7 ? 1 : labelStep(40);
  const lines = [
    ...linesOf(view.x, view.width, step).map(([, x]) => `M${round(x + view.width / 2)} 0V${view.height}`),
    ...linesOf(view.y, view.height, step).map(([, y]) => `M0 ${round(view.height / 2 - y)}H${view.width}`),
  ];
  return svg("path", { class: "grid", d: lines.join("") });
}

function drawAxes() {
  const columns = linesOf(view.x, view.width, labelStep(56)).map(([cell, x]) =>
    label({ x: x + view.width / 2, y: view.height - 6 }, cell, { "text-anchor": "middle" }));
  const rows = linesOf(view.y, view.height, labelStep(28)).map(([cell, y]) =>
    label({ x: 6, y: view.height / 2 - y + 4 }, cell));
  const isFree = (text) => Number(text.getAttribute("x")) > 24 || Number(text.getAttribute("y")) < view.height - 24;
  return svg("g", { class: "axis" }, ...columns.filter(isFree), ...rows.filter(isFree));
}

function drawPolygons(state) {
  const solids = svg("g", { class: "solids" });
  const names = svg("g", { class: "names" });
  for (const number of [...state.polygons, ...state.removed]) {
    const polygon = data.polygons[number];
    const corners = polygon.corners.map(pixelsOf);
    if (!touchesView(corners)) continue;
    const isRemoved = state.removed.includes(number);
    const isAdded = state.index > 0 && state.added.includes(number);
    const kind = isRemoved ? "removed" : isAdded ? "added" : "solid";
    const fill = isRemoved ? "none" : fills.get(polygon.block);
    solids.append(svg("path", { class: kind, fill, d: polygonPath(corners), "data-polygon": polygon.name }));
    const box = boxOf(corners);
    if (box.right - box.left < 9 * polygon.name.length || box.top - box.bottom < 30) continue;
    const middle = corners.reduce((sum, p) => move(sum, p, 1 / corners.length), { x: 0, y: 0 });
    names.append(label(move(middle, { x: 0, y: 1 }, 4), polygon.name, { "text-anchor": "middle" }));
  }
  return [solids, names];
}

function drawEdited(state) {
  const inset = Math.min(6, view.scale / 6);
  const corners = (i, j) => [
    toPixels({ x: i * unit, y: (j + 1) * unit }),
    toPixels({ x: (i + 1) * unit, y: j * unit }),
  ];
  const paths = state.edited.map(([i, j]) => corners(i, j)).filter((cell) => touchesView(cell)).map(([a, b]) =>
    polygonPath([move(a, { x: 1, y: 1 }, inset), { x: b.x - inset, y: a.y + inset }, move(b, { x: -1, y: -1 }, inset),
      { x: a.x + inset, y: b.y - inset }]));
  return svg("path", { class: "edited", d: paths.join("") });
}

// The pixels of a segment's ends. Where two run against each other each is moved to the side of its own solid.
function endsOf(pair, pairs) {
  const { start, end } = anyOf(pair);
  const ends = [pixelsOf(start), pixelsOf(end)];
  if (!pairs.has(keyOf(end, start))) return ends;
  const inwards = outward(direction(ends[1], ends[0]));
  return ends.map((point) => move(point, inwards, 3));
}

const isShown = (pair, show) => show === "both" || pair[show] !== undefined;
const classOf = (pair, show) => (show === "both" ? kindOf(pair) : show);

function drawOutline(state, show) {
  const lines = svg("g", { class: "outline" });
  const hits = svg("g", { class: "hits" });
  const seen = [...state.pairs.values()]
    .filter((pair) => isShown(pair, show))
    .map((pair) => ({ pair, ends: endsOf(pair, state.pairs) }))
    .filter(({ ends }) => touchesView(ends));
  // The dashes of what is missing are to be seen on top of what is there in its place.
  const order = ["same", "extra", "other", "actual", "expected", "missing"];
  const rank = ({ pair }) => order.indexOf(classOf(pair, show));
  for (const { pair, ends } of [...seen].sort((a, b) => rank(a) - rank(b))) {
    const kind = classOf(pair, show);
    lines.append(svg("path", { class: `segment ${kind}`, d: linePath(...ends) }));
    const arrow = arrowPath(...ends);
    if (arrow) lines.append(svg("path", { class: `arrow ${kind}`, d: arrow }));
  }
  for (const { pair, ends } of seen) {
    hits.append(svg("path", { class: "hit", d: linePath(...ends), tabindex: 0, role: "img",
      "aria-label": wordsOf(pair), "data-key": pair.key }));
  }
  return [lines, hits];
}

function drawLinks(state, show) {
  const group = svg("g", { class: "links" });
  if (view.scale < 44) return group;
  for (const link of linksOf(state.pairs)) {
    const knows = show === "both" ? Math.max(link.expected, link.actual) : link[show];
    const points = link.vertices.map(pixelsOf);
    if (knows === 0 || !touchesView(points.slice(1, 2))) continue;
    const isBoth = show !== "both" || (link.expected > 0 && link.actual > 0);
    const kind = isBoth ? "" : link.expected > 0 ? "missing" : "extra";
    group.append(svg("path", { class: `link ${kind} ${knows === 1 ? "one-sided" : ""}`, d: linkPath(...points) }));
  }
  return group;
}

// Rings around the vertices at which a ghost is wrong, and the segments to point out.
function drawSigns(state, show) {
  const group = svg("g", { class: "signs" });
  const vertices = new Set();
  for (const { kind, expected } of differencesOf(state)) {
    if (kind === "ghost1") vertices.add(data.segments[expected].start);
    if (kind === "ghost2") vertices.add(data.segments[expected].end);
  }
  if (show === "both") {
    for (const vertex of vertices) {
      const { x, y } = pixelsOf(vertex);
      group.append(svg("circle", { class: "ring", cx: round(x), cy: round(y), r: 15 }));
    }
  }
  for (const { start, end } of markedOf(state)) {
    group.append(svg("path", { class: "marked", d: linePath(pixelsOf(start), pixelsOf(end)) }));
  }
  return group;
}

// Draws all of it anew. What is highlighted goes into the groups that are returned, below and above the outline.
function drawStep(state, show) {
  drawing.setAttribute("viewBox", `0 0 ${view.width} ${view.height}`);
  const focused = document.activeElement?.dataset?.key;
  const under = svg("g", { class: "highlight" });
  const over = svg("g", { class: "highlight" });
  const [lines, hits] = drawOutline(state, show);
  const [solids, names] = drawPolygons(state);
  lines.classList.toggle("past", !state.isCommit);
  drawing.replaceChildren(solids, drawGrid(), drawEdited(state), names, under, drawSigns(state, show),
    lines, drawLinks(state, show), drawAxes(), over, hits);
  if (focused) drawing.querySelector(`[data-key="${focused}"]`)?.focus({ preventScroll: true });
  return { under, over };
}
