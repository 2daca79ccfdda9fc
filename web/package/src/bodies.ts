// Law 13, no body inside the ground: bodies in ground that changes. It is the same for each physics engine; docs/box2d.md describes
// it. What is decided here is what to do; TerrainRules knows which bodies overlap.
import type { Box, Form, Frame, OnOverlap, Point, TerrainRules } from './terrain.js'

/** A body that new ground would overlap, or overlaps. */
export interface Overlap<Body> {
  readonly body: Body
  /** How deep the ground is in it, in metres: from half way to its centre on. */
  readonly depth: number
  /** Whether there is a path out, and it, in metres. */
  readonly isFree: boolean
  readonly displacement: Point
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
  /** How much rounding changes a number, at most, in proportion to it. */
  readonly epsilon: number
  /** What distinguishes bodies. */
  keyOf(body: Body): unknown
  /** Dynamic bodies that are enabled and reach into a box of cells, each once. */
  near(box: Box): Body[]
  /** Those that the last step may have moved: dynamic, enabled, and awake. */
  eachMoved(moved: (body: Body) => void): void
  /** Before a step: dynamic and enabled bodies, all that may be new among them; `known` are those that are noted. */
  eachToNote(known: readonly Body[], note: (body: Body) => void): void
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

/** A body that moved by less since it was free can not have come through anything. */
const isFar = (a: Point, b: Point) => Math.abs(a.x - b.x) > 1 / 16 || Math.abs(a.y - b.y) > 1 / 16
const isSame = (a: Place, b: Place) => a.x === b.x && a.y === b.y && a.cos === b.cos && a.sin === b.sin
const nowhere = { x: 0, y: 0 }
export const everywhere: Box = { x0: -1e9, y0: -1e9, x1: 1e9, y1: 1e9 }
/** How many cells a lattice unit is. */
const unit = 1 / 65536

/** From no way on, to the nearest first: up to three steps to each side. */
const steps = [0, 1, 2, 3].flatMap((far) => {
  const line = Array.from({ length: 2 * far + 1 }, (_, k) => k - far)
  return line.flatMap((x) => line.map((y): Point => ({ x, y }))).filter(({ x, y }) => Math.max(Math.abs(x), Math.abs(y)) === far)
})

export class Bodies<Body, Material> {
  overlaps: readonly Overlap<Body>[] = []
  readonly #physics: Physics<Body, Material>
  readonly #rules: TerrainRules<Material>
  #disabled: Body[] = []
  readonly #footings = new Map<unknown, { body: Body; place: Place }>() // where bodies were free last

  constructor(physics: Physics<Body, Material>, rules: TerrainRules<Material>) {
    this.#physics = physics
    this.#rules = rules
  }

  get disabled(): Body[] { return [...this.#disabled] }
  get holdsSomebody(): boolean { return this.#disabled.length > 0 }

  get #tolerance(): number { return this.#physics.slop / this.#physics.frame.cellSize }
  #formsOf(body: Body) { return this.#physics.formsOf(body, this.#physics.placeOf(body)) }

  /** Between the halves of a sync: which bodies overlap what changed within a box. */
  find(box: Box): Overlap<Body>[] {
    const { cellSize } = this.#physics.frame
    const all: Overlap<Body>[] = []
    for (const body of this.#physics.near(box)) {
      const found = this.#rules.overlap(this.#formsOf(body), this.#tolerance)
      if (found === null) continue
      const { x, y } = found.way ?? nowhere
      all.push({ body, depth: found.depth * cellSize, isFree: found.way !== null, displacement: { x: x * cellSize, y: y * cellSize } })
    }
    return all
  }

  /** After a sync. Those that were disabled before come first. So a body that overlaps now is not tried twice. */
  settle(hasChanged: boolean, onOverlap: OnOverlap): void {
    const physics = this.#physics
    if (this.#disabled.length > 0) {
      const isAlive = physics.isAlive(this.#disabled)
      this.#disabled = this.#disabled.filter((body) =>
        isAlive(body) && !physics.isEnabled(body) && !(hasChanged && this.#release(body)))
    }
    for (const { body, isFree, displacement } of this.overlaps) {
      if (isFree && onOverlap === 'push') {
        this.#push(body, displacement)
      } else {
        physics.setVelocity(body, nowhere, true)
        physics.setEnabled(body, false)
        this.#disabled.push(body)
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
    const end = { ...place, x: place.x + way.x / cellSize, y: place.y + way.y / cellSize }
    physics.moveTo(body, this.#freeNear(body, end) ?? end)
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

  /** Of a body that is new, or that the game has put elsewhere. */
  moved(body: Body): void {
    const place = this.#physics.placeOf(body)
    if (this.#isFreeAt(body, place)) this.#note(body, place)
    else this.#footings.delete(this.#physics.keyOf(body))
  }

  /** Notes where those are. A body in the ground comes back to where it was free. */
  beforeStep(): void {
    const physics = this.#physics
    physics.eachToNote(Array.from(this.#footings.values(), ({ body }) => body), (body) => {
      const place = physics.placeOf(body), last = this.#footings.get(physics.keyOf(body))?.place
      if (last !== undefined && isSame(last, place)) return
      if (this.#isFreeAt(body, place)) this.#note(body, place)
    })
  }

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

  /** Puts bodies that were pressed through an edge in a step, or came through ground, back to where they were free. Returns them. */
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
      } else if (last !== undefined && this.#return(body, last)) {
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

  /**
   * Where a place is rounded, as the origin moved since or as a path ends there, a centre may come onto the outline. Then
   * the nearest of the places around that is free; null if none is.
   */
  #freeNear(body: Body, place: Place): Place | null {
    const { frame: { origin }, epsilon } = this.#physics, forms = this.#physics.formsOf(body, place)
    const step = Math.max(unit, epsilon * Math.max(Math.abs(place.x - origin.i), Math.abs(place.y - origin.j)))
    const solids = this.#solids(steps.flatMap((by) => forms.flatMap(({ x, y }) => [x + step * by.x, y + step * by.y])))
    for (const [k, by] of steps.entries()) {
      const near = k === 0 ? place : { ...place, x: place.x + step * by.x, y: place.y + step * by.y }
      if (this.#isFree(forms, solids, k * forms.length) && this.#isFreeAt(body, near)) return near
    }
    return null
  }

  #return(body: Body, last: Place): boolean {
    const free = this.#freeNear(body, last)
    if (free !== null) this.#physics.moveTo(body, free)
    return free !== null
  }

  /** When the game has rounded bodies to other places. One that is not near to where it was free is not moved yet. */
  afterRounding(): void {
    for (const body of this.#physics.near(everywhere)) {
      const last = this.#footings.get(this.#physics.keyOf(body))?.place, place = this.#physics.placeOf(body)
      if (last !== undefined && !isFar(last, place) && !this.#isFreeAt(body, place)) this.#return(body, last)
    }
  }

  #hasCrossed(body: Body, last: Place, place: Place, forms: readonly Form<Material>[]): boolean {
    if (!isFar(last, place)) return false
    return this.#rules.crossed(this.#physics.formsOf(body, last), forms)
  }

  /** Whether the ground leaves a body room, where it is or elsewhere. */
  fits(body: Body, place: Place = this.#physics.placeOf(body)): boolean {
    return this.#rules.leavesRoom(this.#physics.formsOf(body, place), this.#tolerance)
  }

  outlinesOf(body: Body): Float64Array[] { return this.#rules.outlines(this.#formsOf(body)) }
}
