// The islands of a world: what hangs together, what is cut off, and what leaves the ground and comes back.
import { bad, int32, options, rect, reals, uint32 } from './check.js'
import { LgsError } from './error.js'
import { Follower, type Place } from './follower.js'
import { bodiesOf, placeIn, putPolygons } from './ground-body.js'
import type { Anchors, AtEdge, Foreseen, GroundBody, Island, IslandChanges, IslandId } from './island-types.js'
import type { Changes, PolygonId, World } from './types.js'

function numbersOf({ blocks = [], cells = [] }: Anchors): number[] {
  if (!Array.isArray(cells)) throw bad('anchors.cells', 'an array of rectangles', cells)
  const ids = reals('anchors.blocks', blocks).map((block) => uint32('a block of anchors', block))
  return [ids.length, ...ids, ...Array.from(cells, rect).flatMap(({ i0, j0, i1, j1 }) => [i0, j0, i1, j1])]
}

/** The island of all ground that is unloaded, or hangs together with such ground: what holds it is not known, so it never
 *  falls. It is not among all(), and has no facts. */
export const beyond: IslandId = 2 ** 32 - 1

/**
 * The islands of a world: solids that share at least a point are one island. Make it while no edit waits for its commit
 * and while there is no mark, and give it each commit's and roll-back's changes.
 */
export class Islands extends Follower {
  /** Looks at everything once. Without anchors nothing holds, and all that an update names is loose. */
  constructor(world: World, anchors: Anchors = {}, atEdge: AtEdge = 'holds') {
    const numbers = numbersOf(options('anchors', ['blocks', 'cells'], anchors))
    if (atEdge !== 'holds' && atEdge !== 'open') throw bad('atEdge', "'holds' or 'open'", atEdge)
    const isOpen = atEdge === 'open' ? 1 : 0
    super(world, 'freeIslands', (call, engine, address) => call.islands(address, engine.put(numbers), isOpen))
  }

  #isTrying = false

  #refuseInTry(): void {
    if (this.#isTrying) throw new LgsError('busy', 'what foresee() tries must only edit the world')
  }
  /** For modules of this package. */
  static refuseInTry(islands: Islands): void { islands.#refuseInTry() }

  override free(): void {
    this.#refuseInTry()
    super.free()
  }

  protected override isOfNow({ call, view, world }: Place): number { return call.areIslandsOfNow(view, world) }

  /**
   * Takes over what a commit or a roll-back did, each once and before the next edit. Throws, and has changed nothing:
   * 'not-the-last', 'uncommitted', or 'left-out', after which new Islands are needed. After a roll-back to a mark that
   * was made while edits waited it is 'uncommitted': make new Islands after the next commit.
   */
  update(changes: Changes): void { this.follow(changes, ({ call, view, world }) => call.updateIslands(view, world)) }

  /** Of the last update; all empty after the constructor. */
  get changes(): IslandChanges {
    const [added, removed, changed, cutOff, joined] = [0, 1, 2, 3, 4].map((list) => {
      const { call, view } = this.at
      return this.numbers(call.islandChanges(view, list))
    }) as [number[], number[], number[], number[], number[]]
    const pairs = (ids: number[]) =>
      Array.from({ length: ids.length / 2 }, (_, k) => ({ from: ids[2 * k]!, into: ids[2 * k + 1]! }))
    return { added, removed, changed, cutOff: pairs(cutOff), joined: pairs(joined) }
  }

  /** The islands of now that the last update names and that nothing holds. They may fall. */
  loose(): IslandId[] {
    const { call, view } = this.at
    return this.numbers(call.looseIslands(view))
  }

  all(): IslandId[] {
    const { call, view } = this.at
    return this.numbers(call.allIslands(view))
  }

  /** What is known of an island; null if the id names none. */
  island(id: IslandId): Island | null {
    uint32('id', id)
    const { call, view } = this.at
    if (!call.island(view, id)) return null
    const [area, x0, y0, x1, y1, segments, anchors] = this.from.answer(7) as unknown as number[]
    return { id, area, x0, y0, x1, y1, segments, anchors } as Island
  }

  /** The island of a polygon; 0 if there is no such polygon. Refused while edits wait, or a commit was left out. */
  of(polygon: PolygonId): IslandId {
    if (typeof polygon !== 'number') throw bad('polygon', 'a number', polygon)
    const { call, view, world } = this.current
    return call.islandOf(view, world, polygon) >>> 0
  }

  /** Takes an island out of the ground: an edit, which the next commit reports. What lies in its holes stays. */
  take(id: IslandId): GroundBody { return this.#take(id, 0)[0]! }

  /**
   * The same, to keep solids apart that touch in points only: a body for each part whose polygons share more
   * than points. All of them leave the ground.
   */
  takeApart(id: IslandId): GroundBody[] { return this.#take(id, 1) }

  #take(id: IslandId, isApart: number): GroundBody[] {
    uint32('id', id)
    const { call, view, world } = this.shown
    const count = call.takeIsland(view, world, id, isApart)
    if (count === 0) {
      const error = this.from.failure()
      throw error.code !== 'stale-handle' ? error
        : new LgsError('stale-handle', 'this id names no island that can be taken: it was taken, or changed by a commit, or is not all in memory')
    }
    return bodiesOf(this.from.answer(count))
  }

  /**
   * What an edit would do: makes it, looks, and rolls back. The world and the islands are as before, but for the ids of
   * islands; those in the result name nothing any more, and nothing is loose() then. Other followers of the world need
   * no notice. What the edit throws comes out of it. It must only edit: after a commit or a roll-back in it this
   * throws 'left-out', and everything that follows the world begins again.
   */
  foresee(edit: (world: World) => void): Foreseen {
    if (typeof edit !== 'function') throw bad('edit', 'a function', edit)
    this.#refuseInTry()
    void this.current
    const { world } = this, mark = world.mark()
    let wereEdits = true
    this.#isTrying = true
    try {
      edit(world)
      const at = this.at
      wereEdits = at.call.tryEdits(at.view, at.world) !== 0
      const { changes } = this, ids = new Set([...changes.added, ...changes.changed])
      for (const { from, into } of changes.cutOff) ids.add(from).add(into)
      for (const { into } of changes.joined) ids.add(into)
      const after = [...ids].sort((a, b) => a - b).flatMap((id) => this.island(id) ?? [])
      return { changes, after }
    } finally {
      this.#isTrying = false
      const { call, view, world: address } = this.at
      if (!call.untryEdits(view, address, mark) || !wereEdits)
        throw new LgsError('left-out', 'what foresee() tries must not commit or roll back: make new islands')
    }
  }

  /** Sets a body into the ground, so that its origin is this cell; where it was, if none is given. All of it or nothing. */
  put(body: GroundBody, i?: number, j?: number): void {
    const column = int32('i', i ?? body?.i), row = int32('j', j ?? body?.j), count = putPolygons(this.from, body)
    const { call, world } = this.at
    if (!call.putBody(world, count, column, row)) throw this.from.failure()
  }

  /**
   * The same at any place, in cells, and any angle. Vertices are rounded to the lattice, and what is solid already stays
   * as it is: what the body has beyond that is painted with its blocks.
   */
  putAsItLies(body: GroundBody, place: { x: number; y: number; angle: number }): void {
    const lies = placeIn(place), count = putPolygons(this.from, body)
    const { call, world } = this.at
    if (!call.putAsItLies(world, count, ...lies)) throw this.from.failure()
  }
}

export const { refuseInTry } = Islands
