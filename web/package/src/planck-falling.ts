// Ground that falls, as bodies of planck.
import { type Body, type FixtureOpt, Polygon, Settings, Vec2, type World as Physics } from 'planck'
import { type Falling as FallingOf, FallingBase, type FallingMass, type FallingOptions as OptionsOf, type FallingPart, type Lies, type Maker } from './falling-base.js'
import type { Islands } from './islands.js'
import { isPhysics } from './planck-bodies.js'
import type { PlanckTerrain } from './planck.js'

export type FallingOptions = OptionsOf<FixtureOpt>
export type Falling = FallingOf<Body>

export class FallingGround extends FallingBase<Body, FixtureOpt> {
  constructor(physics: Physics, terrain: PlanckTerrain, islands: Islands, options: FallingOptions = {}) {
    isPhysics(physics)
    super(terrain, islands, options, new InPlanck(physics, options))
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
  destroy(body: Body): void { this.#physics.destroyBody(body) }
}
