// The world: each method checks its arguments, calls the engine once, and makes objects of the answer.
import { bad, flat, int32, options as known, real, reals, rect, uint32, whole } from './check.js'
import { type Engine, engine } from './engine.js'
import { LgsError } from './error.js'
import { inspect, shown } from './inspect.js'
import { changesOf, Lists, listOf } from './lists.js'
import { putRegion } from './regions.js'
import { bytesOf, textOf } from './text.js'
import type {
  Block, BrushResult, CellRect, Changes, Hit, Loop, Mark, Nearest, Polygon, PolygonId, RayHit, Region, Segment,
  SegmentId, SegmentList, ShapeId, Spot, Stats, UnloadedChunk, Version, Vertices, World, WorldOptions,
} from './types.js'

const brushLists = ['removed', 'added', 'rounded']

/** Each list is made when it is first read. A large stroke names millions of polygons, which are hardly ever read. */
class Brushed implements BrushResult {
  readonly #numbersOf: (list: string) => Float64Array
  readonly #lists: Record<string, readonly PolygonId[]> = {}
  #changed?: BrushResult['changed']
  constructor(numbersOf: (list: string) => Float64Array) { this.#numbersOf = numbersOf }

  get removed() { return this.#list('removed') }
  get added() { return this.#list('added') }
  get rounded() { return this.#list('rounded') }
  get changed() { return (this.#changed ??= this.#changes()) }

  #list(name: string): readonly PolygonId[] { return (this.#lists[name] ??= Array.from(this.#numbersOf(name))) }
  #changes() {
    const numbers = this.#numbersOf('changed')
    const changes: { old: PolygonId; now: PolygonId[] }[] = []
    for (let k = 0; k < numbers.length; ) {
      const end = k + 2 + numbers[k + 1]!
      changes.push({ old: numbers[k]!, now: Array.from(numbers.subarray(k + 2, end)) })
      k = end
    }
    return changes
  }
}

/** What makes a world in the engine: its address, or 0 and a failure. */
export type Maker = (engine: Engine, relation: number, isFloat: number) => number

class EngineWorld implements World {
  #engine: Engine
  #world: number
  #relation: number
  readonly #changes: Lists
  readonly #segments: Lists
  readonly #options: WorldOptions
  #brush = 0
  #isInGroup = false // edits that are undone together if one of them is refused

  constructor(make: Maker, options: WorldOptions) {
    const { preserve, precision = 'double' } = known('options', ['preserve', 'precision'], options)
    if (preserve !== undefined && typeof preserve !== 'function') throw bad('preserve', 'a function', preserve)
    if (precision !== 'double' && precision !== 'float') throw bad('precision', "'double' or 'float'", precision)
    this.#options = preserve ? { preserve, precision } : { precision }
    this.#engine = engine()
    this.#changes = new Lists(this.#engine, precision)
    this.#segments = new Lists(this.#engine, precision)
    this.#relation = preserve ? this.#engine.keepRelation(preserve) : 0
    try {
      this.#world = this.#orFail(make(this.#engine, this.#relation, precision === 'float' ? 1 : 0), 0)
    } catch (error) {
      this.#engine.dropRelation(this.#relation)
      throw error
    }
  }

  /** Its address. Ask for it last: until then getters of arguments may free the world. */
  get #live(): number {
    if (this.#world === 0) throw new LgsError('freed', 'this world was freed')
    return this.#world
  }
  get #call() { return this.#engine.call }
  #orFail<T>(answer: T, refused: T): T {
    if (answer === refused) throw this.#engine.failure()
    return answer
  }

  /** For modules of this package: the engine and the address of a world. A world that is freed has none. */
  static placeOf(world: World): { engine: Engine; address: number } {
    if (typeof world !== 'object' || world === null || !(#world in world)) throw bad('world', 'a world of createWorld()', world)
    return { engine: (world as EngineWorld).#engine, address: (world as EngineWorld).#live }
  }

  /** Edits as one: if they throw, nothing has changed. No edits may wait for their commit. */
  static group<T>(world: World, edits: (world: World) => T): T {
    const own = world as EngineWorld
    let keeps = 0
    own.#call.beginGroup(own.#live)
    own.#isInGroup = true
    try {
      const result = edits(world)
      keeps = 1
      return result
    } finally {
      own.#isInGroup = false
      own.#call.endGroup(own.#live, keeps)
    }
  }
  #refuseInGroup(): void {
    if (this.#isInGroup) throw new LgsError('busy', 'what is one stroke must only edit the world, and its chunks that are in memory')
  }

  /** The id of its so and so manyth shape. */
  static shapeOf(world: World, nth: number): ShapeId {
    const own = world as EngineWorld
    return own.#call.shapeNumber(own.#live, nth) >>> 0
  }

  /** What it was made with, for another one like it. */
  static optionsOf(world: World): WorldOptions { return (world as EngineWorld).#options }

  // --- Edits

  shape(vertices: Vertices): ShapeId {
    const count = this.#engine.put(flat('vertices', vertices))
    return this.#orFail(this.#call.shape(this.#live, count / 2) >>> 0, 0)
  }
  add(i: number, j: number, shape: ShapeId, block: Block): PolygonId {
    return this.#orFail(
      this.#call.add(this.#live, int32('i', i), int32('j', j), uint32('shape', shape), uint32('block', block)), 0)
  }
  addMany(entries: Int32Array): Float64Array {
    if (!(entries instanceof Int32Array)) throw bad('entries', 'an Int32Array', entries)
    const numbers = new Int32Array(entries), count = numbers.length / 4
    if (!Number.isInteger(count)) throw bad('the length of entries', 'a multiple of four', numbers.length)
    this.#engine.putBytes(new Uint8Array(numbers.buffer))
    this.#orFail(this.#call.addMany(this.#live, count), 0)
    return this.#engine.answer(count).slice()
  }
  addPolygon(i: number, j: number, vertices: Vertices, block: Block): PolygonId {
    int32('i', i)
    int32('j', j)
    uint32('block', block)
    const count = this.#engine.put(flat('vertices', vertices))
    return this.#orFail(this.#call.addPolygon(this.#live, i, j, count / 2, block), 0)
  }
  remove(polygon: PolygonId): void {
    this.#orFail(this.#call.remove(this.#live, real('polygon', polygon)), 0)
  }
  removeMany(polygons: ArrayLike<PolygonId>): void {
    const count = this.#engine.put(reals('polygons', polygons))
    this.#orFail(this.#call.removeMany(this.#live, count), 0)
  }
  replace(i: number, j: number, shape: ShapeId, block: Block): PolygonId {
    return this.#orFail(
      this.#call.replace(this.#live, int32('i', i), int32('j', j), uint32('shape', shape), uint32('block', block)), 0)
  }
  setBlock(polygon: PolygonId, block: Block): void {
    this.#orFail(this.#call.setBlock(this.#live, real('polygon', polygon), uint32('block', block)), 0)
  }
  fill(cells: CellRect, shape: ShapeId, block: Block): number {
    const { i0, j0, i1, j1 } = rect(cells)
    return this.#orFail(
      this.#call.fill(this.#live, i0, j0, i1, j1, uint32('shape', shape), uint32('block', block)), -1)
  }
  clear(cells: CellRect | number, j?: number): number {
    const { i0, j0, i1, j1 } = rect(typeof cells === 'number' ? { i0: cells, j0: j!, i1: cells, j1: j! } : cells)
    return this.#orFail(this.#call.clear(this.#live, i0, j0, i1, j1), -1)
  }
  paint(region: Region, block: Block, mode: 'fill' | 'replace' = 'fill'): BrushResult {
    uint32('block', block)
    if (mode !== 'fill' && mode !== 'replace') throw bad('mode', "'fill' or 'replace'", mode)
    const count = putRegion(this.#engine, region)
    return this.#brushed(this.#call.paint(this.#live, count, block, mode === 'replace' ? 1 : 0))
  }
  carve(region: Region): BrushResult {
    const count = putRegion(this.#engine, region)
    return this.#brushed(this.#call.carve(this.#live, count))
  }
  #brushed(isDone: number): BrushResult {
    this.#orFail(isDone, 0)
    const brush = ++this.#brush
    return new Brushed((list) => {
      const world = this.#live
      if (brush !== this.#brush) throw new LgsError('stale-list', 'this list is of an earlier brush of its world')
      return this.#engine.answer(list === 'changed' ? this.#call.brushChanges(world) : this.#call.brushed(world, brushLists.indexOf(list)))
    })
  }

  // --- Commits, roll-back, redo

  commit(): Changes {
    this.#refuseInGroup()
    return changesOf(this.#changes, this.#made(this.#changes, (world) => this.#call.commit(world)))
  }
  mark(): Mark {
    this.#refuseInGroup()
    return this.#call.mark(this.#live)
  }
  rollBack(mark: Mark, undone: 'drop' | 'keep' = 'drop'): Changes {
    if (undone !== 'drop' && undone !== 'keep') throw bad('undone', "'drop' or 'keep'", undone)
    return this.#roll(mark, undone === 'keep' ? 1 : 0)
  }
  redo(mark: Mark): Changes { return this.#roll(mark, 2) }
  #roll(mark: Mark, way: number): Changes {
    this.#refuseInGroup()
    whole('mark', mark)
    return changesOf(this.#changes, this.#made(this.#changes, (world) => this.#call.roll(world, mark, way)))
  }
  forget(mark: Mark): void {
    this.#refuseInGroup()
    this.#orFail(this.#call.forget(this.#live, whole('mark', mark)), 0)
  }

  /** Where the lists are that a call makes. If preserve() throws the call has made them none the less. */
  #made(lists: Lists, call: (world: number) => number): number {
    const world = this.#live
    try {
      return this.#orFail(call(world) >>> 0, 0)
    } catch (error) {
      if ((error as LgsError).code === 'preserve-failed') lists.end()
      throw error
    }
  }

  // --- Chunks that leave memory and come back

  unload(cells: CellRect): UnloadedChunk[] {
    this.#refuseInGroup()
    const { i0, j0, i1, j1 } = rect(cells)
    const count = this.#orFail(this.#call.unload(this.#live, i0, j0, i1, j1), -1)
    const bytes = this.#engine.answerBytes(count), chunks: UnloadedChunk[] = []
    for (let k = 0, begin = 0; begin < count; k += 3) {
      const [i, j, length] = this.#engine.answer(k + 3).subarray(k) as unknown as [number, number, number]
      chunks.push({ i, j, bytes: bytes.slice(begin, (begin += length)) })
    }
    return chunks
  }
  reload(chunk: Uint8Array): { i: number; j: number } {
    this.#refuseInGroup()
    if (!(chunk instanceof Uint8Array)) throw bad('chunk', 'a Uint8Array', chunk)
    const own = new Uint8Array(chunk)
    this.#engine.putBytes(own)
    this.#orFail(this.#call.reload(this.#live, own.length), 0)
    return this.#place()
  }
  reloadEmpty(cells: CellRect): number {
    this.#refuseInGroup()
    const { i0, j0, i1, j1 } = rect(cells)
    return this.#orFail(this.#call.reloadEmpty(this.#live, i0, j0, i1, j1), -1)
  }
  firstUnloaded(cells: CellRect): { i: number; j: number } | null {
    const { i0, j0, i1, j1 } = rect(cells)
    return this.#call.firstUnloaded(this.#live, i0, j0, i1, j1) ? this.#place() : null
  }
  #place() {
    const [i, j] = this.#engine.answer(2) as unknown as [number, number]
    return { i, j }
  }

  // --- Reading

  segments(cells?: CellRect): SegmentList {
    if (!cells) return listOf(this.#segments, this.#made(this.#segments, (world) => this.#call.segments(world)))
    const { i0, j0, i1, j1 } = rect(cells)
    return listOf(this.#segments, this.#made(this.#segments, (world) => this.#call.segmentsIn(world, i0, j0, i1, j1)))
  }
  segment(id: SegmentId): Segment {
    this.#orFail(this.#call.segment(this.#live, uint32('id', id)), 0)
    const n = this.#engine.answer(14)
    const ghost = (neighbour: number, k: number): [number, number] | null => (neighbour === 0 ? null : [n[k]!, n[k + 1]!])
    const [predecessor, successor] = [n[8]!, n[9]!]
    return {
      id, start: [n[0]!, n[1]!], end: [n[2]!, n[3]!], ghost1: ghost(predecessor, 4), ghost2: ghost(successor, 6),
      predecessor, successor, block: n[10]!, polygon: n[11]!, i: n[12]!, j: n[13]!,
    }
  }
  hit(id: SegmentId): Hit {
    const { polygon, block, i, j } = this.segment(id)
    return { polygon, block, i, j }
  }
  loops(options: { merge?: boolean } = {}): Loop[] {
    const { merge } = known('options', ['merge'], options)
    const count = this.#call.loops(this.#live, merge ? 1 : 0)
    const numbers = this.#engine.answer(count)
    const loops: Loop[] = []
    for (let k = 0; k < count; ) {
      const vertices = k + 2, segments = vertices + 2 * numbers[k]!, end = segments + numbers[k + 1]!
      loops.push({ vertices: numbers.slice(vertices, segments), segments: Uint32Array.from(numbers.subarray(segments, end)) })
      k = end
    }
    return loops
  }
  polygonsAt(i: number, j: number): Polygon[] { return this.polygons({ i0: i, j0: j, i1: i, j1: j }) }
  polygons(cells?: CellRect): Polygon[] {
    if (!cells) return this.#polygons(this.#call.polygons(this.#live))
    const { i0, j0, i1, j1 } = rect(cells)
    return this.#polygons(this.#call.polygonsIn(this.#live, i0, j0, i1, j1))
  }
  polygon(id: PolygonId): Polygon {
    return this.#polygons(this.#orFail(this.#call.polygon(this.#live, real('polygon', id)), 0))[0]!
  }
  #polygons(count: number): Polygon[] {
    const n = this.#engine.answer(count)
    const polygons: Polygon[] = []
    for (let k = 0; k < count; ) {
      const end = k + 5 + 2 * n[k + 4]!
      polygons.push({ id: n[k]!, i: n[k + 1]!, j: n[k + 2]!, block: n[k + 3]!, vertices: n.slice(k + 5, end) })
      k = end
    }
    return polygons
  }
  at(x: number, y: number): Spot {
    this.#orFail(this.#call.at(this.#live, real('x', x), real('y', y)), 0)
    const n = this.#engine.answer(5)
    return { where: (['outside', 'edge', 'inside', 'unloaded'] as const)[n[0]!]!, polygon: n[1]!, block: n[2]!, i: n[3]!, j: n[4]! }
  }
  nearest(x: number, y: number, radius: number): Nearest | null {
    this.#orFail(this.#call.nearest(this.#live, real('x', x), real('y', y), real('radius', radius)), 0)
    const n = this.#engine.answer(4)
    return n[0] === 0 ? null : { segment: n[0]!, x: n[1]!, y: n[2]!, distance: n[3]! }
  }
  rayCast(x0: number, y0: number, x1: number, y1: number): RayHit | null {
    this.#orFail(
      this.#call.rayCast(this.#live, real('x0', x0), real('y0', y0), real('x1', x1), real('y1', y1)), 0)
    const n = this.#engine.answer(6)
    return n[0] === 0 ? null : { segment: n[0]!, fraction: n[1]!, x: n[2]!, y: n[3]!, nx: n[4]!, ny: n[5]! }
  }

  // --- The whole

  save(): Uint8Array {
    return this.#engine.answerBytes(this.#orFail(this.#call.save(this.#live), -1))
  }
  saveText(): string { return textOf(this.save()) }
  stats(): Stats {
    this.#call.stats(this.#live)
    const [polygons, cells, segments, shapes, contents, chunks, bytes] = this.#engine.answer(7) as unknown as number[]
    return { polygons, cells, segments, shapes, contents, chunks, bytes } as Stats
  }
  bounds(): CellRect | null {
    if (!this.#call.bounds(this.#live)) return null
    const [i0, j0, i1, j1] = this.#engine.answer(4) as unknown as number[]
    return { i0, j0, i1, j1 } as CellRect
  }
  get version(): Version { return this.#call.version(this.#live) }
  get maxSegmentId(): SegmentId { return this.#call.maxSegmentId(this.#live) >>> 0 }

  free(): void {
    if (this.#world === 0) return
    this.#refuseInGroup()
    if (!this.#engine.ended) this.#call.free(this.#world)  // refused within preserve(): then the world lives on
    this.#world = 0
    this.#changes.end()
    this.#segments.end()
    this.#engine.dropRelation(this.#relation)
  }
  [Symbol.dispose](): void { this.free() }
  [inspect](): unknown { return shown('World', this.#world === 0 || this.#engine.ended ? { freed: true } : this.stats()) }
}

export const { group, placeOf, optionsOf, shapeOf } = EngineWorld

/** For modules of this package: a world that the engine makes in another way. */
export const worldOf = (make: Maker, options: WorldOptions): World => new EngineWorld(make, options)

/** An empty world. */
export function createWorld(options: WorldOptions = {}): World {
  return new EngineWorld((e, relation, isFloat) => e.call.make(relation, isFloat), options)
}

/**
 * The world that save() or saveText() wrote, here or in C++. It goes on exactly: the same edits give the same ids. It has
 * no marks, and what follows a world (a terrain, an OutlineLines) is to be made again for it.
 */
export function loadWorld(saved: Uint8Array | string, options: WorldOptions = {}): World {
  if (!(saved instanceof Uint8Array) && typeof saved !== 'string') throw bad('saved', 'a Uint8Array or a string', saved)
  const own = typeof saved === 'string' ? bytesOf(saved) : new Uint8Array(saved)
  return new EngineWorld((e, relation, isFloat) => {
    e.putBytes(own)
    return e.call.load(own.length, relation, isFloat)
  }, options)
}
