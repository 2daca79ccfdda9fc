// Law 13, nobody is buried: bodies in ground that changes. It is the same for each physics engine; docs/box2d.md tells
// it. What is decided here is what to do; TerrainRules knows who is caught.
import type { Box, Form, Frame, OnCaught, Point, TerrainRules } from './terrain.js'

/** A body that new ground would hold, or holds. */
export interface Caught<Body> {
  readonly body: Body
  /** How deep the ground is in it, in metres: from half way to its middle on. */
  readonly depth: number
  /** Whether there is a way out, and it, in metres. */
  readonly isFree: boolean
  readonly way: Point
}

/** Where a body is: its origin in cells, so that the origin of the physics world may move, and how it is turned. */
export interface Place extends Point {
  readonly cos: number
  readonly sin: number
}

/** What law 13 needs of a physics engine. */
export interface Physics<Body, Material> {
  readonly frame: Frame
  /** In metres: the least that counts. */
  readonly slop: number
  /** What tells bodies apart. */
  keyOf(body: Body): unknown
  /** Dynamic bodies that are enabled and reach into a box of cells, each once. */
  near(box: Box): Body[]
  /** Those that the last step may have moved: dynamic, enabled, and awake. */
  eachMoved(moved: (body: Body) => void): void
  bodyCount(): number
  isAlive(bodies: readonly Body[]): (body: Body) => boolean
  isEnabled(body: Body): boolean
  placeOf(body: Body): Place
  /** The shapes of a body, but sensors, as if it were at a place. */
  formsOf(body: Body, place: Place): Form<Material>[]
  moveTo(body: Body, place: Place): void
  velocityOf(body: Body): Point
  /** With no turning if `stops`. */
  setVelocity(body: Body, velocity: Point, stops: boolean): void
  setEnabled(body: Body, on: boolean): void
  wake(body: Body): void
}

/** Cells: who has moved by less since it was free can not have come through anything. */
const far = 1 / 16
const nowhere = { x: 0, y: 0 }

export class Bodies<Body, Material> {
  caught: readonly Caught<Body>[] = []
  readonly #physics: Physics<Body, Material>
  readonly #rules: TerrainRules<Material>
  #held: Body[] = []
  readonly #footings = new Map<unknown, { body: Body; place: Place }>() // where bodies were free last

  constructor(physics: Physics<Body, Material>, rules: TerrainRules<Material>) {
    this.#physics = physics
    this.#rules = rules
  }

