// Lists of segments. The engine writes those of a commit into one block of its memory; here the block is copied, and
// looked at where they are read. So what is handed out stays what it is when the memory of WebAssembly grows, and
// to post one does not post all memory.
import type { Engine } from './engine.js'
import { LgsError } from './error.js'
import { inspect, shown } from './inspect.js'
import type { Changes, ChangesCopy, Segment, SegmentList } from './types.js'

/** Bytes of a segment's eight numbers: as float, or as double. */
type GeometryBytes = 32 | 64
/** Bytes of lgs::web::SegmentHead. */
const headBytes = 32

/** Where the arrays of a block are: lgs::web::putArrays() says in which order. Places are bytes from its beginning. */
class Layout {
  readonly removed: number
  readonly alive: number
  readonly geometry: number
  readonly cell: number
  readonly id: number
  readonly block: number
  readonly predecessor: number
  readonly successor: number
  readonly bytes: number

  constructor(removed: number, readonly added: number, relinked: number, readonly geometryBytes: GeometryBytes) {
    const alive = added + relinked
    this.removed = removed
    this.alive = alive
    this.geometry = headBytes + 8 * alive
    this.cell = this.geometry + geometryBytes * alive
    this.id = this.cell + 8 * alive
    this.block = this.id + 4 * (removed + alive)
    this.predecessor = this.block + 4 * alive
    this.successor = this.predecessor + 4 * alive
    this.bytes = this.successor + 4 * alive
  }
}

/** The arrays of the segments from `first` to `first + length` of a block. Each is made when it is first read. */
class Arrays {
  readonly length: number
  readonly #page: ArrayBuffer
  readonly #layout: Layout
  readonly #first: number
  #id?: Uint32Array
  #geometry?: Float64Array | Float32Array
  #block?: Uint32Array
  #cell?: Int32Array
  #owner?: Float64Array
  #predecessor?: Uint32Array
  #successor?: Uint32Array

