// Counts kicks: pushes in a direction that the ground does not have there (docs/reports/box2d.md, The ride).
import {
  type Contact,
  type ContactImpulse,
  type Fixture,
  type Vec2Value,
  WorldManifold,
  type World as Physics,
} from 'planck'
import type { PlanckTerrain } from 'localgridseg/planck'
import type { Mirror } from './mirror.js'

export interface Kick {
  readonly x: number
  readonly y: number
  /** Metres a second. */
  readonly strength: number
  /** The step in which it happened. */
  readonly step: number
}

const leastKick = 0.01 // metres a second
/** For how many steps a kick is in `recent`. */
export const remembered = 240
const near = 0.06 // metres
const degree = Math.PI / 180
// The ground has a direction if it has it to within a degree. But polygons: planck takes the direction of a polygon's
// face for that of an edge if the cosine between them is at least 1 - angularSlop, which is 15.2 degrees.
const circleTolerance = Math.sin(degree)
const polygonTolerance = Math.sin(15.5 * degree)

interface Side {
  readonly start: Vec2Value
  readonly end: Vec2Value
  readonly normal: Vec2Value
}

export class KickMeter {
  count = 0
  /** Of the hardest one, in metres a second. */
  hardest = 0
  /** The latest ones, for the picture. */
  readonly recent: Kick[] = []
  readonly #physics: Physics
  readonly #terrain: PlanckTerrain
  readonly #mirror: Mirror
  readonly #manifold = new WorldManifold()
  #odd = new Map<Contact, (Vec2Value | null)[]>() // the points that push in a direction the ground does not have
  #tolerance = circleTolerance
  #step = 0
  #kicked = new Map<Fixture, number>() // the last step in which it was kicked

  constructor(physics: Physics, terrain: PlanckTerrain, mirror: Mirror) {
    this.#physics = physics
    this.#terrain = terrain
    this.#mirror = mirror
    physics.on('pre-solve', (contact) => this.#look(contact))
    physics.on('post-solve', (contact, impulse) => this.#measure(contact, impulse))
  }

  beginStep(): void {
    ++this.#step
    this.#odd.clear()
    while (this.recent.length > 0 && this.#step - this.recent[0].step > remembered) this.recent.shift()
  }

  get step(): number {
    return this.#step
  }

  reset(): void {
    this.count = 0
    this.hardest = 0
    this.recent.length = 0
    this.#kicked.clear()
  }

  // Where a contact pushes is known before the solver moves the bodies.
  #look(contact: Contact): void {
    const isA = this.#terrain.segment(contact.getFixtureA()) !== 0
    const [ground, mover] = isA
      ? [contact.getFixtureA(), contact.getFixtureB()]
      : [contact.getFixtureB(), contact.getFixtureA()]
    const segment = this.#terrain.segment(ground)
    this.#odd.delete(contact)
    if (segment === 0 || !contact.isEnabled()) return
    const { normal, points, pointCount } = contact.getWorldManifold(this.#manifold)!
    const outward = isA ? normal : { x: -normal.x, y: -normal.y }
    this.#tolerance = mover.getType() === 'circle' ? circleTolerance : polygonTolerance
    const g = this.#mirror.geometry[segment]
    if (this.#isAlong(normalOf(g[0], g[1], g[2], g[3]), outward)) return
    const odd = points.slice(0, pointCount).map(({ x, y }) => (this.#faces({ x, y }, outward) ? null : { x, y }))
    if (odd.some((point) => point !== null)) this.#odd.set(contact, odd)
  }

  // How hard it pushes is known afterwards. Pushes in several steps in a row are one kick.
  #measure(contact: Contact, impulse: ContactImpulse): void {
    const odd = this.#odd.get(contact)
    if (odd === undefined) return
    const isA = this.#terrain.segment(contact.getFixtureA()) !== 0
    const fixture = isA ? contact.getFixtureB() : contact.getFixtureA()
    odd.forEach((point, k) => {
      if (point !== null) this.#note(fixture, point, impulse.normalImpulses[k] / fixture.getBody().getMass())
    })
  }

  #note(fixture: Fixture, point: Vec2Value, strength: number): void {
    if (strength < leastKick) return
    this.hardest = Math.max(this.hardest, strength)
    if (this.#kicked.get(fixture) !== this.#step && this.#kicked.get(fixture) !== this.#step - 1) {
      ++this.count
      this.recent.push({ ...point, strength, step: this.#step })
    }
    this.#kicked.set(fixture, this.#step)
  }

  #sideOf(segment: number): Side {
    const g = this.#mirror.geometry[segment]
    return {
      start: this.#terrain.position(g[0], g[1]),
      end: this.#terrain.position(g[2], g[3]),
      normal: normalOf(g[0], g[1], g[2], g[3]),
    }
  }

  // Whether a part of the ground near the point faces this way: a side, or a convex corner between two sides.
  #faces(point: Vec2Value, normal: Vec2Value): boolean {
    const box = {
      lowerBound: { x: point.x - near, y: point.y - near },
      upperBound: { x: point.x + near, y: point.y + near },
    }
    let found = false
    this.#physics.queryAABB(box, (fixture) => {
      const segment = this.#terrain.segment(fixture)
      if (segment !== 0 && this.#sideFaces(segment, point, normal)) found = true
      return !found
    })
    return found
  }

  #sideFaces(segment: number, point: Vec2Value, normal: Vec2Value): boolean {
    const side = this.#sideOf(segment)
    if (distance(side.start, side.end, point) > near) return false
    if (this.#isAlong(side.normal, normal)) return true
    const g = this.#mirror.geometry[segment]
    if (Number.isNaN(g[6]) || Math.hypot(point.x - side.end.x, point.y - side.end.y) > near) return false
    const next = normalOf(g[2], g[3], g[6], g[7])
    if (cross(side.normal, next) <= 0) return false
    return this.#isAlong(next, normal) || (cross(side.normal, normal) > 0 && cross(normal, next) > 0)
  }

  #isAlong(a: Vec2Value, b: Vec2Value): boolean {
    return a.x * b.x + a.y * b.y > 0 && Math.abs(cross(a, b)) <= this.#tolerance
  }
}

function normalOf(x0: number, y0: number, x1: number, y1: number): Vec2Value {
  const length = Math.hypot(x1 - x0, y1 - y0)
  return { x: (y1 - y0) / length, y: (x0 - x1) / length }
}

function cross(a: Vec2Value, b: Vec2Value): number {
  return a.x * b.y - a.y * b.x
}

function distance(a: Vec2Value, b: Vec2Value, p: Vec2Value): number {
  const [ux, uy] = [b.x - a.x, b.y - a.y]
  const t = Math.min(1, Math.max(0, ((p.x - a.x) * ux + (p.y - a.y) * uy) / (ux * ux + uy * uy)))
  return Math.hypot(p.x - a.x - t * ux, p.y - a.y - t * uy)
}
