// Ground that falls, as bodies of whichever physics engine. planck-falling.ts and box2d3-falling.ts say how these are
// made. lgs/box2d/falling.h does the same for Box2D in C++, by the same rules.
import { bad, object, options as known, within } from './check.js'
import { LgsError } from './error.js'
import { convexParts, massOf, placeIn } from './ground-body.js'
import type { GroundBody, GroundPolygon, IslandId } from './island-types.js'
import type { Islands } from './islands.js'
import type { Point } from './terrain.js'
import type { TerrainBase } from './terrain-base.js'
import type { Block } from './types.js'

export interface FallingOptions<Material> {
  /** Of a block, in kg per square metre: 0 or more; 1 if not given. */
  density?: (block: Block) => number
  /** What the shapes of a block are like; as in the physics engine if not given. Density has no effect here. */
  material?: (block: Block) => Material
}

/** A body, and the ground that it is. The body's origin is where the ground's origin was. */
export interface Falling<Body> {
  readonly body: Body
  readonly ground: GroundBody
}

/** Where a body's origin is, and its angle. */
export interface Lies extends Point {
  readonly angle: number
}

/** A convex polygon in metres from the body's origin. */
export interface FallingPart {
  readonly block: Block
  readonly corners: readonly Point[]
}

export interface FallingMass {
  readonly mass: number
  readonly center: Point
  /** About the centre. */
  readonly inertia: number
}

/** What the ground needs of a physics engine. Lengths are in metres. */
export interface Maker<Body> {
  /** A body of parts that are thinner gets no shape. */
  readonly slop: number
  /** What two shapes that rest on each other may be apart. */
  readonly gap: number
  readonly gravity: Point
  /** What distinguishes bodies. */
  keyOf(body: Body): unknown
  /** A dynamic body at rest; null if it would have no shape. */
  make(place: Lies, parts: readonly FallingPart[], mass: FallingMass): Body | null
  placeOf(body: Body): Lies
  destroy(body: Body): void
  /** Does work, all of it, even if a listener throws: that comes out at its end. */
  whole<T>(work: () => T): T
}

/** The ground of one world that falls. What it makes is yours to move; call forget() when you destroy a body. */
export abstract class FallingBase<Body, Material> {
  readonly #terrain: TerrainBase<Body, any>
  readonly #islands: Islands
  readonly #density: (block: Block) => number
  readonly #maker: Maker<Body>
  #waiting: GroundBody[] = []
  #made: Falling<Body>[] = [] // and not yet told
  readonly #bodies = new Map<unknown, Falling<Body>>()

  protected constructor(terrain: TerrainBase<Body, any>, islands: Islands, options: FallingOptions<Material>, maker: Maker<Body>) {
    this.#terrain = terrain
    this.#islands = islands
    const { density = () => 1, material } = known('options', ['density', 'material'], options)
    if (typeof density !== 'function') throw bad('density', 'a function', density)
    if (material !== undefined && typeof material !== 'function') throw bad('material', 'a function', material)
    this.#density = density
    this.#maker = maker
  }

