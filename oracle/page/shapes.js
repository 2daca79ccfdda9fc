// SVG elements, and the paths that the drawing is made of. All of this is in pixels, y down.

function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const round = (number) => Math.round(number * 100) / 100;
const at = ({ x, y }) => `${round(x)} ${round(y)}`;
const move = ({ x, y }, along, by) => ({ x: x + along.x * by, y: y + along.y * by });
const distance = (a, b) => Math.hypot(b.x - a.x, b.y - a.y);
const direction = (a, b) => {
  const length = distance(a, b) || 1;
  return { x: (b.x - a.x) / length, y: (b.y - a.y) / length };
};
// To the right of a direction, which is outside of the solid.
const outward = ({ x, y }) => ({ x: -y, y: x });

const linePath = (a, b) => `M${at(a)}L${at(b)}`;
const polygonPath = (corners) => `M${corners.map(at).join("L")}z`;

// A small arrow in the middle of a segment; nothing on a short one.
function arrowPath(a, b) {
  const length = distance(a, b);
  if (length < 22) return "";
  const along = direction(a, b);
  const middle = move(a, along, length * 0.55);
  const tail = move(middle, along, -9);
  return polygonPath([middle, move(tail, outward(along), 4), move(tail, outward(along), -4)]);
}

// A link: a curve on the free side, around the vertex `b`, from the segment that ends there to the one that leaves it.
function linkPath(a, b, c) {
  const kGap = 6;
  const [into, from] = [direction(a, b), direction(b, c)];
  const [side, otherSide] = [outward(into), outward(from)];
  const begin = move(move(b, into, -Math.min(18, distance(a, b) / 3)), side, kGap);
  const end = move(move(b, from, Math.min(18, distance(b, c) / 3)), otherSide, kGap);
  // At a corner that sticks out the curve goes around it, in a corner it stays off the walls.
  const sticksOut = into.x * from.y - into.y * from.x < 0 ? 0.8 : -0.5;
  let control = move(move(b, side, kGap), otherSide, kGap);
  control = move(move(control, into, kGap * sticksOut), from, -kGap * sticksOut);
  return `M${at(begin)}Q${at(control)} ${at(end)}`;
}

// A text that can be read on any ground.
const label = (where, text, attributes = {}) =>
  svg("text", { x: round(where.x), y: round(where.y), class: "label", ...attributes }, text);
