// Ground that falls, as bodies of planck.
import { type Body, type FixtureOpt, Polygon, Settings, Vec2, type World as Physics, WorldManifold } from 'planck'
import { type Falling as FallingOf, FallingBase, type FallingMass, type FallingOptions as OptionsOf, type FallingPart, type Lies, type Maker } from './falling-base.js'
import type { Islands } from './islands.js'
import { isPhysics, whole } from './planck-bodies.js'
import type { PlanckTerrain } from './planck.js'

export type FallingOptions = OptionsOf<FixtureOpt>
export type Falling = FallingOf<Body>

const narrow = 0.1 // of the radius of gyration: so far from the rim of what it stands on the weight is safe
const push = 0.1 // of what a pendulum of that radius has
const mostPushes = 3 // of one body

export class FallingGround extends FallingBase<Body, FixtureOpt> {
  readonly #terrain: PlanckTerrain
  readonly #pushed = new WeakMap<Body, { readonly angle: number; readonly times: number }>()

  constructor(physics: Physics, terrain: PlanckTerrain, islands: Islands, options: FallingOptions = {}) {
    isPhysics(physics)
    super(terrain, islands, options, new InPlanck(physics, options))
    this.#terrain = terrain
  }

  /**
   * Whether a body sleeps on ground, and may be settled. planck lets bodies sleep that stand on a tip. Where the weight is
   * near the rim of what carries it, a small push wakes the body, to that side; it rests once it has stood that.
   */
  rests(body: Body): boolean {
    if (!body.isActive() || body.isAwake()) return false
    const { x: gx, y: gy } = body.getWorld().getGravity(), pull = Math.hypot(gx, gy), { x, y } = body.getWorldCenter()
    const manifold = new WorldManifold(), local = body.getLocalCenter()
    let isHeld = false, left = Infinity, right = -Infinity, footX = 0, footY = 0, count = 0
    for (let edge = body.getContactList(); edge; edge = edge.next) {
      if (!edge.contact.isTouching()) continue
      isHeld ||= this.#terrain.hit(edge.contact) !== null
      const { points = [], pointCount = 0 } = edge.contact.getWorldManifold(manifold) ?? {}
      for (const { x: px, y: py } of points.slice(0, pointCount)) {
        const aside = pull > 0 ? ((px - x) * -gy + (py - y) * gx) / pull : 0
        left = Math.min(left, aside)
        right = Math.max(right, aside)
        footX += px
        footY += py
        ++count
      }
    }
    if (!isHeld || pull === 0 || count === 0) return isHeld
    const radius = Math.sqrt(body.getInertia() / body.getMass() - local.x ** 2 - local.y ** 2)
    if (left < -narrow * radius && right > narrow * radius) return true
    const { angle, times } = this.#pushed.get(body) ?? { angle: Infinity, times: 0 }
    if (times >= mostPushes || Math.abs(body.getAngle() - angle) < 0.02) return true
    this.#pushed.set(body, { angle: body.getAngle(), times: times + 1 })
    const spin = push * Math.sqrt(pull / radius) * (left + right > 0 ? 1 : -1) // about its foot
    body.setAwake(true)
    body.setAngularVelocity(spin)
    body.setLinearVelocity({ x: -spin * (y - footY / count), y: spin * (x - footX / count) })
    return false
  }
}

class InPlanck implements Maker<Body> {
  readonly #physics: Physics
  readonly #options: FallingOptions

  constructor(physics: Physics, options: FallingOptions) {
    this.#physics = physics
    this.#options = options
  }

  get slop() { return Settings.linearSlop }
  get gap() { return 2 * Settings.polygonRadius } // both have a skin
  get gravity() { return this.#physics.getGravity() }
  keyOf(body: Body) { return body }

  make({ x, y, angle }: Lies, parts: readonly FallingPart[], { mass, center, inertia }: FallingMass): Body {
    const fixtures = parts.map(({ block, corners }) => ({
      shape: new Polygon(corners.map((corner) => new Vec2(corner.x, corner.y))),
      definition: { ...this.#options.material?.(block), density: 0 },
    }))
    const body = this.#physics.createBody({ type: 'dynamic', position: { x, y }, angle })
    for (const { shape, definition } of fixtures) body.createFixture(shape, definition)
    // planck wants it about the origin
    body.setMassData({ mass, center: new Vec2(center.x, center.y), I: inertia + mass * (center.x ** 2 + center.y ** 2) })
    return body
  }

  placeOf(body: Body): Lies { return { ...body.getPosition(), angle: body.getAngle() } }
  whole<T>(work: () => T): T { return whole(this.#physics, work) }
  destroy(body: Body): void { whole(this.#physics, () => this.#physics.destroyBody(body)) }
}
