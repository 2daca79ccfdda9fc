// The outline as polylines, chunk by chunk, for whoever draws it: Phaser, Pixi, a canvas. After a commit it gives the
// chunks whose lines have changed, so that a game draws anew only those.
import type { CellRect, Changes, SegmentId, SegmentList, World } from './types.js'

export interface ChunkLines {
  /** Names the chunk: the same string for the same chunk. */
  readonly key: string
  /** Its cells. */
  readonly cells: CellRect
  /**
   * x, y, x, y, … in cells of the world. The solid is on the left. A line that comes back to its first vertex is
   * closed. There are none where the chunk has no outline any more.
   */
  readonly lines: readonly Float64Array[]
}

export class OutlineLines {
  readonly #world: World
  readonly #chunkCells: number
  readonly #chunkOf: string[] = [] // by segment id
  readonly #cells = new Map<string, CellRect>()
  #version: bigint

  constructor(world: World, chunkCells = 16) {
    this.#world = world
    this.#chunkCells = chunkCells
    this.#version = world.version
    this.#note(world.segments())
  }

  /** All chunks with lines. */
  all(): ChunkLines[] {
    return [...this.#cells.keys()].map((key) => this.#linesOf(key))
  }

  /** The chunks that a commit or a roll-back changed. Give it each one's changes, in order. */
  update(changes: Changes): ChunkLines[] {
    if (changes.before === changes.after) return []
    if (changes.before !== this.#version)
      throw new Error('these changes do not follow those that were drawn: make an OutlineLines anew')
    this.#version = changes.after
    const touched = new Set<string>()
    for (const id of changes.removed) touched.add(this.#chunkOf[id]!)
    for (const id of changes.relinked.id) touched.add(this.#chunkOf[id]!)
    for (const key of this.#note(changes.added)) touched.add(key)
    return [...touched].map((key) => this.#linesOf(key))
  }

  #note(segments: SegmentList): Set<string> {
    const keys = new Set<string>()
    const { id, cell } = segments
    const n = this.#chunkCells
    for (let k = 0; k < id.length; ++k) {
      const i0 = Math.floor(cell[2 * k]! / n) * n
      const j0 = Math.floor(cell[2 * k + 1]! / n) * n
      const key = `${i0} ${j0}`
      this.#chunkOf[id[k]!] = key
      if (!keys.has(key)) this.#cells.set(key, { i0, j0, i1: i0 + n - 1, j1: j0 + n - 1 })
      keys.add(key)
    }
    return keys
  }

  #linesOf(key: string): ChunkLines {
    const cells = this.#cells.get(key)!
    const lines = chain(this.#world.segments(cells))
    if (lines.length === 0) this.#cells.delete(key)
    return { key, cells, lines }
  }
}

/** Joins segments that follow each other. A vertex where the line goes straight on is left out. */
export function chain(segments: SegmentList): Float64Array[] {
  const { id, geometry, predecessor, successor } = segments
  const at = new Map<SegmentId, number>()
  for (let k = 0; k < id.length; ++k) at.set(id[k]!, k)
  const done = new Uint8Array(id.length)
  const lines: Float64Array[] = []
  const follow = (first: number): void => {
    const line = [geometry[8 * first]!, geometry[8 * first + 1]!]
    for (let k: number | undefined = first; k !== undefined && !done[k]; k = at.get(successor[k]!)) {
      done[k] = 1
      goTo(line, geometry[8 * k + 2]!, geometry[8 * k + 3]!)
    }
    lines.push(Float64Array.from(line))
  }
  for (let k = 0; k < id.length; ++k) if (!at.has(predecessor[k]!)) follow(k)
  for (let k = 0; k < id.length; ++k) if (!done[k]) follow(k) // closed ones, and those behind a link that is not mutual
  return lines
}

function goTo(line: number[], x: number, y: number): void {
  const n = line.length
  if (n >= 4) {
    const [x0, y0, x1, y1] = line.slice(-4) as [number, number, number, number]
    const [ux, uy] = [x1 - x0, y1 - y0]
    const [vx, vy] = [x - x1, y - y1]
    if (ux * vy === uy * vx && ux * vx + uy * vy > 0) {
      line[n - 2] = x
      line[n - 1] = y
      return
    }
  }
  line.push(x, y)
}
