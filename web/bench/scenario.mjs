// What is measured: 100 x 100 cells, full blocks or random ramps. An edit removes a polygon somewhere, or brings back the
// one that was removed 200 edits ago, in turn. native.cpp does the same with the same random numbers.
export const side = 100
export const holes = 100

/** std::minstd_rand */
export function randomNumbers() {
  let state = 1
  return (below) => (state = (state * 48271) % 2147483647) % below
}

const square = [[0, 0], [1, 0], [1, 1], [0, 1]]
const ramps = [0, 1, 2, 3].map((left) => square.filter((_, k) => k !== left))
export const shapesOf = { full: [square], ramps }

/** The index of each cell's shape, row by row. */
export function shapesOfCells(kind, random) {
  return Array.from({ length: side * side }, () => (kind === 'full' ? 0 : random(4)))
}

/** The edits, without end: a cell, and whether it is filled. */
export class Edits {
  #random
  #isHole = new Uint8Array(side * side)
  #order = new Uint16Array(holes)
  #next = 0
  constructor(random) { this.#random = random }

  /** The first ones only remove, until there are enough holes. */
  dig() {
    let cell
    do cell = this.#random(side * side)
    while (this.#isHole[cell] === 1)
    this.#isHole[cell] = 1
    this.#order[this.#next] = cell
    this.#next = (this.#next + 1) % holes
    return cell
  }
  refill() {
    const cell = this.#order[this.#next]
    this.#isHole[cell] = 0
    return cell
  }
}
