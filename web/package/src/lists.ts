// Lists of segments: views on arrays in the memory of WebAssembly, and copies of them.
import type { Engine } from './engine.js'
import { LgsError } from './error.js'
import type { Changes, SegmentList } from './types.js'

/** Where things are in lgs::web::Lists::Header, in words of 32 bits. */
const at = {
  removed: 4, added: 5, relinked: 6, ids: 7, geometry: 8, block: 9, cell: 10, owner: 11,
  predecessor: 12, successor: 13,
}

type Numbers = Uint32Array | Int32Array | Float32Array | Float64Array
type Maker<T extends Numbers> = new (buffer: ArrayBuffer, address: number, length: number) => T

interface Kept {
  readonly address: number
  readonly view: Numbers
}
/** How many of one kind. */
const keptViews = 32

/** Lists of a world: those of its last commit or roll-back, or of its last question for segments. */
export class Lists {
  readonly engine: Engine
  readonly precision: 'double' | 'float'
  #number = 0  // of the last call that made lists: earlier ones are stale
  #header = 0  // where it is, in words
  // To make a view takes as long as a small commit. But most views are where an earlier one was: so that one is used
  // again. Those of one kind are at places by their beginning and length.
  #views: Kept[][] = []
  #memory: Uint32Array | null = null  // in which they are

  constructor(engine: Engine, precision: 'double' | 'float') {
    this.engine = engine
    this.precision = precision
  }

  /** All lists so far are stale; the next ones are what the header at this address says. Returns their number. */
  next(header = 0): number {
    this.#header = header / 4
    return ++this.#number
  }

  /** A word of the header. */
  word(number: number, place: number): number {
    if (number !== this.#number)
      throw new LgsError('stale-list', 'this list is of an earlier call of its world; copy() keeps one')
    return this.engine.words[this.#header + place]!
  }

  /** What the header begins with: World.version before and after. */
  get versions(): BigUint64Array { return new BigUint64Array(this.engine.buffer, 4 * this.#header, 2) }

  view<T extends Numbers>(number: number, make: Maker<T>, bytes: number, place: number, first: number, length: number): T {
    const address = this.word(number, place) + bytes * first
    if (this.#memory !== this.engine.words) {
      this.#memory = this.engine.words
      this.#views = []
    }
    const views = (this.#views[place] ??= [])
    const kept = (first + length) % keptViews
    const old = views[kept]
    if (old?.address === address && old.view.length === length) return old.view as T
    const view = new make(this.engine.buffer, address, length)
    views[kept] = { address, view }
    return view
  }
}

class View implements SegmentList {
  #lists: Lists
  #number: number
  #first: number  // among all segments that are alive
  readonly length: number

  constructor(lists: Lists, number: number, first: number, length: number) {
    this.#lists = lists
    this.#number = number
    this.#first = first
    this.length = length
  }

  #words(place: number, first = this.#first) { return this.#lists.view(this.#number, Uint32Array, 4, place, first, this.length) }
  get id() { return this.#words(at.ids, this.#first + this.#lists.word(this.#number, at.removed)) }
  get geometry() {
    return this.#lists.precision === 'float'
      ? this.#lists.view(this.#number, Float32Array, 4, at.geometry, 8 * this.#first, 8 * this.length)
      : this.#lists.view(this.#number, Float64Array, 8, at.geometry, 8 * this.#first, 8 * this.length)
  }
  get block() { return this.#words(at.block) }
  get cell() { return this.#lists.view(this.#number, Int32Array, 4, at.cell, 2 * this.#first, 2 * this.length) }
  get owner() { return this.#lists.view(this.#number, Float64Array, 8, at.owner, this.#first, this.length) }
  get predecessor() { return this.#words(at.predecessor) }
  get successor() { return this.#words(at.successor) }

  copy(): SegmentList {
    const list: SegmentList = {
      length: this.length, id: this.id.slice(), geometry: this.geometry.slice(), block: this.block.slice(),
      cell: this.cell.slice(), owner: this.owner.slice(), predecessor: this.predecessor.slice(),
      successor: this.successor.slice(), copy: () => list,
    }
    return list
  }
}

class ChangesView implements Changes {
  #lists: Lists
  #number: number
  readonly added: SegmentList
  readonly relinked: SegmentList
  readonly before: bigint
  readonly after: bigint

  constructor(lists: Lists, number: number) {
    const added = lists.word(number, at.added)
    this.#lists = lists
    this.#number = number
    this.added = new View(lists, number, 0, added)
    this.relinked = new View(lists, number, added, lists.word(number, at.relinked));
    [this.before, this.after] = lists.versions as unknown as [bigint, bigint]
  }
  get removed() {
    return this.#lists.view(this.#number, Uint32Array, 4, at.ids, 0, this.#lists.word(this.#number, at.removed))
  }
  copy(): Changes {
    const changes: Changes = {
      removed: this.removed.slice(), added: this.added.copy(), relinked: this.relinked.copy(), before: this.before,
      after: this.after, copy: () => changes,
    }
    return changes
  }
}

/** What the engine has written, and says at this address. Earlier lists of this kind are stale. */
export const changesOf = (lists: Lists, header: number): Changes => new ChangesView(lists, lists.next(header))
export function listOf(lists: Lists, header: number): SegmentList {
  const number = lists.next(header)
  return new View(lists, number, 0, lists.word(number, at.added))
}
