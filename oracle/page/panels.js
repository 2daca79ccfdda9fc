// The texts beside the drawing. Texts of the data become text nodes, never markup.

const byId = (id) => document.getElementById(id);

function html(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const textOf = (point) => (point === null ? "none" : data.points[point].text);
const endsInWords = ({ start, end }) => `${textOf(start)} → ${textOf(end)}`;
const ownerOf = ({ owner }) => {
  if (owner === null) return "no polygon has this edge";
  const { name, cell } = data.polygons[owner];
  return `${name}, cell (${cell.join(", ")})`;
};

const kindInWords = {
  same: "as expected",
  missing: `missing: only ${data.expectedName} has it`,
  extra: `extra: only ${data.actualName} has it`,
  other: "there, but not as expected",
};

const wordsOf = (pair) => {
  const segment = anyOf(pair);
  const block = segment.block ? `block ${segment.block}, ` : "";
  return `${endsInWords(segment)}, ${segment.place}, ${block}${ownerOf(segment)}; ${kindInWords[kindOf(pair)]}`;
};

const rows = {
  block: ({ block }) => String(block),
  owner: ownerOf,
  ghost1: ({ ghost1 }) => textOf(ghost1),
  ghost2: ({ ghost2 }) => textOf(ghost2),
};

const sideNames = { expected: data.expectedName, actual: data.actualName };

// All that is known of a segment, for one outline or for both where they differ.
function showSegment(pair) {
  if (!pair) {
    byId("segment").replaceChildren(html("p", { class: "quiet" }, "Point at a segment, tap it, or go to it with Tab."));
    return;
  }
  const segment = anyOf(pair);
  const sides = kindOf(pair) === "same" ? ["expected"] : ["expected", "actual"].filter((side) => pair[side]);
  const table = html("table");
  if (sides.length === 2) {
    const heads = sides.map((side) => html("th", { scope: "col", class: side }, sideNames[side]));
    table.append(html("tr", {}, html("td"), ...heads));
  }
  for (const [name, words] of Object.entries(rows)) {
    const values = sides.map((side) => words(pair[side]));
    const differs = values.length === 2 && values[0] !== values[1];
    const head = html("th", { scope: "row" }, name);
    if (differs) head.append(html("span", { class: "differs" }, " ≠"));
    table.append(html("tr", {}, head, ...values.map((value) => html("td", {}, value))));
  }
  byId("segment").replaceChildren(
    html("p", {}, html("strong", {}, endsInWords(segment)), `, ${segment.place}; `,
      html("span", { class: `kind ${kindOf(pair)}` }, kindInWords[kindOf(pair)])), table);
}

function showDifferences(state) {
  const found = differencesOf(state);
  const items = found.map((difference) => {
    const { kind, text } = difference;
    const [title, ...rest] = text.split(": ");
    const words = [html("strong", { class: kind }, title), `: ${rest.join(": ")}`];
    return html("li", {}, html("button", { type: "button", "data-about": keyOfDifference(difference) }, ...words));
  });
  if (state.step.more > 0) items.push(html("li", { class: "quiet" }, `… and ${state.step.more} more`));
  if (items.length === 0) items.push(html("li", { class: "quiet" }, noDifference(state)));
  byId("differences").replaceChildren(...items);
  const number = found.length + (state.step.more ?? 0);
  byId("findings").textContent = number === 0 ? "Differences" : counted(number, "difference");
}

function noDifference(state) {
  if (state.step.wrong) return "No outline differs. What is wrong is in the report.";
  if (!state.isCommit) return "Not committed yet.";
  if (data.actualName === "") return `There is only one outline, that of the ${data.expectedName}.`;
  return `None: ${data.actualName} is as ${data.expectedName}.`;
}

function showStatus(state) {
  const words = [`Step ${state.index} of ${states.length - 1}`];
  if (state.isCommit && state.index > 0) words.push(`commit ${state.commits}`);
  const before = state.commits > 0 ? `: the outline is of commit ${state.commits}` : "";
  if (!state.isCommit) words.push(`not committed${before}`);
  words.push(counted(state.polygons.length, "polygon"), counted(state.pairs.size, "segment"));
  const found = differencesOf(state).length + (state.step.more ?? 0);
  if (found > 0) words.push(counted(found, "difference"));
  byId("status").textContent = words.join(" · ");
}

function nameOfStep({ edit }, index) {
  if (index > 0) return edit || "the end";
  return data.note === "" ? "an empty world" : "the world before";
}

function makeEdits() {
  byId("edits").append(...data.steps.map((step, index) => {
    const name = html("code", {}, nameOfStep(step, index));
    const button = html("button", { type: "button", "data-step": index, tabindex: -1 }, name);
    if (step.note) button.append(html("span", { class: "quiet" }, ` ${step.note}`));
    if (step.wrong) button.append(html("strong", { class: "wrong" }, " Here it goes wrong."));
    return html("li", {}, button);
  }));
}

function showCurrentEdit(state) {
  const list = byId("edits");
  list.querySelectorAll("button").forEach((button, index) => {
    const isCurrent = index === state.index;
    button.toggleAttribute("data-current", isCurrent);
    button.tabIndex = isCurrent ? 0 : -1;
    if (isCurrent) button.setAttribute("aria-current", "step");
    else button.removeAttribute("aria-current");
    // The list alone is scrolled, never the page.
    if (!isCurrent) return;
    const { offsetTop: top, offsetHeight } = button.parentElement;
    const bottom = top + offsetHeight;
    list.scrollTop = Math.min(top, Math.max(list.scrollTop, bottom - list.clientHeight));
  });
}

// What stays the same from step to step.
function showFixedTexts() {
  byId("title").textContent = data.title;
  byId("note").textContent = data.note;
  byId("note").hidden = data.note === "";
  byId("expected").textContent = data.expectedName;
  byId("actual").textContent = data.actualName;
  byId("expected").parentElement.hidden = data.actualName === "";
  byId("report-box").hidden = data.report === "";
  byId("report-box").open = differencesOf(states[states.length - 1]).length === 0;
  byId("preserve").hidden = data.preserve.length === 0;
  byId("preserve").textContent = `preserve ${data.preserve.map((pair) => pair.join(" ")).join(", preserve ")}`;
  const signs = { same: "as expected", missing: "missing", extra: "extra", other: "other ghost or block", link: "link",
    edited: "edited cell" };
  byId("legend").append(...Object.entries(signs).map(([kind, words]) => html("li", {},
    svg("svg", { viewBox: "0 0 34 12", width: 34, height: 12, "aria-hidden": "true" },
      svg("path", { class: kind === "link" || kind === "edited" ? kind : `segment ${kind}`, d: "M2 6H32" })), words)));
  makeEdits();
}