  constructor(page: ArrayBuffer, layout: Layout, first: number, length: number) {
    this.length = length
    this.#page = page
    this.#layout = layout
    this.#first = first
  }
  get id() { return (this.#id ??= this.#words(this.#layout.id + 4 * this.#layout.removed)) }
  get geometry() {
    const { geometry, geometryBytes } = this.#layout, from = geometry + geometryBytes * this.#first
    return (this.#geometry ??= geometryBytes === 32 ? new Float32Array(this.#page, from, 8 * this.length)
      : new Float64Array(this.#page, from, 8 * this.length))
  }
  get block() { return (this.#block ??= this.#words(this.#layout.block)) }
  get cell() { return (this.#cell ??= new Int32Array(this.#page, this.#layout.cell + 8 * this.#first, 2 * this.length)) }
  get owner() { return (this.#owner ??= new Float64Array(this.#page, headBytes + 8 * this.#first, this.length)) }
  get predecessor() { return (this.#predecessor ??= this.#words(this.#layout.predecessor)) }
  get successor() { return (this.#successor ??= this.#words(this.#layout.successor)) }

  #words(from: number) { return new Uint32Array(this.#page, from + 4 * this.#first, this.length) }
}

/** What one block holds, as arrays. */
class Block {
  readonly added: Arrays
  readonly relinked: Arrays
  readonly layout: Layout
  readonly #page: ArrayBuffer
  #removed?: Uint32Array

  constructor(page: ArrayBuffer, layout: Layout) {
    this.#page = page
    this.layout = layout
    this.added = new Arrays(page, layout, 0, layout.added)
    this.relinked = new Arrays(page, layout, layout.added, layout.alive - layout.added)
  }
  get removed() { return (this.#removed ??= new Uint32Array(this.#page, this.layout.id, this.layout.removed)) }
}

/** How many blocks with other lengths are remembered: most commits of a game are like an earlier one. */
const keptBlocks = 256
/** Bytes; a greater page is given back when it is far too great. */
const greatPage = 1 << 20

/** Of lists that never held anything, as most of a thousand worlds may be. Nothing writes there. */
const noPage = new ArrayBuffer(0), noWords = new Uint32Array(noPage), noVersions = new Float64Array(2)

/** Lists of a world: those of its last commit or roll-back, or of its last question for segments. */
export class Lists {
  readonly engine: Engine
  readonly #geometryBytes: GeometryBytes
  #number = 0  // of the last call that made lists: earlier ones are stale
  #page = noPage
  #words = noWords
  #versions = noVersions
  // To make a view takes as long as a small commit. So those of a block with the same lengths are used again.
  #blocks: (Block | undefined)[] = []

  constructor(engine: Engine, precision: 'double' | 'float') {
    this.engine = engine
    this.#geometryBytes = precision === 'float' ? 32 : 64
  }

  get number() { return this.#number }

  /** All lists so far are stale. */
  end(): void { ++this.#number }

  /** Copies the block at this address. All lists so far are stale. */
  next(address: number): Block {
    ++this.#number
    const from = address >>> 2, { words } = this.engine
    const removed = words[from + 4]!, added = words[from + 5]!, relinked = words[from + 6]!, length = words[from + 7]! * 2
    if (length > this.#words.length || (this.#page.byteLength > greatPage && 16 * length < this.#page.byteLength)) {
      this.#page = new ArrayBuffer(Math.max(1024, 5 * (length + length % 4)))
      this.#words = new Uint32Array(this.#page)
      this.#versions = new Float64Array(this.#page, 0, 2)
      this.#blocks = []
    }
    this.#words.set(words.subarray(from, from + length))
    const kept = (removed + 31 * added + 67 * relinked) % keptBlocks
    const old = this.#blocks[kept]
    if (old && old.layout.removed === removed && old.added.length === added && old.relinked.length === relinked) return old
    return (this.#blocks[kept] = new Block(this.#page, new Layout(removed, added, relinked, this.#geometryBytes)))
  }

  /** What the block begins with: World.version before and after. */
  get versions(): Float64Array { return this.#versions }

  copyOf(layout: Layout): Block { return new Block(this.#page.slice(0, layout.bytes), layout) }

  check(number: number): void {
    if (number !== this.#number)
      throw new LgsError('stale-list', 'this list is of an earlier call of its world; copy() keeps one')
  }
}

/** postMessage() and structuredClone() read what is their argument's own. So they come upon this one, which throws. */
const onlyCopiesCanBePosted = Object.defineProperty({}, 'postACopy', {
  enumerable: true,
  get() { throw new LgsError('not-a-copy', 'the next commit overwrites these lists, so they can not be posted: post their copy()') },
})

function* segmentsOf(list: SegmentList): Generator<Segment> {
  const { length, id, geometry: g, block, cell, owner, predecessor, successor } = list
  for (let k = 0, at = 0; k < length; ++k, at += 8)
    yield {
      id: id[k]!, start: [g[at]!, g[at + 1]!], end: [g[at + 2]!, g[at + 3]!],
      ghost1: predecessor[k] === 0 ? null : [g[at + 4]!, g[at + 5]!],
      ghost2: successor[k] === 0 ? null : [g[at + 6]!, g[at + 7]!],
      predecessor: predecessor[k]!, successor: successor[k]!, block: block[k]!, polygon: owner[k]!, i: cell[2 * k]!,
      j: cell[2 * k + 1]!,
    }
}

class View implements SegmentList {
  readonly post = onlyCopiesCanBePosted
  readonly #lists: Lists
  readonly #number: number
  readonly #arrays: Arrays

  constructor(lists: Lists, number: number, arrays: Arrays) {
    this.#lists = lists
    this.#number = number
    this.#arrays = arrays
  }
  get #now() {
    this.#lists.check(this.#number)
    return this.#arrays
  }
  get length() { return this.#now.length }
  get id() { return this.#now.id }
  get geometry() { return this.#now.geometry }
  get block() { return this.#now.block }
  get cell() { return this.#now.cell }
  get owner() { return this.#now.owner }
  get predecessor() { return this.#now.predecessor }
  get successor() { return this.#now.successor }
  [Symbol.iterator]() { return segmentsOf(this) }
  [inspect](): unknown { return shown('SegmentList', this.#lists.number === this.#number ? new ListCopy(this) : { stale: true }) }
  copy(): SegmentList { return new ListCopy(this, true) }
}

/** Everything of it can be posted, and is its own. */
class ListCopy implements SegmentList {
  readonly length: number
  readonly id: Uint32Array
  readonly geometry: Float64Array | Float32Array
  readonly block: Uint32Array
  readonly cell: Int32Array
  readonly owner: Float64Array
  readonly predecessor: Uint32Array
  readonly successor: Uint32Array

  constructor(list: Omit<SegmentList, 'copy' | typeof Symbol.iterator>, sliced = false) {
    const own = <T extends Uint32Array | Int32Array | Float32Array | Float64Array>(array: T) => (sliced ? array.slice() as T : array)
    this.length = list.length
    this.id = own(list.id)
    this.geometry = own(list.geometry)
    this.block = own(list.block)
    this.cell = own(list.cell)
    this.owner = own(list.owner)
    this.predecessor = own(list.predecessor)
    this.successor = own(list.successor)
  }
  [Symbol.iterator]() { return segmentsOf(this) }
  copy(): SegmentList { return this }
}

class ChangesView implements Changes {
  readonly post = onlyCopiesCanBePosted
  readonly before: number
  readonly after: number
  readonly #lists: Lists
  readonly #number: number
  readonly #block: Block
  #added?: View
  #relinked?: View

  constructor(lists: Lists, block: Block) {
    const { versions } = lists
    this.before = versions[0]!
    this.after = versions[1]!
    this.#lists = lists
    this.#number = lists.number
    this.#block = block
  }
  get added() { return (this.#added ??= this.#view(this.#block.added)) }
  get relinked() { return (this.#relinked ??= this.#view(this.#block.relinked)) }
  get removed() {
    this.#lists.check(this.#number)
    return this.#block.removed
  }
  #view(arrays: Arrays): View {
    return new View(this.#lists, this.#number, arrays)
  }
  [inspect](): unknown {
    const { before, after } = this
    if (this.#lists.number !== this.#number) return shown('Changes', { stale: true, before, after })
    return shown('Changes', { removed: this.removed, added: this.added, relinked: this.relinked, before, after })
  }
  copy(): ChangesCopy {
    this.#lists.check(this.#number)
    return new Copy(this.#lists.copyOf(this.#block.layout), this.before, this.after)
  }
}

class Copy implements ChangesCopy {
  readonly removed: Uint32Array
  readonly added: SegmentList
  readonly relinked: SegmentList
  readonly before: number
  readonly after: number

  constructor({ removed, added, relinked }: Block, before: number, after: number) {
    this.removed = removed
    this.added = new ListCopy(added)
    this.relinked = new ListCopy(relinked)
    this.before = before
    this.after = after
  }
  copy(): ChangesCopy { return this }
  buffers(): ArrayBuffer[] { return [this.removed.buffer as ArrayBuffer] }
}

/** What the engine has written at this address. Earlier lists of this kind are stale. */
export const changesOf = (lists: Lists, address: number): Changes => new ChangesView(lists, lists.next(address))
export const listOf = (lists: Lists, address: number): SegmentList => {
  const { added } = lists.next(address)
  return new View(lists, lists.number, added)
}
