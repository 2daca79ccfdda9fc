// What is pointed out while a segment, or a sentence about one, has the pointer or the focus.

const sideNames = { expected: data.expectedName, actual: data.actualName };

function dot(point, kind, text, above) {
  const where = pixelsOf(point);
  const words = label(move(where, { x: 0, y: 1 }, above ? -12 : 20), text, { "text-anchor": "middle" });
  return [svg("circle", { class: `dot ${kind}`, cx: round(where.x), cy: round(where.y), r: 5 }), words];
}

// A segment's ghosts, and the way to them.
function ghostsOf(segment, kind, name) {
  const of = name ? `, ${name}` : "";
  const signs = [];
  const add = (ghost, vertex, text, above) => {
    if (ghost === null) return;
    signs.push(svg("path", { class: `way ${kind}`, d: linePath(pixelsOf(ghost), pixelsOf(vertex)) }));
    signs.push(...dot(ghost, kind, text + of, above));
  };
  add(segment.ghost1, segment.start, "ghost1", kind === "missing");
  add(segment.ghost2, segment.end, "ghost2", kind === "missing");
  return signs;
}

// Where both outlines have the same ghosts there is one of each; else those of the two, by name.
function pointOut({ under, over }, pair) {
  const { expected, actual } = pair;
  const { start, end } = anyOf(pair);
  under.append(svg("path", { class: "halo", d: linePath(pixelsOf(start), pixelsOf(end)) }));
  const same = expected && actual && expected.ghost1 === actual.ghost1 && expected.ghost2 === actual.ghost2;
  if (same) {
    over.append(...ghostsOf(expected, "plain", ""));
  } else {
    if (expected) over.append(...ghostsOf(expected, "missing", data.expectedName));
    if (actual) over.append(...ghostsOf(actual, "extra", data.actualName));
  }
}

// Highlights a segment by its key, and the sentences about it; nothing if there is no such segment.
function highlight(groups, state, key) {
  groups.under.replaceChildren();
  groups.over.replaceChildren();
  const pair = state.pairs.get(key);
  if (pair) pointOut(groups, pair);
  document.querySelectorAll("#differences button").forEach((button) => {
    button.classList.toggle("lit", key !== null && button.dataset.about === key);
  });
  drawing.querySelectorAll(".hit").forEach((hit) => hit.classList.toggle("lit", hit.dataset.key === key));
  showSegment(pair ?? null);
}
