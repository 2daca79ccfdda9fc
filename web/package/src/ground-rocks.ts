// The rocks of a Ground: those in the air, and those of other moments, to be undone or redone. It owns their bodies. Marks
// have numbers, as Ground gives them.
import { bad } from './check.js'
import { LgsError } from './error.js'
import type { Host, Motion, Rock } from './ground-types.js'
import type { GroundBody } from './island-types.js'

/** How often a rock did not become ground at rest, or nothing held it then; and the step before which it does not try. */
export interface Tries {
  readonly count: number
  readonly until: number
}

/** A rock, and between which marks it is one: it was taken in the stretch after the mark `took`. */
interface Fallen<Body> {
  readonly ground: GroundBody
  motion: Motion
  body: Body | null
  readonly took: number
  settled: number
  isInAir: boolean
  tries: Tries
}

const never = { count: 0, until: 0 }
const atRest = ({ i, j }: GroundBody): Motion => ({ x: i, y: j, angle: 0, vx: 0, vy: 0, spin: 0 })
const isThere = ({ took, settled }: { took: number; settled: number }, mark: number) => took < mark && settled >= mark

export class GroundRocks<Body> {
  readonly #host: Host<Body>
  #rocks: Fallen<Body>[] = []
  #steps = 0  // how often rocks could settle
  #next = 0   // which of them looks first whether it can settle

  constructor(host: Host<Body>) { this.#host = host }

  get count(): number { return this.#rocks.length }
  /** A rock that was taken after a mark. makeFrom() makes its body. */
  add(ground: GroundBody, took: number, tries = never, motion = atRest(ground)): void {
    this.#rocks.push({ ground, motion, body: null, took, settled: Infinity, isInAir: true, tries })
  }
  makeFrom(first: number): void { for (const each of this.#rocks.slice(first)) this.#make(each) }
  /** What the game destroyed is not ground any more. */
  dropGone(): void {
    if (!this.#rocks.some(({ body }) => body !== null)) return
    const isAlive = this.#host.living()
    for (const { body } of this.#rocks) if (body !== null && !isAlive(body)) this.#host.forget(body)
    this.#rocks = this.#rocks.filter(({ body }) => body === null || isAlive(body))
  }
  destroyAll(): void {
    for (const each of this.#inAir()) this.#destroy(each)
    this.#rocks = []
  }
  forget(body: Body): void {
    const found = this.#find(body)
    this.#rocks = this.#rocks.filter((each) => each !== found)
    this.#host.forget(body)
  }

  /** As they lie now. */
  values(): Rock<Body>[] {
    return this.#inAir().map(({ ground, body, motion }) => ({ ground, body, ...(body === null ? motion : this.#host.motionOf(body)) }))
  }
  /** Whether something became a rock, or ground, after a mark. */
  anyOf(mark: number): boolean { return this.#rocks.some(({ took, settled }) => took === mark || settled === mark) }

  // --- Settling, after the mark `now`: an edit, behind which the future is dropped and committed. Null, if there was none.

  /** The rocks in turn. One that does not fit, or would fall again, tries again later and later. */
  settleNext(now: number): Tries | null {
    ++this.#steps
    for (let k = Math.min(this.#rocks.length, 16); k > 0; --k) {
      const each = this.#rocks[this.#next++ % this.#rocks.length]!, { body, tries: { count, until } } = each
      if (!each.isInAir || body === null || this.#steps < until || !this.#host.rests(body)) continue
      each.tries = { count: count + 1, until: this.#steps + 60 * 2 ** Math.min(count, 6) }
      try {
        return this.#settle(each, now)
      } catch (error) {  // a brush is refused, as in a cell that is full to its limits
        if (!(error instanceof LgsError) || error.code === 'out-of-memory' || error.code === 'crashed') throw error
        return null
      }
    }
    return null
  }
  settle(body: Body, now: number): Tries | null {
    const rock = this.#find(body)
    if (rock.body === null) throw bad('body', 'a body: this rock is too thin for one,', body)
    return this.#settle(rock, now)
  }
  #settle(each: Fallen<Body>, now: number): Tries | null {
    const { x, y, angle } = this.#host.motionOf(each.body!)
    if (!this.#host.settle(each.body!, each.ground)) return null
    Object.assign(each, { body: null, isInAir: false, settled: now, motion: { x, y, angle, vx: 0, vy: 0, spin: 0 } })
    return each.tries
  }

  // --- Undo

  /** The bodies of rocks that are none at a mark go. */
  leave(mark: number): void {
    for (const each of this.#rocks) {
      if (!each.isInAir || isThere(each, mark)) continue
      this.#destroy(each)
      each.body = null
      each.isInAir = false
      if (each.took >= mark) each.motion = atRest(each.ground)
    }
  }
  /** Those that are rocks at a mark and have no body get one, where they lay. */
  comeBack(mark: number): void { for (const each of this.#rocks) if (!each.isInAir && isThere(each, mark)) this.#make(each) }
  dropFuture(now: number): void {
    this.#rocks = this.#rocks.filter(({ isInAir, took }) => isInAir || took < now)
    for (const each of this.#rocks) if (each.isInAir) each.settled = Infinity
  }
  forgetBefore(oldest: number): void { this.#rocks = this.#rocks.filter(({ isInAir, settled }) => isInAir || settled >= oldest) }

  #inAir(): Fallen<Body>[] { return this.#rocks.filter(({ isInAir }) => isInAir) }
  #find(body: Body): Fallen<Body> {
    const found = this.#inAir().find((each) => each.body === body)
    if (found === undefined) throw bad('body', 'one of rocks()', body)
    return found
  }
  #make(each: Fallen<Body>): void {
    each.body = this.#host.make(each.ground, each.motion)
    each.isInAir = true
  }
  #destroy({ body }: Fallen<Body>): void { if (body !== null) this.#host.destroy(body) }
}
