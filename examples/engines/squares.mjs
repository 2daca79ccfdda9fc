// An engine for `lgs check --engine` in JavaScript, from the page of the protocol alone: whole squares, recomputed at
// each commit.
//
//     lgs check --engine 'node examples/engines/squares.mjs' --edits 2000
import {createInterface} from "node:readline";

const UNITS = 65536;  // of the lattice, in a cell
const SIDES = [  // of a cell: from corner to corner, the solid on the left; and the cell beyond
  {from: [0, 0], to: [1, 0], beyond: [0, -1]},
  {from: [1, 0], to: [1, 1], beyond: [1, 0]},
  {from: [1, 1], to: [0, 1], beyond: [0, 1]},
  {from: [0, 1], to: [0, 0], beyond: [-1, 0]},
];

const polygons = new Map();  // the cell of a name
const cells = new Map();     // the block of a cell
const key = (i, j) => `${i},${j}`;

function* outline() {
  for (const {i, j} of polygons.values()) {
    for (const {from, to, beyond} of SIDES) {
      if (cells.has(key(i + beyond[0], j + beyond[1]))) continue;
      const ends = [i + from[0], j + from[1], i + to[0], j + to[1]].map((corner) => corner * UNITS);
      yield `segment ${ends.join(" ")} - - - - ${cells.get(key(i, j))}`;
    }
  }
}

const answer = (...lines) => process.stdout.write(lines.join("\n") + "\n");

for await (const line of createInterface({input: process.stdin})) {
  const [word, name, i, j, block] = line.split(" ");
  if (word === "lgs-engine") {
    answer("lgs-engine 1 squares.mjs squares blocks");
  } else if (word === "reset") {
    polygons.clear();
    cells.clear();
  } else if (word === "add") {
    polygons.set(name, {i: Number(i), j: Number(j)});
    cells.set(key(i, j), block);
  } else if (word === "remove") {
    const cell = polygons.get(name);
    cells.delete(key(cell.i, cell.j));
    polygons.delete(name);
  } else if (word === "commit") {
    answer(...outline(), "end");
  }
}
