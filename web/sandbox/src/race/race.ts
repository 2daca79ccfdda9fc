// A race: the same wheel over the same floor, with ghosts and without. The floor is level and has no friction, so that
// nothing but kicks can slow a wheel down. Gravity is that of the Moon, so that one sees how high they throw it.
import { createWorld, type World } from 'localgridseg'
import { ICE } from '../blocks.js'
import type { Rider, Start } from '../bodies.js'
import { Mirror } from '../mirror.js'
import { cell } from '../scale.js'
import { type Gate, Side, stepTime } from '../side.js'
import { tiles } from '../tiles.js'

export const finish = 24 // cells
export const start: Start = { kind: 'marble', x: 0.5, y: 1.36, speed: 7.4, size: 0.35, colour: 0 }
const gravity = 1.62 // metres per second squared
const nowhere: Gate = { x: 0, y: 0, speed: 0, bottom: -1000 }
const longest = 12 // seconds
const before = 9 // steps of the replay before the kick
const after = 10
const worthwhile = 0.04 // metres a second: a kick that one can see under the lens

/** Where a wheel was, in cells; its velocity in cells a second. */
export interface Moment {
  readonly x: number
  readonly y: number
  readonly angle: number
  readonly vx: number
  readonly vy: number
}

export class Lane {
  readonly side: Side
  readonly rider: Rider
  /** One for each step. */
  readonly moments: Moment[] = []
  /** In seconds; null until then. */
  time: number | null = null
  /** Where it was kicked, and at which moment: x, y in cells. */
  readonly kicks: { readonly at: [number, number]; readonly moment: number }[] = []
  /** The step of the first kick that can be seen; -1 before. */
  kickAt = -1

  constructor(world: World, mirror: Mirror, ghosts: boolean) {
    this.side = new Side(world, mirror, ghosts)
    this.side.physics.setGravity({ x: 0, y: -gravity })
    this.side.add(start)
    this.rider = this.side.riders[0]
    this.#note()
  }

  step(): void {
    this.side.step(0, nowhere)
    this.#note()
    const { recent, step } = this.side.kicks
    const fresh = recent.filter((kick) => kick.step === step)
    for (const { x, y } of fresh) this.kicks.push({ at: [x / cell, y / cell], moment: this.moments.length - 1 })
    if (this.kickAt < 0 && fresh.some(({ strength }) => strength >= worthwhile)) this.kickAt = this.moments.length - 1
    const now = this.moments.at(-1)!
    if (this.time !== null || now.x < finish) return
    // Between two steps, so that the times are not rounded to a sixtieth of a second.
    const last = this.moments.at(-2)!
    this.time = (this.moments.length - 2 + (finish - last.x) / (now.x - last.x)) * stepTime
  }

  /** The steps around the kick, as far as they are known. */
  get replay(): readonly Moment[] {
    return this.kickAt < 0 ? [] : this.moments.slice(Math.max(0, this.kickAt - before), this.kickAt + after)
  }

  /** Which of the replay's moments is the kick. */
  get kickInReplay(): number {
    return Math.max(0, Math.min(this.kickAt, before))
  }

  #note(): void {
    const [body] = this.rider.bodies
    const { x, y } = body.getPosition()
    const v = body.getLinearVelocity()
    this.moments.push({ x: x / cell, y: y / cell, angle: body.getAngle(), vx: v.x / cell, vy: v.y / cell })
  }
}

export class Race {
  readonly world: World
  /** With ghosts first. */
  readonly lanes: readonly Lane[]
  #steps = 0

  constructor() {
    this.world = createWorld()
    this.world.fill({ i0: -1, j0: 0, i1: finish + 6, j1: 0 }, this.world.shape(tiles[0].vertices), ICE)
    this.world.commit()
    const mirror = new Mirror()
    mirror.reset(this.world)
    this.lanes = [true, false].map((ghosts) => new Lane(this.world, mirror, ghosts))
  }

  get isOver(): boolean {
    return this.lanes.every(({ time }) => time !== null) || this.#steps * stepTime > longest
  }

  get seconds(): number {
    return this.#steps * stepTime
  }

  step(): void {
    if (this.isOver) return
    ++this.#steps
    for (const lane of this.lanes) if (lane.moments.at(-1)!.x < finish + 4) lane.step()
  }

  free(): void {
    this.world.free()
  }

  /** In words. */
  get result(): string {
    const [smooth, rough] = this.lanes
    if (smooth.time === null) return ''
    if (rough.time === null) return `With ghost vertices: ${smooth.time.toFixed(2)} s.`
    const kicks = rough.side.kicks.count
    const [won, lost] = [smooth.time.toFixed(2), rough.time.toFixed(2)]
    const lead = (Number(lost) - Number(won)).toFixed(2)  // of the times as they are read
    return `With ghost vertices: ${won} s. Without: ${lost} s, ${lead} s later, after ${kicks} ${kicks === 1 ? 'kick' : 'kicks'}.`
  }

  /** What the speeds show, when it is over. */
  get ending(): string {
    const [smooth, rough] = this.lanes.map(({ moments }) => moments.findLast(({ x }) => x <= finish)!.vx.toFixed(1))
    return `Each kick costs speed: ${rough} is left of ${smooth}.`
  }
}
