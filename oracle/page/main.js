// Buttons, keys, pointers: what is shown, and what changes it.

const shown = { index: states.length - 1, show: "both", groups: null, timer: null, key: null };
const current = () => states[shown.index];

function draw() {
  shown.groups = drawStep(current(), shown.show);
  highlight(shown.groups, current(), shown.key, shown.show);
}

function go(index) {
  shown.index = Math.max(0, Math.min(states.length - 1, index));
  shown.key = null;
  const place = placeBox(current());
  if (place && !isInView(place)) fitPlace(current());
  byId("first").disabled = byId("back").disabled = shown.index === 0;
  byId("last").disabled = byId("next").disabled = shown.index === states.length - 1;
  showStatus(current());
  showDifferences(current());
  showCurrentEdit(current());
  draw();
}

function stop() {
  clearInterval(shown.timer);
  shown.timer = null;
  byId("play").textContent = "Play";
  byId("play").setAttribute("aria-pressed", "false");
}

function play() {
  if (shown.timer !== null) return stop();
  const kStepTime = 900; // milliseconds
  if (shown.index === states.length - 1) go(0);
  byId("play").textContent = "Stop";
  byId("play").setAttribute("aria-pressed", "true");
  shown.timer = setInterval(() => {
    go(shown.index + 1);
    if (shown.index === states.length - 1) stop();
  }, kStepTime);
}

const step = (index) => () => (stop(), go(index()));
const look = (change) => () => (change(), draw());
const show = (side) => () => {
  shown.show = side;
  for (const other of ["expected", "actual", "both"]) byId(other).setAttribute("aria-pressed", String(other === side));
  draw();
};
// From the segment that is pointed out to one that it is linked with.
const follow = (keyOfNext) => () => {
  const pair = current().pairs.get(shown.key);
  const segment = pair && (shown.show === "expected" ? pair.expected : (pair.actual ?? pair.expected));
  const next = segment && drawing.querySelector(`[data-key="${keyOfNext(segment)}"]`);
  next?.focus({ preventScroll: true });
};

const actions = {
  first: step(() => 0),
  back: step(() => shown.index - 1),
  next: step(() => shown.index + 1),
  last: step(() => states.length - 1),
  play,
  closer: look(() => zoom(1.5)),
  farther: look(() => zoom(1 / 1.5)),
  whole: look(fitWhole),
  place: look(() => fitPlace(current())),
  expected: show("expected"),
  actual: show("actual"),
  both: show("both"),
};
const keys = {
  ArrowLeft: actions.back, ArrowRight: actions.next, Home: actions.first, End: actions.last, " ": play,
  "+": actions.closer, "=": actions.closer, "-": actions.farther, 0: actions.whole, d: actions.place,
  1: actions.expected, 2: actions.actual, 3: actions.both, n: follow(successorKey), p: follow(predecessorKey),
};

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const isControl = event.target.closest?.("button, summary");
    if (isControl && event.key === " ") return; // it presses the button
    const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}

// The pointer comes before the focus: it is where one looks.
function listenToHighlights() {
  const set = (key) => {
    if (shown.key === key) return;
    shown.key = key;
    highlight(shown.groups, current(), key, shown.show);
  };
  const keyAt = (element) => element?.dataset?.key ?? element?.closest?.("[data-about]")?.dataset.about ?? null;
  const rest = () => set(keyAt(document.activeElement));
  for (const area of [drawing, byId("differences")]) {
    area.addEventListener("pointerover", (event) => (keyAt(event.target) ? set(keyAt(event.target)) : rest()));
    area.addEventListener("pointerleave", rest);
    area.addEventListener("focusin", (event) => set(keyAt(event.target)));
    area.addEventListener("focusout", (event) => event.relatedTarget && rest());
  }
  byId("differences").addEventListener("click", (event) => {
    if (!keyAt(event.target)) return;
    const box = placeBox(current());
    if (!isInView(box)) look(() => fitPlace(current()))();
  });
}

// One pointer pans, two zoom.
function listenToPointers() {
  const pointers = new Map();
  const where = ({ clientX, clientY }) => {
    const { left, top } = drawing.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  };
  drawing.addEventListener("pointerdown", (event) => pointers.set(event.pointerId, where(event)));
  const forget = ({ pointerId }) => pointers.delete(pointerId);
  window.addEventListener("pointerup", forget);
  window.addEventListener("pointercancel", forget);
  window.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = where(event);
    pointers.set(event.pointerId, now);
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) zoom(distance(other, now) / (distance(other, before) || 1), other);
    else pan(now.x - before.x, now.y - before.y);
    draw();
  });
  drawing.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY / 400), where(event));
    draw();
  }, { passive: false });
}

// Whether the drawing has another size than before.
function measure() {
  const { clientWidth: width, clientHeight: height } = drawing;
  const isOther = width !== view.width || height !== view.height;
  Object.assign(view, { width, height });
  return isOther;
}

function begin() {
  showFixedTexts();
  for (const [id, action] of Object.entries(actions)) byId(id).addEventListener("click", action);
  byId("edits").addEventListener("click", (event) => {
    const button = event.target.closest("button");
    if (button) step(() => Number(button.dataset.step))();
  });
  listenToKeys();
  listenToHighlights();
  listenToPointers();
  measure();
  fitWhole();
  const kSmall = 24; // pixels a cell: with less one sees little of a step
  if (view.scale < kSmall) fitPlace(current());
  go(states.length - 1);
  new ResizeObserver(() => measure() && draw()).observe(drawing);
}

begin();
