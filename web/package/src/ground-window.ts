// Which part of a Ground is in memory, and the land that is made there.
import { bad, within } from './check.js'
import { LgsError } from './error.js'
import { type Asking, SafeShelf } from './ground-asking.js'
import { chunksAround, chunksIn, type Corner, everywhere, isSame, keyOf } from './ground-parts.js'
import type { GroundOptions } from './ground-types.js'
import type { CellRect, World, WorldOptions } from './types.js'
import { createWorld } from './world.js'

const mostLand = 65_536
const farthest = everywhere.i1

export class GroundWindow {
  cells = everywhere
  /** Whether nothing is to come or go. */
  isWhole = false
  readonly shelf: SafeShelf
  readonly #asking: Asking
  readonly #land: GroundOptions['land']
  readonly #ofWorld: WorldOptions
  readonly #atOnce: number
  #leaving = everywhere                 // what is in memory and not in the window is in it
  #made = new Map<string, Corner>()     // chunks whose land was made
  #new: { readonly chunk: CellRect; readonly at: number }[] = [] // of these, which an undo may take away, and after which mark

  constructor({ land, shelf, chunksAtOnce = Infinity }: GroundOptions, ofWorld: WorldOptions, asking: Asking) {
    if (land !== undefined && typeof land !== 'function') throw bad('land', 'a function', land)
    this.#asking = asking
    this.shelf = new SafeShelf(asking, shelf)
    this.#land = land
    this.#ofWorld = ofWorld
    this.#atOnce = chunksAtOnce === Infinity ? Infinity : within('chunksAtOnce', chunksAtOnce, 1, 1e9)
  }

