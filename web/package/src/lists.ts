// Lists of segments: views on arrays in the memory of WebAssembly, and copies of them.
import type { Engine } from './engine.js'
import { LgsError } from './error.js'
import type { Changes, SegmentList } from './types.js'

/** What a list is a view of: lgs::web::Lists::Header of one call. It is stale once its world makes the next lists. */
export interface Source {
  readonly engine: Engine
  readonly precision: 'double' | 'float'
  readonly isStale: () => boolean
  readonly header: Uint32Array
}

/** Where things are in the header, in words of 32 bits. */
const at = {
  before: 0, after: 2, removed: 4, added: 5, relinked: 6, ids: 7, geometry: 8, block: 9, cell: 10, owner: 11,
  predecessor: 12, successor: 13,
}
export const headerWords = 14

class View implements SegmentList {
  #source: Source
  #first: number  // among all segments that are alive
  readonly length: number

  constructor(source: Source, first: number, length: number) {
    this.#source = source
    this.#first = first
    this.length = length
  }

  #words(place: number, perSegment: number, from = this.#first): [ArrayBuffer, number, number] {
    return [live(this.#source), this.#source.header[place]! + 4 * perSegment * from, perSegment * this.length]
  }
  get id() { return new Uint32Array(...this.#words(at.ids, 1, this.#first + this.#source.header[at.removed]!)) }
  get geometry() {
    if (this.#source.precision === 'float') return new Float32Array(...this.#words(at.geometry, 8))
    const [buffer, address] = this.#words(at.geometry, 16)
    return new Float64Array(buffer, address, 8 * this.length)
  }
  get block() { return new Uint32Array(...this.#words(at.block, 1)) }
  get cell() { return new Int32Array(...this.#words(at.cell, 2)) }
  get owner() {
    const [buffer, address] = this.#words(at.owner, 2)
    return new Float64Array(buffer, address, this.length)
  }
  get predecessor() { return new Uint32Array(...this.#words(at.predecessor, 1)) }
  get successor() { return new Uint32Array(...this.#words(at.successor, 1)) }

  copy(): SegmentList {
    const list: SegmentList = {
      length: this.length, id: this.id.slice(), geometry: this.geometry.slice(), block: this.block.slice(),
      cell: this.cell.slice(), owner: this.owner.slice(), predecessor: this.predecessor.slice(),
      successor: this.successor.slice(), copy: () => list,
    }
    return list
  }
}

function live(source: Source): ArrayBuffer {
  if (source.isStale())
    throw new LgsError('stale-list', 'this list is of an earlier call of its world; copy() keeps one')
  return source.engine.buffer
}

class ChangesView implements Changes {
  #source: Source
  readonly added: SegmentList
  readonly relinked: SegmentList
  readonly before: bigint
  readonly after: bigint

  constructor(source: Source) {
    const { header } = source
    const big = (place: number) => BigInt(header[place]!) | (BigInt(header[place + 1]!) << 32n)
    this.#source = source
    this.added = new View(source, 0, header[at.added]!)
    this.relinked = new View(source, header[at.added]!, header[at.relinked]!)
    this.before = big(at.before)
    this.after = big(at.after)
  }
  get removed() {
    const { header } = this.#source
    return new Uint32Array(live(this.#source), header[at.ids], header[at.removed])
  }
  copy(): Changes {
    const changes: Changes = {
      removed: this.removed.slice(), added: this.added.copy(), relinked: this.relinked.copy(), before: this.before,
      after: this.after, copy: () => changes,
    }
    return changes
  }
}

export const changesOf = (source: Source): Changes => new ChangesView(source)
export const listOf = (source: Source): SegmentList => new View(source, 0, source.header[at.added]!)