  get held(): Body[] { return [...this.#held] }
  get holdsSomebody(): boolean { return this.#held.length > 0 }

  get #tolerance(): number { return this.#physics.slop / this.#physics.frame.cellSize }
  #formsOf(body: Body) { return this.#physics.formsOf(body, this.#physics.placeOf(body)) }

  /** Between the halves of a sync: who is caught by what changed within a box. */
  find(box: Box): Caught<Body>[] {
    const { cellSize } = this.#physics.frame
    const all: Caught<Body>[] = []
    for (const body of this.#physics.near(box)) {
      const found = this.#rules.caught(this.#formsOf(body), this.#tolerance)
      if (found === null) continue
      const { x, y } = found.way ?? nowhere
      all.push({ body, depth: found.depth * cellSize, isFree: found.way !== null, way: { x: x * cellSize, y: y * cellSize } })
    }
    return all
  }

  /** After a sync. Those that were held before come first. So who is caught now is not tried twice. */
  settle(hasChanged: boolean, onCaught: OnCaught): void {
    const physics = this.#physics
    if (this.#held.length > 0) {
      const isAlive = physics.isAlive(this.#held)
      this.#held = this.#held.filter((body) =>
        isAlive(body) && !physics.isEnabled(body) && !(hasChanged && this.#release(body)))
    }
    for (const { body, isFree, way } of this.caught) {
      if (isFree && onCaught === 'push') {
        this.#push(body, way)
      } else {
        physics.setVelocity(body, nowhere, true)
        physics.setEnabled(body, false)
        this.#held.push(body)
      }
    }
  }

  #release(body: Body): boolean {
    const way = this.#rules.released(this.#formsOf(body), this.#tolerance)
    if (way === null) return false
    const { cellSize } = this.#physics.frame
    this.#physics.setEnabled(body, true)
    this.#push(body, { x: way.x * cellSize, y: way.y * cellSize })
    return true
  }

  #push(body: Body, way: Point): void {
    const physics = this.#physics, { cellSize } = physics.frame
    const place = physics.placeOf(body)
    physics.moveTo(body, { ...place, x: place.x + way.x / cellSize, y: place.y + way.y / cellSize })
    const velocity = physics.velocityOf(body)
    const inward = velocity.x * way.x + velocity.y * way.y
    if (inward < 0) {
      const part = inward / (way.x * way.x + way.y * way.y)
      physics.setVelocity(body, { x: velocity.x - part * way.x, y: velocity.y - part * way.y }, false)
    }
    physics.wake(body)
    this.#note(body, physics.placeOf(body))
  }

  #note(body: Body, place: Place): void { this.#footings.set(this.#physics.keyOf(body), { body, place }) }

  forget(body: Body): void { this.#footings.delete(this.#physics.keyOf(body)) }

  /** When bodies in a box, which is around all, may be elsewhere: what was noted says nothing any more. */
  noteAll(box: Box): void {
    this.#footings.clear()
    for (const body of this.#physics.near(box)) {
      const place = this.#physics.placeOf(body)
      if (this.#isFreeAt(body, place)) this.#note(body, place)
    }
  }

  /** Forgets bodies that are gone, when there are many. */
  #prune(): void {
    if (this.#footings.size <= 2 * this.#physics.bodyCount() + 64) return
    const isAlive = this.#physics.isAlive(Array.from(this.#footings.values(), ({ body }) => body))
    for (const [key, { body }] of this.#footings) if (!isAlive(body)) this.#footings.delete(key)
  }

  /** Who was pressed through an edge in a step, or came through ground, is put back to where it was free; they. */
  afterStep(): Body[] {
    const physics = this.#physics
    const moved: { body: Body; place: Place; forms: Form<Material>[] }[] = [], middles: number[] = []
    physics.eachMoved((body) => {
      const place = physics.placeOf(body), forms = physics.formsOf(body, place)
      for (const { x, y } of forms) middles.push(x, y)
      moved.push({ body, place, forms })
    })
    const solids = this.#solids(middles), putBack: Body[] = []
    let next = 0
    for (const { body, place, forms } of moved) {
      const from = next, last = this.#footings.get(physics.keyOf(body))?.place
      next += forms.length
      if (this.#isFree(forms, solids, from) && !(last !== undefined && this.#hasCrossed(body, last, place, forms))) {
        this.#note(body, place)
      } else if (last !== undefined && this.#isFreeAt(body, last)) {
        physics.moveTo(body, last)
        physics.setVelocity(body, nowhere, true)
        putBack.push(body)
      }
    }
    this.#prune()
    return putBack
  }

  /** A copy: material() may use the package. */
  #solids(points: readonly number[]): Float64Array {
    return points.length > 0 ? this.#rules.solids(points).slice() : new Float64Array()
  }

  #isFree(forms: readonly Form<Material>[], solids: ArrayLike<number>, from: number): boolean {
    return forms.every((form, k) => solids[from + k]! < 0 || !form.holds(this.#rules.materialOf(solids[from + k]!)))
  }

  #isFreeAt(body: Body, place: Place): boolean {
    const forms = this.#physics.formsOf(body, place)
    return this.#isFree(forms, this.#solids(forms.flatMap(({ x, y }) => [x, y])), 0)
  }

  #hasCrossed(body: Body, last: Place, { x, y }: Place, forms: readonly Form<Material>[]): boolean {
    if (Math.abs(x - last.x) <= far && Math.abs(y - last.y) <= far) return false
    return this.#rules.crossed(this.#physics.formsOf(body, last), forms)
  }

  /** Whether the ground leaves a body room, where it is or elsewhere. */
  fits(body: Body, place: Place = this.#physics.placeOf(body)): boolean {
    return this.#rules.leavesRoom(this.#physics.formsOf(body, place), this.#tolerance)
  }

  outlinesOf(body: Body): Float64Array[] { return this.#rules.outlines(this.#formsOf(body)) }
}