  /** Whether it has these chunks from now on, and some of them are to come or to go. */
  moveTo(cells: CellRect): boolean {
    const chunks = chunksAround(cells), isMoved = !isSame(chunks, this.cells)
    if (!isMoved) return !this.isWhole
    const count = ((chunks.i1 - chunks.i0) / 32 + 3) * ((chunks.j1 - chunks.j0) / 32 + 3)
    if (this.#land && count > mostLand) throw bad('the window', `at most ${mostLand} chunks, of which land is made,`, cells)
    const { i0, j0, i1, j1 } = this.#leaving, was = this.cells
    this.#leaving = { i0: Math.min(i0, was.i0), j0: Math.min(j0, was.j0), i1: Math.max(i1, was.i1), j1: Math.max(j1, was.j1) }
    this.cells = chunks
    return true
  }

  /** Brings in and takes out what may be at once. `now` is the mark after which new land is made. */
  stream(world: World, now: number, beforeLand: () => void): void {
    const most = { left: this.#atOnce }
    // Land first, as a chunk that comes in needs to know what is beside it.
    this.shelf.putKept()
    this.isWhole = this.#makeLand(world, now, beforeLand, most) && this.#unload(world, most) && this.#reload(world, most)
      && this.shelf.hasAll
  }

  // --- Land

  /** Whether all of it is made. Until it is, none of it is in memory: what is beside land that is not made would fall. */
  #makeLand(world: World, now: number, beforeLand: () => void, most: { left: number }): boolean {
    if (!this.#land) return true
    for (const chunk of chunksIn(chunksAround(this.cells, 1))) {
      if (this.#made.has(keyOf(chunk.i0, chunk.j0))) continue
      if (most.left-- < 1) return false
      if (!this.#make(world, chunk, now, beforeLand)) return false
      this.#putAway(world, chunk)
    }
    return true
  }

  /** False, and nothing has changed, where the game does not make it, or the shelf does not give what it is made around. */
  #make(world: World, chunk: CellRect, now: number, beforeLand: () => void): boolean {
    const land = createWorld(this.#ofWorld)
    try {
      const made = this.#asking.ask(() => {
        this.#land!(land, chunk)
        return land.unload(chunk)
      }, null)
      if (made === null || !this.#reload(world, { left: 1 }, chunk)) return false
      beforeLand()
      this.#made.set(keyOf(chunk.i0, chunk.j0), { i: chunk.i0, j: chunk.j0 })
      this.#new.push({ chunk, at: now })
      if (made.length > 0 && !isReloaded(world, made[0]!.bytes)) this.#makeAround(world, chunk, land, made[0]!.bytes)
      return true
    } finally {
      land.free()
    }
  }

  /** Where the game has built before, or an undo went over it: what is there stays. */
  #makeAround(world: World, chunk: CellRect, land: World, bytes: Uint8Array): void {
    land.reload(bytes)
    for (const { i, j, vertices, block } of land.polygons(chunk))
      try {
        world.addPolygon(i, j, vertices, block)
      } catch (error) {
        if (!(error instanceof LgsError)) throw error
      }
  }

  /** An undo took away land that was made since; at that time nothing was dug there. Whether there was some. */
  remakeLand(world: World, now: number, beforeLand: () => void): boolean {
    const again = this.#new.filter(({ at }) => at >= now)
    this.#new = this.#new.filter(({ at }) => at < now)
    for (const { chunk } of again)
      if (!this.#make(world, chunk, now, beforeLand)) {
        this.#made.delete(keyOf(chunk.i0, chunk.j0))  // the next window() makes it
        this.isWhole = false
      }
    if (again.length > 0) this.#putAwayOutside(world)
    return again.length > 0
  }

  /** Whether land was made after a mark. */
  hasNew(at: number): boolean { return this.#new.some((land) => land.at === at) }
  /** What was made after a mark is there at that mark. */
  keepNew(at: number): void { this.#new = this.#new.map((land) => (land.at === at ? { ...land, at: at - 1 } : land)) }
  /** Undo does not go back to what is before this mark. */
  forgetBefore(oldest: number): void { this.#new = this.#new.filter(({ at }) => at >= oldest) }

  get land(): Corner[] { return [...this.#made.values()] }
  /** After a load. */
  restart(land: readonly Corner[], away: readonly (Corner & { readonly bytes: Uint8Array })[]): void {
    this.shelf.dropKept()
    for (const { i, j, bytes } of away) this.shelf.put(i, j, bytes)
    this.#made = new Map(land.map((corner) => [keyOf(corner.i, corner.j), corner]))
    this.#new = []
    this.isWhole = false
  }

  // --- The shelf

  #putAway(world: World, cells: CellRect): number {
    const gone = world.unload(cells)
    for (const { i, j, bytes } of gone) this.shelf.put(i, j, bytes)
    return gone.length
  }
  #putAwayOutside(world: World): void {
    const { i0, j0, i1, j1 } = this.cells
    for (const away of [
      { ...everywhere, j1: j0 - 1 }, { ...everywhere, j0: j1 + 1 },
      { ...everywhere, j0, j1, i1: i0 - 1 }, { ...everywhere, j0, j1, i0: i1 + 1 }])
      if (away.i0 <= away.i1 && away.j0 <= away.j1) this.#putAway(world, away)
  }

  /** Whether no chunk is in memory out of the window. At first, when all may be, they leave at once. */
  #unload(world: World, most: { left: number }): boolean {
    const { i0, j0, i1, j1 } = this.#leaving, inside = this.cells
    if (this.#atOnce < Infinity && i1 - i0 < 2048 && j1 - j0 < 2048)
      for (const chunk of chunksIn(chunksAround(this.#leaving, 1))) {
        if (chunk.i0 >= inside.i0 && chunk.i1 <= inside.i1 && chunk.j0 >= inside.j0 && chunk.j1 <= inside.j1) continue
        if (most.left < 1) return false
        most.left -= this.#putAway(world, chunk)
      }
    this.#putAwayOutside(world)
    this.#leaving = inside
    return true
  }

  /** False where some are still away, as the shelf did not give one or there are more. */
  #reload(world: World, most: { left: number }, cells = this.cells): boolean {
    const down = (index: number) => Math.max(index & ~31, -farthest)
    // By rows: none is looked through again that all came back to.
    for (let cell = world.firstUnloaded(cells); cell; cell = world.firstUnloaded({ ...cells, j0: cell.j })) {
      if (most.left-- < 1) return false
      const bytes = this.shelf.get(down(cell.i), down(cell.j))
      if (!bytes || !isReloaded(world, bytes)) return false
    }
    return true
  }
}

function isReloaded(world: World, bytes: Uint8Array): boolean {
  try {
    world.reload(bytes)
    return true
  } catch (error) {
    if (error instanceof LgsError) return false
    throw error
  }
}
