// Ground that falls, as bodies of planck. lgs/box2d/falling.h does the same for Box2D, by the same rules.
import { type Body, type FixtureOpt, Polygon, Settings, Vec2, type Vec2Value, type World as Physics } from 'planck'
import { bad, object, within } from './check.js'
import { LgsError } from './error.js'
import { convexParts, massOf, placeIn } from './ground-body.js'
import type { GroundBody, GroundPolygon, IslandId } from './island-types.js'
import type { Islands } from './islands.js'
import type { PlanckTerrain } from './planck.js'
import type { Block } from './types.js'

export interface FallingOptions {
  /** Of a block, in kg per square metre: 0 or more; 1 if not given. */
  density?: (block: Block) => number
  /** What the fixtures of a block are like; planck's defaults if not given. Density has no effect here. */
  material?: (block: Block) => FixtureOpt
}

/** A body, and the ground that it is. The body's origin is where the ground's origin was. */
export interface Falling {
  readonly body: Body
  readonly ground: GroundBody
}

/** The ground of one world that falls. What it makes is yours to move; who destroys a body calls forget(). */
export class FallingGround {
  readonly #physics: Physics
  readonly #terrain: PlanckTerrain
  readonly #islands: Islands
  readonly #options: FallingOptions
  readonly #waiting: GroundBody[] = []
  readonly #bodies = new Map<Body, GroundBody>()

  constructor(physics: Physics, terrain: PlanckTerrain, islands: Islands, options: FallingOptions = {}) {
    this.#physics = physics
    this.#terrain = terrain
    this.#islands = islands
    this.#options = options
  }

  /** Takes an island out of the ground: an edit. Its body is made by the next afterSync(). */
  takeAsBody(island: IslandId): void { this.#waiting.push(this.#islands.take(island)) }

  /**
   * Call it after the sync of the commit that holds what was taken: so no body touches the ground that it was part of.
   * Makes the bodies, where their ground was and at rest. A part that is thinner than planck's slop gets no fixture, and
   * ground without any gets no body.
   */
  afterSync(): Falling[] {
    const made: Falling[] = []
    for (let ground = this.#waiting[0]; ground; ground = this.#waiting[0]) {
      const falling = this.make(ground)
      if (falling) made.push(falling)
      this.#waiting.shift()
    }
    return made
  }

  /**
   * Makes the body of ground that left the world in another way, at a place in cells; where it was, if none is given.
   * Null if it would have no fixture.
   */
  make(ground: GroundBody, place?: { x: number; y: number; angle: number }): Falling | null {
    this.#refuseInStep()
    object('ground', 'a body of ground', ground)
    const at = place === undefined ? { x: ground.i, y: ground.j, angle: 0 } : place
    const [x, y] = placeIn(at)
    const fixtures = this.#shapesOf(ground).map(({ shape, block }) =>
      ({ shape, definition: { ...this.#options.material?.(block), density: 0 } }))
    if (fixtures.length === 0) return null
    const mass = this.#massOf(ground.polygons), position = this.#terrain.position(x, y)
    const body = this.#physics.createBody({ type: 'dynamic', position, angle: at.angle })
    for (const { shape, definition } of fixtures) body.createFixture(shape, definition)
    body.setMassData(mass)
    this.#bodies.set(body, ground)
    return { body, ground }
  }

  /** All bodies that there are. */
  get bodies(): Falling[] { return Array.from(this.#bodies, ([body, ground]) => ({ body, ground })) }

  /** Where a body lies, in cells: the place for make(). */
  placeOf(body: Body): { x: number; y: number; angle: number } {
    return { ...this.#terrain.point(body.getPosition()), angle: body.getAngle() }
  }

  /**
   * Puts a body back into the ground as it lies: an edit, to be committed and synced as any other. Its vertices are
   * rounded to the lattice. It is let down by the gap that planck leaves below what rests, and a slop, so that it is one
   * island with what it rests on; what is ground already stays. Then the body is destroyed. False, and nothing has
   * changed, where the ground reaches into it by more than two slops. Otherwise it is refused as a brush is.
   */
  settle(body: Body): boolean {
    this.#refuseInStep()
    const ground = this.#bodies.get(body)
    if (!ground) throw bad('body', 'one of bodies', body)
    const down = this.#down, slop = Settings.linearSlop, { x, y } = body.getPosition(), angle = body.getAngle()
    if (!this.#terrain.fits(body, { x: x - down.x * slop, y: y - down.y * slop, angle })) return false
    const depth = 2 * Settings.polygonRadius + slop  // both have a skin
    const at = this.#terrain.point({ x: x + down.x * depth, y: y + down.y * depth })
    this.#islands.putAsItLies(ground, { ...at, angle })
    this.#bodies.delete(body)
    this.#physics.destroyBody(body)
    return true
  }

  /** For a body that you destroy yourself, or keep for yourself. */
  forget(body: Body): void { this.#bodies.delete(body) }

  #refuseInStep(): void {
    if (this.#physics.isLocked()) throw new LgsError('busy', 'the physics world is in a step: change bodies after it')
  }

  /** Of one step down, as gravity pulls; where there is none it is zero. */
  get #down(): Vec2Value {
    const { x, y } = this.#physics.getGravity(), length = Math.hypot(x, y)
    return length > 0 ? { x: x / length, y: y / length } : { x: 0, y: 0 }
  }

  /** Of the parts that are wide enough: planck would make a box of a square metre of others. */
  #shapesOf(ground: GroundBody): { shape: Polygon; block: Block }[] {
    const { cellSize } = this.#terrain
    return convexParts(ground)
      .map(({ block, vertices }) => {
        const corners: Vec2[] = []
        for (let k = 0; k < vertices.length; k += 2)
          corners.push(new Vec2(vertices[k]! * cellSize, vertices[k + 1]! * cellSize))
        return { block, corners }
      })
      .filter(({ corners }) => widthOf(corners) > 1.1 * Settings.linearSlop)
      .map(({ block, corners }) => ({ block, shape: new Polygon(corners) }))
  }

  /** Of all polygons, each with the density of its block. What is too thin for a fixture counts, too. */
  #massOf(polygons: readonly GroundPolygon[]) {
    const { cellSize } = this.#terrain, squareCell = cellSize * cellSize
    let all = 0, x = 0, y = 0, inertia = 0 // about the origin
    for (const block of new Set(polygons.map((polygon) => polygon.block))) {
      const density = within('a density', this.#options.density?.(block) ?? 1, 0, Number.MAX_VALUE)
      const mass = massOf(polygons.filter((polygon) => polygon.block === block))
      const weight = density * mass.area * squareCell, cx = mass.x * cellSize, cy = mass.y * cellSize
      all += weight
      x += weight * cx
      y += weight * cy
      inertia += density * mass.secondMoment * squareCell * squareCell + weight * (cx * cx + cy * cy)
    }
    return { mass: all, center: all > 0 ? new Vec2(x / all, y / all) : new Vec2(), I: inertia }
  }
}

/** The least distance between two parallel lines that hold a convex polygon between them. */
function widthOf(corners: readonly Vec2Value[]): number {
  let width = Infinity
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length]!, dx = b.x - a.x, dy = b.y - a.y
    const reach = Math.max(...corners.map((p) => dx * (p.y - a.y) - dy * (p.x - a.x)))
    width = Math.min(width, reach / Math.hypot(dx, dy))
  })
  return width
}