  /**
   * Takes an island out of the ground: an edit. Its body is made by the next afterSync(). Refused as 'anchored' if
   * something holds it. An undo of that edit brings the ground back, and leaves the body where it is: destroy and
   * forget() it, or there is twice the matter.
   */
  takeAsBody(island: IslandId): void {
    if ((this.#islands.island(island)?.anchors ?? 0) > 0)
      throw new LgsError('anchored', 'this island is anchored: only what nothing holds can fall')
    this.#waiting.push(this.#islands.take(island))
  }

  /**
   * Call it after the sync of the commit that holds what was taken: so no body touches the ground that it was part of.
   * Makes the bodies, where their ground was and at rest. A part that is thinner than the slop of the physics engine gets
   * no shape, and ground without any gets no body. If density() or material() throws for some, the others are made all the
   * same: the next call tries these again, and returns all that are made then.
   */
  afterSync(): Falling<Body>[] {
    this.#maker.whole(() => this.#makeWaiting())
    const made = this.#made
    this.#made = []
    return made
  }
  #makeWaiting(): void {
    const waiting = this.#waiting, thrown: unknown[] = []
    this.#waiting = []
    for (const ground of waiting)
      try {
        const falling = this.make(ground)
        if (falling) this.#made.push(falling)
      } catch (error) {
        thrown.push(error)
        this.#waiting.push(ground)
      }
    if (thrown.length > 0) throw thrown[0]
  }

  /**
   * Makes the body of ground that left the world in another way, at a place in cells; where it was, if none is given.
   * Null if it would have no shape.
   */
  make(ground: GroundBody, place?: { x: number; y: number; angle: number }): Falling<Body> | null {
    this.#refuseInStep()
    object('ground', 'a body of ground', ground)
    const at = place === undefined ? { x: ground.i, y: ground.j, angle: 0 } : place
    const [x, y] = placeIn(at)
    const parts = this.#partsOf(ground), mass = this.#massOf(ground.polygons)
    if (parts.length === 0) return null
    return this.#maker.whole(() => {
      const body = this.#maker.make({ ...this.#terrain.position(x, y), angle: at.angle }, parts, mass)
      if (body === null) return null
      const falling = { body, ground }
      this.#terrain.moved(body)
      this.#bodies.set(this.#maker.keyOf(body), falling)
      return falling
    })
  }

  /** All bodies that there are. */
  get bodies(): Falling<Body>[] { return [...this.#bodies.values()] }

  /** Where a body lies, in cells: the place for make(). */
  placeOf(body: Body): { x: number; y: number; angle: number } {
    const place = this.#maker.placeOf(body)
    return { ...this.#terrain.point(place), angle: place.angle }
  }

  /**
   * Puts a body back into the ground as it lies: an edit, to be committed and synced as any other. Its vertices are
   * rounded to the lattice. It is let down by the gap that the physics engine leaves below what rests, and a slop, so that
   * it is one island with what it rests on; what is ground already stays. Then the body is destroyed. False, and nothing
   * has changed, where the ground reaches into it by more than two slops. Otherwise it is refused as a brush is.
   */
  settle(body: Body): boolean {
    this.#refuseInStep()
    const falling = this.#bodies.get(this.#maker.keyOf(body))
    if (!falling) throw bad('body', 'one of bodies', body)
    const down = this.#down, { slop, gap } = this.#maker, { x, y, angle } = this.#maker.placeOf(body)
    if (!this.#terrain.fits(body, { x: x - down.x * slop, y: y - down.y * slop, angle })) return false
    const depth = gap + slop
    const at = this.#terrain.point({ x: x + down.x * depth, y: y + down.y * depth })
    this.#islands.putAsItLies(falling.ground, { ...at, angle })
    this.forget(body)
    this.#maker.destroy(body)
    return true
  }

  /** Takes a body of yours that is made of ground: one that was forgotten, say. From here on it can be settled. */
  add(body: Body, ground: GroundBody): void {
    object('ground', 'a body of ground', ground)
    this.#bodies.set(this.#maker.keyOf(body), { body, ground })
  }
  /** For a body that you destroy yourself, or keep for yourself: add() takes it back. */
  forget(body: Body): void { this.#bodies.delete(this.#maker.keyOf(body)) }

  #refuseInStep(): void {
    if (this.#terrain.isInStep) throw new LgsError('busy', 'the physics world is in a step: change bodies after it')
  }

  /** Of one step down, as gravity pulls; where there is none it is zero. */
  get #down(): Point {
    const { x, y } = this.#maker.gravity, length = Math.hypot(x, y)
    return length > 0 ? { x: x / length, y: y / length } : { x: 0, y: 0 }
  }

  /** Those that are wide enough: the physics engine would refuse others, or make them wider. */
  #partsOf(ground: GroundBody): FallingPart[] {
    const { cellSize } = this.#terrain
    return convexParts(ground)
      .map(({ block, vertices }) => {
        const corners: Point[] = []
        for (let k = 0; k < vertices.length; k += 2) corners.push({ x: vertices[k]! * cellSize, y: vertices[k + 1]! * cellSize })
        return { block, corners }
      })
      .filter(({ corners }) => widthOf(corners) > 1.1 * this.#maker.slop)
  }

  /** Of all polygons, each with the density of its block. What is too thin for a shape counts, too. */
  #massOf(polygons: readonly GroundPolygon[]): FallingMass {
    const { cellSize } = this.#terrain, squareCell = cellSize * cellSize
    let all = 0, x = 0, y = 0, inertia = 0 // about the origin
    for (const block of new Set(polygons.map((polygon) => polygon.block))) {
      const density = within('a density', this.#density(block), 0, Number.MAX_VALUE)
      const mass = massOf(polygons.filter((polygon) => polygon.block === block))
      const weight = density * mass.area * squareCell, cx = mass.x * cellSize, cy = mass.y * cellSize
      all += weight
      x += weight * cx
      y += weight * cy
      inertia += density * mass.secondMoment * squareCell * squareCell + weight * (cx * cx + cy * cy)
    }
    const center = all > 0 ? { x: x / all, y: y / all } : { x: 0, y: 0 }
    return { mass: all, center, inertia: inertia - all * (center.x * center.x + center.y * center.y) }
  }
}

/** The least distance between two parallel lines that hold a convex polygon between them. */
function widthOf(corners: readonly Point[]): number {
  let width = Infinity
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length]!, dx = b.x - a.x, dy = b.y - a.y
    const reach = Math.max(...corners.map((p) => dx * (p.y - a.y) - dy * (p.x - a.x)))
    width = Math.min(width, reach / Math.hypot(dx, dy))
  })
  return width
}
