// What the terrains for physics engines have in common. The rules are the engine's, in C++: which edges there are, which
// are welded, which bodies new ground overlaps and how they get out. web/wasm/terrain.cpp is the other side. Here they are
// asked; what they say is done by planck.ts and box2d3.ts.
import { bad, int32, object, options as known, uint32, within } from './check.js'
import type { Engine } from './engine.js'
import { LgsError } from './error.js'
import type { Block, Changes, SegmentId, World } from './types.js'
import { placeOf } from './world.js'

export interface Point {
  readonly x: number
  readonly y: number
}

/** A convex shape of a body as the ground meets it: all that is within `radius` of its corners' hull. In cells. */
export interface Form<Material> extends Point {
  /** x, y, x, y, …: one, two, or a polygon, counter-clockwise. */
  readonly corners: readonly number[]
  readonly radius: number
  /** Whether it collides with blocks of this material. */
  holds(material: Material): boolean
}

/** What is done with bodies that new ground overlaps. */
export type OnOverlap = 'push' | 'disable' | 'leave'

export interface CommonOptions<Material> {
  /** The side of a cell in metres; 1 if not given. */
  cellSize?: number
  /** The cell whose lower left corner is (0, 0) of the physics world. */
  origin?: { readonly i: number; readonly j: number }
  /** Cells along the side of a chunk, 1 to 4,096; 16 if not given. */
  chunkCells?: number
  /**
   * Whether segments of equal materials that go straight on become one edge, as far as a chunk reaches: then a body that
   * rolls over a floor of many cells has one contact, which begins once.
   */
  merge?: boolean
  /** Asked once for each block. It may use the package. If it throws, nothing has changed. */
  material?: (block: Block) => Material
  /**
   * What is done with bodies that new ground overlaps. 'push' (the default): they are moved out, by the shortest
   * straight path that was found, and none of their centres crosses an edge of the old outline; a body without one is
   * disabled. 'disable': they are disabled, and enabled when a later sync nearby has made room. 'leave': nothing; they may fall
   * through the ground.
   */
  onOverlap?: OnOverlap
}

export interface Frame {
  readonly cellSize: number
  origin: { readonly i: number; readonly j: number }
}

export function onOverlapOf(value: OnOverlap | undefined): OnOverlap {
  if (value !== undefined && value !== 'push' && value !== 'disable' && value !== 'leave')
    throw bad('onOverlap', "'push', 'disable' or 'leave'", value)
  return value ?? 'push'
}

const names = ['cellSize', 'origin', 'chunkCells', 'merge', 'material', 'onOverlap'] as const

/** The options, checked. A terrain may have `more` of them. */
export function checked<Material>(options: CommonOptions<Material>, more: readonly string[]) {
  const { cellSize = 1, origin = { i: 0, j: 0 }, chunkCells = 16, merge = false, material, onOverlap } =
    known('options', [...names, ...more] as typeof names[number][], options)
  if (typeof merge !== 'boolean') throw bad('merge', 'true or false', merge)
  within('cellSize', cellSize, 2e-6, 1e9)
  within('chunkCells', int32('chunkCells', chunkCells), 1, 4096)
  if (material !== undefined && typeof material !== 'function') throw bad('material', 'a function', material)
  return { cellSize, origin: originOf(origin), chunkCells, merge, onOverlap: onOverlapOf(onOverlap), material: material ?? (() => ({}) as Material) }
}

export function originOf(cell: { readonly i: number; readonly j: number }) {
  object('origin', '{ i, j }', cell)
  return { i: int32('origin.i', cell.i), j: int32('origin.j', cell.j) }
}

/** What to do to a copy of the edges: first remove, then add, then relink. It is a copy: it stays. */
export class EdgeChanges {
  readonly removed: number
  readonly added: number
  /** Of edges that were added, and then of those that have other ghosts. */
  readonly length: number
  readonly #words: Uint32Array
  readonly #numbers: Float64Array
  readonly #ids: number // where they begin, in words

