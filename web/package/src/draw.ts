// What a game draws, chunk by chunk: lines along the outline, and filled triangles. After a commit those chunks come that
// look different, so that a game draws only these again. Phaser, Pixi, a canvas: examples/ has each.
import earcut from 'earcut'
import { int32, object, rect, within } from './check.js'
import { LgsError } from './error.js'
import { linesIn } from './lines.js'
import type { Block, CellRect, Changes, SegmentId, Version, World } from './types.js'
import { placeOf } from './world.js'

export { linesIn } from './lines.js'
export { type Fill, GroundPicture } from './picture.js'

interface Chunk {
  /** Names the chunk: the same string for the same chunk. */
  readonly key: string
  /** Its cells. */
  readonly cells: CellRect
}

export interface ChunkLines extends Chunk {
  /**
   * x, y, x, y, … in cells of the world. The solid is on the left. A line that comes back to its first vertex is
   * closed. There are none where the chunk has no outline any more.
   */
  readonly lines: readonly Float64Array[]
}

export interface ChunkMesh extends Chunk {
  /** x, y of each vertex, in cells from the lower left corner of the chunk: so they are precise however far it is. */
  readonly positions: Float32Array
  /** Three vertices a triangle, counter-clockwise. There are none where the chunk has no ground any more. */
  readonly indices: Uint32Array
  /** The block of each vertex. */
  readonly blocks: Uint32Array
}

/** Squares of cells, by the cells in them. */
class Chunks {
  readonly #side: number
  readonly #rows = new Map<number, Map<number, Chunk>>()
  #last: Chunk | null = null

