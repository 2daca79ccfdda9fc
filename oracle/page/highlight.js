// What is pointed out while a segment, or a sentence about one, has the pointer or the focus.

// The ghosts of a segment: each once where both outlines have the same, else that of each outline which is shown.
function ghostsOf(pair, show) {
  const sides = ["expected", "actual"].filter((side) => pair[side] && (show === "both" || show === side));
  return [["ghost1", "start"], ["ghost2", "end"]].flatMap(([name, end]) => {
    const isSame = sides.length < 2 ? kindOf(pair) === "same" : pair.expected[name] === pair.actual[name];
    if (isSame) return [{ kind: "plain", words: name, ghost: anyOf(pair)[name], vertex: anyOf(pair)[end] }];
    return sides.map((side) => ({
      kind: side === "expected" ? "missing" : "extra",
      words: `${name} ${side}`,
      ghost: pair[side][name],
      vertex: pair[side][end],
    }));
  }).filter(({ ghost }) => ghost !== null);
}

// A label above or below a vertex, moved so that no part of it is outside of the drawing.
function vertexLabel(vertex, words, isAbove) {
  const { x, y } = pixelsOf(vertex);
  const half = words.length * 3.6;
  const where = { x: Math.max(half, Math.min(view.width - half, x)), y: y + (isAbove ? -12 : 22) };
  return label(where, words, { "text-anchor": "middle" });
}

function pointOut({ under, over }, pair, show) {
  const { start, end } = anyOf(pair);
  under.append(svg("path", { class: "halo", d: linePath(pixelsOf(start), pixelsOf(end)) }));
  const ghosts = ghostsOf(pair, show);
  const labels = new Map();
  for (const { kind, words, ghost, vertex } of ghosts) {
    over.append(svg("path", { class: `way ${kind}`, d: linePath(pixelsOf(ghost), pixelsOf(vertex)) }));
    const key = `${ghost} ${kind === "missing"}`;
    if (!labels.has(key)) labels.set(key, { ghost, isAbove: kind === "missing", words: [] });
    labels.get(key).words.push(words);
  }
  for (const { kind, ghost } of ghosts) {
    const { x, y } = pixelsOf(ghost);
    over.append(svg("circle", { class: `dot ${kind}`, cx: round(x), cy: round(y), r: kind === "missing" ? 7 : 4 }));
  }
  for (const { ghost, isAbove, words } of labels.values()) over.append(vertexLabel(ghost, words.join(", "), isAbove));
}

// Highlights a segment by its key, and the sentences about it; nothing if there is no such segment.
function highlight(groups, state, key, show) {
  groups.under.replaceChildren();
  groups.over.replaceChildren();
  const pair = state.pairs.get(key);
  if (pair) pointOut(groups, pair, show);
  document.querySelectorAll("#differences button").forEach((button) => {
    button.classList.toggle("lit", key !== null && button.dataset.about === key);
  });
  drawing.querySelectorAll(".hit").forEach((hit) => hit.classList.toggle("lit", hit.dataset.key === key));
  showSegment(pair ?? null);
}