  constructor(words: Uint32Array) {
    this.#words = words
    this.#numbers = new Float64Array(words.buffer)
    this.removed = words[2]!
    this.added = words[3]!
    this.length = this.added + words[4]!
    this.#ids = 6 + 16 * this.length
  }
  get version(): number { return this.#numbers[0]! }
  removedId(k: number): number { return this.#words[this.#ids + k]! }
  id(k: number): number { return this.#words[this.#ids + this.removed + k]! }
  chunk(k: number): number { return this.#words[this.#ids + this.removed + this.length + k]! }
  block(k: number): Block { return this.#words[this.#ids + this.removed + 2 * this.length + k]! }
  segment(k: number): SegmentId { return this.#words[this.#ids + this.removed + 3 * this.length + k]! }
  /** x or y of start, end, ghost1, ghost2, in cells from the corner of the chunk; NaN where there is no ghost. */
  at(k: number, n: number): number { return this.#numbers[3 + 8 * k + n]! }
}

export interface Box {
  readonly x0: number
  readonly y0: number
  readonly x1: number
  readonly y1: number
}

/** What the changes are that are shown: nothing that matters to bodies, those of a commit, or whatever was done. */
const whichChanges = { nothing: 0, last: 1, all: 2 }

const misfits = {
  'not-the-last': 'these changes are not those of the last commit or roll-back of this world: sync each, before the next edit, or call resync()',
  'shown-already': 'the terrain shows these changes already: sync each once',
  'left-out': 'changes before these were left out: call resync()',
}

/** The rules for one world and one physics world. */
export class TerrainRules<Material> {
  #world: World
  readonly #material: (block: Block) => Material
  readonly #materials = new Map<Block, Material>()
  readonly #numbers: Map<string, number> | null // of materials, where edges merge
  #terrain: number // its address; 0 when it is gone
  #version = -1

  /** `shortest` is in cells. No edges yet: showAll() makes them. */
  constructor(world: World, chunkCells: number, shortest: number, merge: boolean, material: (block: Block) => Material) {
    const { engine, address } = placeOf(world)
    this.#world = world
    this.#material = material
    this.#numbers = merge ? new Map() : null
    this.#terrain = engine.call.terrain(address, chunkCells, Math.ceil(shortest * 65536), merge ? 1 : 0) >>> 0
  }

  /** The engine of a world that lives. */
  get #engine(): Engine {
    const { engine } = placeOf(this.#world)
    if (this.#terrain === 0) throw new LgsError('freed', 'this terrain was destroyed')
    return engine
  }

  /** What it kept in the engine goes. With the world it has gone already. */
  drop(): void {
    try {
      this.#engine.call.dropTerrain(this.#terrain)
    } catch (error) {
      if (!(error instanceof LgsError)) throw error
    }
    this.#terrain = 0
    this.#version = -1
  }

  // --- Materials: material() may use the package, or throw. So it is called before anything changes.

  materialOf(block: Block): Material {
    let material = this.#materials.get(block)
    if (material === undefined) {
      material = this.#material(block)
      object('what material() gives', 'an object', material as object)
      if (this.#numbers !== null) {
        const key = JSON.stringify(Object.entries(material as object).sort()), number = this.#numbers.get(key) ?? this.#numbers.size
        this.#numbers.set(key, number)
        this.#engine.call.materialIs(this.#terrain, block, number)
      }
      this.#materials.set(block, material)
    }
    return material
  }

  #askFor(blocks: Uint32Array): void {
    const unknown = new Set<Block>()
    for (let k = 0; k < blocks.length; ++k) if (!this.#materials.has(blocks[k]!)) unknown.add(blocks[k]!)
    for (const block of unknown) this.materialOf(block)
  }

  // --- Syncs, in two halves: between them bodies are looked at

  /** Throws if the changes do not follow what is shown. Whether there are any. */
  fits(changes: Changes): boolean {
    this.#check(changes)
    if (changes.before === changes.after) return false
    this.#askFor(changes.added.block)
    this.#check(changes)
    return true
  }

  #check(changes: Changes): void {
    const { before, after } = object('changes', 'those of a commit', changes)
    if (this.#terrain === 0) throw new LgsError('freed', 'this terrain was destroyed')
    const what = after !== this.#world.version ? 'not-the-last'
      : before === this.#version ? null
        : after === this.#version ? (before === after ? null : 'shown-already') : 'left-out'
    if (what !== null) throw new LgsError(what, misfits[what])
  }

  /** The first half: what is different from the edges. Around it a box, in cells; null if nothing is. */
  begin(which: keyof typeof whichChanges): Box | null {
    const engine = this.#engine
    if (!engine.call.beginSync(this.#terrain, whichChanges[which])) return null
    const [x0, y0, x1, y1] = engine.answer(4) as unknown as [number, number, number, number]
    return { x0, y0, x1, y1 }
  }

  /** The second half. */
  end(): EdgeChanges { return this.#end(0) }

  /** Before endAll(): from now on these are the rules of another world, or of the same. */
  follow(world: World): void {
    placeOf(world)
    this.#askFor(world.segments().block) // may free it
    const { engine, address } = placeOf(world)
    if (world === this.#world) return
    if (engine !== this.#engine) throw bad('world', 'of the same engine', world)
    engine.call.moveTerrain(this.#terrain, address)
    this.#world = world
  }
  endAll(): EdgeChanges { return this.#end(1) }

  #end(all: number): EdgeChanges {
    const engine = this.#engine
    const from = engine.call.endSync(this.#terrain, all) >>> 2, { words } = engine
    const changes = new EdgeChanges(words.slice(from, from + 2 * words[from + 5]!))
    this.#version = changes.version
    return changes
  }

  cornerOf(chunk: number): Point {
    const engine = this.#engine
    engine.call.chunkOf(this.#terrain, chunk)
    const [x, y] = engine.answer(2) as unknown as [number, number]
    return { x, y }
  }

  /** The edge of a segment; 0 if it has none. */
  edgeOf(segment: SegmentId): number {
    uint32('segment', segment)
    return this.#terrain === 0 ? 0 : this.#engine.call.edgeOf(this.#terrain, segment) >>> 0
  }
  /** Of the segments of an edge that one which is nearest to a point; 0 if they have changed since. */
  segmentAt(edge: number, { x, y }: Point): SegmentId { return this.#engine.call.segmentAt(this.#terrain, edge, x, y) >>> 0 }

  // --- Bodies

  /** Whether the change between begin() and end() overlaps a body of these forms; how deep, and the displacement. */
  overlap(forms: readonly Form<Material>[], tolerance: number): { depth: number; way: Point | null } | null {
    if (!this.#ask(forms, ({ call }, numbers) => call.overlap(this.#terrain, forms.length, numbers, tolerance))) return null
    const [depth, isFree, x, y] = this.#engine.answer(4) as unknown as [number, number, number, number]
    return { depth, way: isFree ? { x, y } : null }
  }

  /** The path of a disabled body out, where the last change has made room for it. */
  released(forms: readonly Form<Material>[], tolerance: number): Point | null {
    if (!this.#ask(forms, ({ call }, numbers) => call.released(this.#terrain, forms.length, numbers, tolerance))) return null
    const [x, y] = this.#engine.answer(2) as unknown as [number, number]
    return { x, y }
  }

  leavesRoom(forms: readonly Form<Material>[], tolerance: number): boolean {
    return this.#ask(forms, ({ call }, numbers) => call.fits(this.#terrain, forms.length, numbers, tolerance)) !== 0
  }

  /** Whether a centre came through ground on the path from the one place to the other. */
  crossed(before: readonly Form<Material>[], now: readonly Form<Material>[]): boolean {
    return this.#ask([...before, ...now], ({ call }, numbers) => call.crossed(this.#terrain, now.length, numbers)) !== 0
  }

  /** For each point (x, y, x, y, … in cells) the block of the solid there; -1 for none. Valid until the next call. */
  solids(points: readonly number[]): Float64Array {
    const engine = this.#engine
    engine.call.solids(this.#terrain, engine.put(points) / 2)
    return engine.answer(points.length / 2)
  }

  /** A polygon around each form, in cells. */
  outlines(forms: readonly Form<Material>[]): Float64Array[] {
    const engine = this.#engine
    const count = engine.call.outlines(forms.length, engine.put(numbersOf(forms)))
    const numbers = engine.answer(count)
    const rings: Float64Array[] = []
    for (let k = 0; k < count; ) {
      const end = k + 1 + 2 * numbers[k]!
      rings.push(numbers.slice(k + 1, end))
      k = end
    }
    return rings
  }

  /** Repeats until the materials of all blocks that were met are known: material() is called in between, and may free the world. */
  #ask(forms: readonly Form<Material>[], question: (engine: Engine, numbers: number) => number): number {
    const numbers = numbersOf(forms), unknown = new Set<Block>()
    for (;;) {
      const engine = this.#engine
      unknown.clear()
      engine.holds = (form, block) => {
        const material = this.#materials.get(block)
        if (material === undefined) unknown.add(block)
        return material === undefined || forms[form]!.holds(material)
      }
      engine.put(numbers)
      const answer = question(engine, numbers.length)
      if (unknown.size === 0) return answer
      for (const block of unknown) this.materialOf(block)
    }
  }
}

/** As lgs::web::inputForms() reads them. */
function numbersOf(forms: readonly Form<never>[] | readonly Form<any>[]): number[] {
  const numbers: number[] = []
  for (const { corners, radius, x, y } of forms) numbers.push(corners.length / 2, radius, x, y, ...corners)
  return numbers
}
