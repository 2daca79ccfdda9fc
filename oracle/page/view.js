// Where the points of the world are on the screen. A view has its centre in lattice units, and a scale in pixels a
// cell. Numbers in lattice units are exact, and pixels are made of differences of them: so far cells are drawn as near
// ones are.

const unit = data.unitsPerCell;
const view = { x: 0, y: 0, scale: 64, width: 600, height: 400 };
const kLeastScale = 1e-7;
const kLargestScale = 4 * unit; // a lattice unit is four pixels

const toPixels = ({ x, y }) => ({
  x: ((x - view.x) / unit) * view.scale + view.width / 2,
  y: view.height / 2 - ((y - view.y) / unit) * view.scale,
});

const pixelsOf = (point) => toPixels(data.points[point]);

// The smallest box around some points; null around none.
function boxOf(points) {
  if (points.length === 0) return null;
  const box = { left: Infinity, bottom: Infinity, right: -Infinity, top: -Infinity };
  for (const { x, y } of points) {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.bottom = Math.min(box.bottom, y);
    box.top = Math.max(box.top, y);
  }
  return box;
}

const pointsOf = (numbers) => numbers.map((number) => data.points[number]);
const cornersOf = (polygons) => pointsOf(polygons.flatMap((polygon) => data.polygons[polygon].corners));

// Everything that ever stands there, so that the view stays as it is from step to step.
const wholeBox = () => boxOf(cornersOf(data.polygons.map((_, number) => number)));

// What a step is about: its differences, or else what it edits; null if it is about nothing.
function placeBox(state) {
  const segments = differencesOf(state)
    .flatMap(({ expected, actual }) => [expected, actual])
    .filter((number) => number !== null)
    .map((number) => data.segments[number])
    .concat(markedOf(state));
  if (segments.length > 0) return boxOf(pointsOf(segments.flatMap(({ start, end }) => [start, end])));
  const polygons = [...state.added, ...state.removed];
  if (state.index > 0 && polygons.length > 0) return boxOf(cornersOf(polygons));
  const corner = (i, j) => ({ x: i * unit, y: j * unit });
  return boxOf(state.edited.flatMap(([i, j]) => [corner(i, j), corner(i + 1, j + 1)]));
}

// Shows a box with some room around it, in cells.
function fit(box, room) {
  const { left, bottom, right, top } = box ?? { left: 0, bottom: 0, right: unit, top: unit };
  const kLargest = 150; // pixels a cell: more is for those who zoom in
  const across = (right - left) / unit + 2 * room;
  const high = (top - bottom) / unit + 2 * room;
  view.x = left + (right - left) / 2;
  view.y = bottom + (top - bottom) / 2;
  view.scale = Math.min(kLargest, view.width / across, view.height / high);
}

const fitWhole = () => fit(wholeBox(), 0.4);
const fitPlace = (state) => fit(placeBox(state) ?? wholeBox(), 1.2);

function isInView(box) {
  const low = toPixels({ x: box.left, y: box.bottom });
  const high = toPixels({ x: box.right, y: box.top });
  return low.x >= 0 && high.x <= view.width && high.y >= 0 && low.y <= view.height;
}

// Whether something between these pixels may be seen.
const touchesView = (pixels, margin = 40) => {
  const { left, right, bottom, top } = boxOf(pixels);
  return left <= view.width + margin && right >= -margin && bottom <= view.height + margin && top >= -margin;
};

function pan(dx, dy) {
  view.x -= (dx / view.scale) * unit;
  view.y += (dy / view.scale) * unit;
}

// Zooms by a factor, and keeps what is at these pixels where it is.
function zoom(factor, at = { x: view.width / 2, y: view.height / 2 }) {
  const scale = Math.min(kLargestScale, Math.max(kLeastScale, view.scale * factor));
  const dx = at.x - view.width / 2;
  const dy = at.y - view.height / 2;
  view.x += (dx / view.scale - dx / scale) * unit;
  view.y -= (dy / view.scale - dy / scale) * unit;
  view.scale = scale;
}