  constructor(side: number) { this.#side = within('chunkCells', int32('chunkCells', side), 1, 4096) }

  at(i: number, j: number): Chunk {
    const last = this.#last?.cells
    if (last && i >= last.i0 && i <= last.i1 && j >= last.j0 && j <= last.j1) return this.#last!
    const n = this.#side, column = Math.floor(i / n), row = Math.floor(j / n)
    let chunks = this.#rows.get(row)
    if (!chunks) this.#rows.set(row, (chunks = new Map()))
    let chunk = chunks.get(column)
    if (!chunk) {
      const i0 = column * n, j0 = row * n
      chunks.set(column, (chunk = { key: `${i0} ${j0}`, cells: { i0, j0, i1: i0 + n - 1, j1: j0 + n - 1 } }))
    }
    return (this.#last = chunk)
  }
}

/** Refuses changes that do not follow what is drawn. */
function follow(changes: Changes, version: Version, world: World): void {
  void object('changes', 'those of a commit', changes).removed  // refused where they are not the last ones
  if (changes.before !== version || changes.after !== world.version)
    throw new LgsError('left-out', 'these changes do not follow those that were drawn: make it again, for all chunks')
}

export class OutlineLines {
  readonly #world: World
  readonly #chunks: Chunks
  readonly #chunkOf: (Chunk | undefined)[] = [] // by segment id
  readonly #drawn = new Set<Chunk>()
  #version: Version

  constructor(world: World, chunkCells = 16) {
    placeOf(world)
    this.#world = world
    this.#chunks = new Chunks(chunkCells)
    this.#version = world.version
    const { id, cell } = world.segments()
    for (let k = 0; k < id.length; ++k) this.#drawn.add(this.#note(id[k]!, cell[2 * k]!, cell[2 * k + 1]!))
  }

  /** All chunks with lines. */
  all(): ChunkLines[] { return [...this.#drawn].map((chunk) => this.#linesOf(chunk)) }

  /** The chunks that a commit or a roll-back changed. Give it each one's changes, in order, before the next commit. */
  update(changes: Changes): ChunkLines[] {
    follow(changes, this.#version, this.#world)
    if (changes.before === changes.after) return []
    const touched = new Set<Chunk>()
    const { removed, added: { id, cell }, relinked: { id: relinked }, after } = changes
    this.#version = after
    for (let k = 0; k < removed.length; ++k) touched.add(this.#chunkOf[removed[k]!]!)
    for (let k = 0; k < relinked.length; ++k) touched.add(this.#chunkOf[relinked[k]!]!)
    for (let k = 0; k < id.length; ++k) touched.add(this.#note(id[k]!, cell[2 * k]!, cell[2 * k + 1]!))
    return [...touched].map((chunk) => this.#linesOf(chunk))
  }

  #note(id: SegmentId, i: number, j: number): Chunk { return (this.#chunkOf[id] = this.#chunks.at(i, j)) }

  #linesOf(chunk: Chunk): ChunkLines {
    const lines = linesIn(this.#world, chunk.cells)
    if (lines.length === 0) this.#drawn.delete(chunk)
    else this.#drawn.add(chunk)
    return { ...chunk, lines }
  }
}

/** The polygons in a rectangle of cells as triangles, with positions from its lower left corner. */
export function trianglesIn(world: World, cells: CellRect): Omit<ChunkMesh, 'key'> {
  placeOf(world)
  const { i0, j0 } = rect(cells)
  const positions: number[] = [], indices: number[] = [], blocks: Block[] = []
  for (const { i, j, block, vertices } of world.polygons(cells)) {
    const first = blocks.length
    for (let k = 0; k < vertices.length; k += 2) {
      positions.push(i - i0 + vertices[k]!, j - j0 + vertices[k + 1]!)
      blocks.push(block)
    }
    if (isConvex(vertices)) for (let k = 2; k < vertices.length / 2; ++k) indices.push(first, first + k - 1, first + k)
    else for (const index of earcut(vertices)) indices.push(first + index)
  }
  return { cells, positions: Float32Array.from(positions), indices: Uint32Array.from(indices), blocks: Uint32Array.from(blocks) }
}

/** Whether a fan from the first vertex is all of it. */
function isConvex(v: Float64Array): boolean {
  const n = v.length
  for (let k = 0; k < n; k += 2) {
    const [x0, y0, x1, y1, x2, y2] = [v[k]!, v[k + 1]!, v[(k + 2) % n]!, v[(k + 3) % n]!, v[(k + 4) % n]!, v[(k + 5) % n]!]
    if ((x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1) < 0) return false
  }
  return true
}

/** The ground as filled triangles. Make it while no edit waits for its commit, and while there is no mark. */
export class GroundMeshes {
  readonly #world: World
  readonly #chunks: Chunks
  readonly #drawn = new Set<Chunk>()
  #version: Version

  constructor(world: World, chunkCells = 16) {
    const { engine, address } = placeOf(world)
    this.#world = world
    this.#chunks = new Chunks(chunkCells)
    this.#version = world.version
    if (!engine.call.followCells(address)) throw engine.failure()
    for (const { i, j } of world.polygons()) this.#drawn.add(this.#chunks.at(i, j))
  }

  /** All chunks with ground. */
  all(): ChunkMesh[] { return [...this.#drawn].map((chunk) => this.#meshOf(chunk)) }

  /** The chunks that a commit or a roll-back changed. Give it each one's changes, in order, before the next edit. */
  update(changes: Changes): ChunkMesh[] {
    follow(changes, this.#version, this.#world)
    this.#version = changes.after
    // A block may have changed where no segment has.
    const { engine, address } = placeOf(this.#world)
    const numbers = engine.answer(engine.call.changedCells(address))
    const touched = new Set<Chunk>()
    for (let k = 0; k < numbers.length; k += 2) touched.add(this.#chunks.at(numbers[k]!, numbers[k + 1]!))
    return [...touched].map((chunk) => this.#meshOf(chunk))
  }

  #meshOf(chunk: Chunk): ChunkMesh {
    const mesh = { key: chunk.key, ...trianglesIn(this.#world, chunk.cells) }
    if (mesh.indices.length === 0) this.#drawn.delete(chunk)
    else this.#drawn.add(chunk)
    return mesh
  }
}
