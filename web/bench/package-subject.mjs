// The package as a subject of timings: edits of single tiles, and a world from nothing.
import { Edits, holes, randomNumbers, shapesOf, shapesOfCells, side } from './scenario.mjs'

const block = 7
export const cells = Array.from({ length: side * side }, (_, cell) => [cell % side, Math.floor(cell / side)])

/** Runs a task, and returns the nanoseconds of the processor: the clock on the wall knows of other programs, too. */
export function timed(task) {
  const start = process.cpuUsage()
  task()
  const { user, system } = process.cpuUsage(start)
  return 1000 * (user + system)
}

/** Everything that a commit handed out, added up; what the native engine names otherwise is added elsewhere. */
class Reader {
  sum = 0
  owners = 0
  read(changes) {
    const { removed } = changes
    for (let k = 0; k < removed.length; ++k) this.sum += removed[k]
    this.#readList(changes.added)
    this.#readList(changes.relinked)
  }
  #readList({ length, id, geometry, block, cell, predecessor, successor, owner }) {
    let sum = 0, owners = 0
    for (let k = 0; k < 8 * length; k += 2) sum += geometry[k] + 2 * geometry[k + 1]
    for (let k = 0; k < length; ++k) {
      sum += id[k] + block[k] + cell[2 * k] + cell[2 * k + 1] + predecessor[k] + successor[k]
      owners += owner[k]
    }
    this.sum += sum
    this.owners += owners
  }
}

export class Package {
  #createWorld
  #kind
  #random = randomNumbers()
  #reader = new Reader()
  #shapes
  #world
  #ids
  #handles
  #edits
  constructor(createWorld, kind) {
    this.#createWorld = createWorld
    this.#kind = kind
    this.#shapes = shapesOfCells(kind, this.#random)
    this.#edits = new Edits(this.#random)
    this.#make()
  }
  get sum() { return this.#reader.sum }

  #make() {
    this.#world = this.#createWorld()
    this.#ids = shapesOf[this.#kind].map((vertices) => this.#world.shape(vertices))
    const entries = new Int32Array(4 * cells.length)
    cells.forEach(([i, j], cell) => entries.set([i, j, this.#ids[this.#shapes[cell]], block], 4 * cell))
    this.#handles = this.#world.addMany(entries)
    this.#reader.read(this.#world.commit())
  }
  build() {
    this.#world.free()
    return timed(() => this.#make())
  }

  #dig() {
    this.#world.remove(this.#handles[this.#edits.dig()])
    this.#reader.read(this.#world.commit())
  }
  #refill() {
    const cell = this.#edits.refill(), [i, j] = cells[cell]
    this.#handles[cell] = this.#world.add(i, j, this.#ids[this.#shapes[cell]], block)
    this.#reader.read(this.#world.commit())
  }
  digHoles() { for (let k = 0; k < holes; ++k) this.#dig() }
  edits(count) {
    return timed(() => {
      for (let k = 0; k < count; k += 2) {
        this.#refill()
        this.#dig()
      }
    }) / count
  }
}
