// The same as `localgridseg`, and islands: pieces of ground that hang together. What is cut off falls.
//
//   import { init, createWorld, Islands } from 'localgridseg/islands'
//   await init()
//   const world = createWorld()
//   …                                                        // the ground
//   world.commit()
//   const islands = new Islands(world, { blocks: [bedrock] })
//   …
//   islands.update(world.commit())                           // after each commit and roll-back
//   for (const id of islands.loose()) fall(islands.take(id))
import { bad, int32, object, rect, reals, uint32 } from './check.js'
import { type Engine, start } from './engine.js'
import { LgsError } from './error.js'
import { bodyOf, placeIn, putPolygons } from './ground-body.js'
import { type IslandCalls, islandCalls } from './island-calls.js'
import { compile } from './load.js'
import type { Anchors, GroundBody, Island, IslandChanges, IslandId } from './island-types.js'
import type { Changes, InitOptions, PolygonId, World } from './types.js'
import { placeOf } from './world.js'

export * from './api.js'
export { convexParts, massOf } from './ground-body.js'
export type * from './island-types.js'

/** Loads the engine with islands, unless an engine runs already. */
export const init = (options: InitOptions = {}): Promise<void> =>
  start(() => compile(options, () => new URL('./lgs-islands.wasm', import.meta.url)))

function numbersOf({ blocks = [], cells = [] }: Anchors): number[] {
  if (!Array.isArray(cells)) throw bad('anchors.cells', 'an array of rectangles', cells)
  const ids = reals('anchors.blocks', blocks).map((block) => uint32('a block of anchors', block))
  return [ids.length, ...ids, ...Array.from(cells, rect).flatMap(({ i0, j0, i1, j1 }) => [i0, j0, i1, j1])]
}

const misfits = {
  'not-the-last': 'these changes are not those of the last commit or roll-back of this world',
  'left-out': 'changes before these were left out: make new Islands',
  uncommitted: 'edits wait for their commit: update the islands after each commit, before the next edit',
} as const

/**
 * The islands of a world: solids that share at least a point are one island. Make it while no edit waits for its commit
 * and while there is no mark, and give it each commit's and roll-back's changes.
 */
export class Islands {
  readonly #world: World
  readonly #from: Engine
  #islands: number // their address; 0 when they are gone

  /** Looks at everything once. Without anchors nothing holds, and all that an update names is loose. */
  constructor(world: World, anchors: Anchors = {}) {
    const numbers = numbersOf(object('anchors', '{ blocks, cells }', anchors))
    const { engine, address } = placeOf(world)
    this.#world = world
    this.#from = engine
    this.#islands = islandCalls(engine).islands(address, engine.put(numbers)) >>> 0
    if (this.#islands === 0) throw engine.failure()
  }

  /** Ask for it last: until then getters of arguments may free the world. */
  get #at(): { call: IslandCalls; islands: number; world: number } {
    const { engine, address } = placeOf(this.#world)
    if (this.#islands === 0) throw new LgsError('freed', 'these islands were freed')
    return { call: islandCalls(engine), islands: this.#islands, world: address }
  }

  /**
   * Takes over what a commit or a roll-back did, each once and before the next edit. Throws, and has changed nothing:
   * 'not-the-last', 'uncommitted', or 'left-out', after which new Islands are needed. After a roll-back to a mark that
   * was made while edits waited it is 'uncommitted': make new Islands after the next commit.
   */
  update(changes: Changes): void {
    if (object('changes', 'those of a commit', changes).after !== this.#world.version) throw new LgsError('not-the-last', misfits['not-the-last'])
    const { call, islands, world } = this.#at
    const misfit = ([null, 'left-out', 'uncommitted'] as const)[call.updateIslands(islands, world)]!
    if (misfit !== null) throw new LgsError(misfit, misfits[misfit])
  }

  /** Of the last update; all empty after the constructor. */
  get changes(): IslandChanges {
    const [came, went, changed, cutOff, joined] = [0, 1, 2, 3, 4].map((list) => {
      const { call, islands } = this.#at
      return this.#numbers(call.islandChanges(islands, list))
    }) as [number[], number[], number[], number[], number[]]
    const pairs = (ids: number[]) =>
      Array.from({ length: ids.length / 2 }, (_, k) => ({ from: ids[2 * k]!, into: ids[2 * k + 1]! }))
    return { came, went, changed, cutOff: pairs(cutOff), joined: pairs(joined) }
  }

  /** The islands of now that the last update names and that nothing holds. They may fall. */
  loose(): IslandId[] {
    const { call, islands } = this.#at
    return this.#numbers(call.looseIslands(islands))
  }

  all(): IslandId[] {
    const { call, islands } = this.#at
    return this.#numbers(call.allIslands(islands))
  }

  /** What is known of an island; null if the id names none. */
  island(id: IslandId): Island | null {
    uint32('id', id)
    const { call, islands } = this.#at
    if (!call.island(islands, id)) return null
    const [area, x0, y0, x1, y1, segments, anchors] = this.#from.answer(7) as unknown as number[]
    return { id, area, x0, y0, x1, y1, segments, anchors } as Island
  }

  /** The island of a polygon; 0 if there is no such polygon. Refused while edits wait, or a commit was left out. */
  of(polygon: PolygonId): IslandId {
    if (typeof polygon !== 'number') throw bad('polygon', 'a number', polygon)
    const { call, islands, world } = this.#current
    if (call.areIslandsOfNow(islands, world) === 2) throw new LgsError('uncommitted', misfits.uncommitted)
    return call.islandOf(islands, world, polygon) >>> 0
  }

  /** Takes an island out of the ground: an edit, which the next commit tells. What lies in its holes stays. */
  take(id: IslandId): GroundBody {
    uint32('id', id)
    const { call, islands, world } = this.#current
    const count = call.takeIsland(islands, world, id)
    if (count === 0) throw this.#from.failure()
    return bodyOf(this.#from.answer(count))
  }

  /** Sets a body into the ground, so that its origin is this cell; where it was, if none is given. All of it or nothing. */
  put(body: GroundBody, i?: number, j?: number): void {
    const column = int32('i', i ?? body?.i), row = int32('j', j ?? body?.j), count = putPolygons(this.#from, body)
    const { call, world } = this.#at
    if (!call.putBody(world, count, column, row)) throw this.#from.failure()
  }

  /**
   * The same at any place, in cells, and any angle. Vertices are rounded to the lattice, and what is solid already stays
   * as it is: what the body has beyond that is painted with its blocks.
   */
  putAsItLies(body: GroundBody, place: { x: number; y: number; angle: number }): void {
    const lies = placeIn(place), count = putPolygons(this.#from, body)
    const { call, world } = this.#at
    if (!call.putAsItLies(world, count, ...lies)) throw this.#from.failure()
  }

  get #current() {
    const at = this.#at
    if (!at.call.areIslandsOfNow(at.islands, at.world)) throw new LgsError('left-out', misfits['left-out'])
    return at
  }

  #numbers(count: number): number[] { return Array.from(this.#from.answer(count)) }

  /** Gives its memory back. A second call does nothing. The world's free() does not do it. */
  free(): void {
    if (this.#islands === 0) return
    if (!this.#from.ended) this.#from.call.freeIslands?.(this.#islands)
    this.#islands = 0
  }
  [Symbol.dispose](): void { this.free() }
}
