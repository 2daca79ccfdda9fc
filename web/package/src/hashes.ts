// Hashes of the ground: whether two worlds hold the same, and where they differ. web/wasm/hashes.cpp is the other side.
import { bad, int32, rect, within } from './check.js'
import { type Engine, type Exports } from './engine.js'
import { LgsError } from './error.js'
import type { CellRect, HashedSquare, World } from './types.js'
import { placeOf } from './world.js'

const misfits = {
  'left-out': 'commits before this one were left out: make new GroundHashes',
  uncommitted: 'edits wait for their commit: update the hashes after each commit, before the next edit',
} as const

/**
 * The hashes of a world: of its polygons and blocks alone, the same wherever and however it was made. Make it while no
 * edit waits for its commit and while there is no mark, and update it after each commit and roll-back.
 */
export class GroundHashes {
  readonly #world: World
  readonly #from: Engine
  #hashes: number // their address; 0 when they are gone

  /** Reads all polygons once. */
  constructor(world: World) {
    const { engine, address } = placeOf(world)
    this.#world = world
    this.#from = engine
    this.#hashes = engine.call.hashes(address) >>> 0
    if (this.#hashes === 0) throw engine.failure()
  }

  /** Ask for it last: until then getters of arguments may free it. */
  get #at(): { call: Exports; hashes: number } {
    if (this.#hashes === 0) throw new LgsError('freed', 'these hashes were freed')
    return { call: this.#from.call, hashes: this.#hashes }
  }

  /**
   * Takes over what the last commit or roll-back did, before the next edit. Throws, and has changed nothing:
   * 'uncommitted', or 'left-out', after which new GroundHashes are needed.
   */
  update(): void {
    const { address } = placeOf(this.#world)
    const { call, hashes } = this.#at
    const misfit = ([null, 'left-out', 'uncommitted'] as const)[call.updateHashes(hashes, address)]!
    if (misfit !== null) throw new LgsError(misfit, misfits[misfit])
  }

  /** That of the world: 64 bits. 0n where there is nothing. */
  get hash(): bigint { return this.whole().hash }

  /** The least square that all ground lies in: its hash is that of the world. */
  whole(): HashedSquare {
    const { call, hashes } = this.#at
    call.wholeHash(hashes)
    return this.#squares(7)[0]!
  }

  /** The squares of a level that have a cell of a rectangle, and that hold something. Level 0: chunks of 32×32 cells. */
  in(cells: CellRect, level = 0): HashedSquare[] {
    const { i0, j0, i1, j1 } = rect(cells)
    within('level', int32('level', level), 0, 14)
    const { call, hashes } = this.#at
    return this.#squares(call.hashesIn(hashes, i0, j0, i1, j1, level))
  }

  /** The chunks whose ground differs from that of another world. */
  differences(other: GroundHashes): CellRect[] {
    if (typeof other !== 'object' || other === null || !(#hashes in other)) throw bad('other', 'GroundHashes', other)
    if (other.#from !== this.#from) throw bad('other', 'GroundHashes of the same engine', other)
    const theirs = other.#at.hashes
    const { call, hashes } = this.#at
    const numbers = this.#from.answer(call.hashDifferences(hashes, theirs))
    return Array.from({ length: numbers.length / 4 }, (_, k) => rectAt(numbers, 4 * k))
  }

  #squares(count: number): HashedSquare[] {
    const numbers = this.#from.answer(count)
    return Array.from({ length: count / 7 }, (_, k) => ({
      level: numbers[7 * k]!,
      cells: rectAt(numbers, 7 * k + 1),
      hash: (BigInt(numbers[7 * k + 5]!) << 32n) | BigInt(numbers[7 * k + 6]!),
    }))
  }

  /** Gives its memory back. A second call does nothing. The world's free() does not do it. */
  free(): void {
    if (this.#hashes === 0) return
    if (!this.#from.ended) this.#from.call.freeHashes(this.#hashes)
    this.#hashes = 0
  }
  [Symbol.dispose](): void { this.free() }
}

function rectAt(numbers: ArrayLike<number>, k: number): CellRect {
  return { i0: numbers[k]!, j0: numbers[k + 1]!, i1: numbers[k + 2]!, j1: numbers[k + 3]! }
}
