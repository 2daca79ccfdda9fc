// What islands and pieces have in common: a view of a world in the engine, which is notified of each commit and roll-back.
import { object } from './check.js'
import type { Engine } from './engine.js'
import { LgsError } from './error.js'
import { type IslandCalls, islandCalls } from './island-calls.js'
import type { Changes, World } from './types.js'
import { placeOf } from './world.js'

const misfits = {
  'not-the-last': 'these changes are not those of the last commit or roll-back of this world',
  'left-out': 'changes before these were left out: make a new one',
  uncommitted: 'edits wait for their commit: update after each commit, before the next edit',
} as const
const misfit = (code: keyof typeof misfits) => new LgsError(code, misfits[code])

type Drop = 'freeIslands' | 'dropPieces'

export abstract class Follower {
  protected readonly world: World
  protected readonly from: Engine
  #view = 0 // its address; 0 when it is gone
  readonly #drop: Drop

  protected constructor(world: World, drop: Drop, make: (call: IslandCalls, engine: Engine, world: number) => number) {
    const { engine, address } = placeOf(world)
    this.world = world
    this.from = engine
    this.#drop = drop
    this.#view = make(islandCalls(engine), engine, address) >>> 0
    if (this.#view === 0) throw engine.failure()
  }

  /** Whether the view shows the last commit: 0 if not, 1 if there was no edit since, 2 if there was. */
  protected abstract isOfNow(at: Place): number

  /** Ask for it last: until then getters of arguments may free the world. */
  protected get at(): Place {
    const { engine, address } = placeOf(this.world)
    if (this.#view === 0) throw new LgsError('freed', 'this view was freed')
    return { call: islandCalls(engine), view: this.#view, world: address }
  }

  /** The same where the view shows the last commit; edits may wait. */
  protected get shown(): Place {
    const at = this.at
    if (this.isOfNow(at) === 0) throw misfit('left-out')
    return at
  }

  /** The same where none waits. */
  protected get current(): Place {
    const at = this.shown
    if (this.isOfNow(at) === 2) throw misfit('uncommitted')
    return at
  }

  protected follow(changes: Changes, update: (at: Place) => number): void {
    if (object('changes', 'those of a commit', changes).after !== this.world.version) throw misfit('not-the-last')
    const code = ([null, 'left-out', 'uncommitted'] as const)[update(this.at)]!
    if (code !== null) throw misfit(code)
  }

  protected numbers(count: number): number[] { return Array.from(this.from.answer(count)) }

  /** Gives its memory back. A second call does nothing. The world's free() does not do it. */
  free(): void {
    if (this.#view === 0) return
    if (!this.from.ended) islandCalls(this.from)[this.#drop](this.#view)
    this.#view = 0
  }
  [Symbol.dispose](): void { this.free() }
}

export interface Place {
  readonly call: IslandCalls
  readonly view: number
  readonly world: number
}
