// Terrain for planck: the outline of a world as static edges with ghost vertices, kept up to date there.
// Each segment is one fixture. It is on the body of its chunk of cells. docs/box2d.md describes the same for Box2D.
// planck's edges push to both sides. Here they are one-sided, as in Box2D: what comes from the solid's side passes.
import { type AABBValue, type Body, type Contact, EdgeShape, type Fixture, type Vec2Value, WorldManifold, type World as Physics } from 'planck'
import { isPhysics, PlanckBodies } from './planck-bodies.js'
import type { Material } from './planck-bodies.js'
import type { CommonOptions, EdgeChanges, Point } from './terrain.js'
import { type Adapter, TerrainBase } from './terrain-base.js'
import type { Hit, SegmentId, World } from './types.js'

export type { Material } from './planck-bodies.js'
export type { Overlap } from './bodies.js'
export type { OnOverlap } from './terrain.js'
export { cutOut } from './terrain-base.js'
export { FallingGround } from './planck-falling.js'
export type { Falling, FallingOptions } from './planck-falling.js'
export { Ground } from './planck-ground.js'
export type { GroundDrawing, GroundOptions, Rock, Shelf } from './ground-types.js'

export interface TerrainOptions extends CommonOptions<Material> {
  /** Without ghosts bodies bump at the seams. That is for comparison only: see PlanckTerrain.ghosts. */
  ghosts?: boolean
}

interface Chunk {
  readonly body: Body
  fixtures: number
}

/** What is known of an edge, by its number. */
interface Edge {
  readonly fixture: Fixture
  readonly chunk: number
  readonly segment: SegmentId
  /** From the corner of the chunk, in metres; null if there is none. */
  ghost1: Vec2Value | null
  ghost2: Vec2Value | null
}

/** It follows the world's commits from then on: give each one's changes to sync(). */
export class PlanckTerrain extends TerrainBase<Body, Material> {
  readonly #edges: Edges

  /** Puts in what was committed. */
  constructor(physics: Physics, world: World, options: TerrainOptions = {}) {
    isPhysics(physics)
    super(world, options, 0, ['ghosts'])
    this.#edges = new Edges(physics, this.frame, this.rules, options.ghosts ?? true)
    this.start(this.#edges)
  }

  get ghosts(): boolean { return this.#edges.ghosts }
  set ghosts(on: boolean) { this.#edges.ghosts = on }

  fixture(segment: SegmentId): Fixture | null { return this.#edges.at(this.rules.edgeOf(segment))?.fixture ?? null }

  /**
   * The segment of a fixture; 0 if the fixture is not of this terrain. Where segments are merged, the one nearest to a
   * point in metres, or without a point the first one.
   */
  segment(fixture: Fixture, point?: Point): SegmentId {
    const edge = this.#edges.of(fixture)
    if (edge === null) return 0
    return point ? this.rules.segmentAt(this.#edges.numberOf(fixture), this.point(point)) : edge.segment
  }

  /**
   * Which tile was hit? Null if what was hit is not of this terrain. Of a contact, at the centre of its points.
   * Of a fixture the point is as for segment().
   */
  hit(what: Fixture | Contact, point?: Point): Hit | null {
    const fixture = 'getFixtureA' in what ? this.#edges.touchedBy(what) : what
    if (fixture === null) return null
    const segment = this.segment(fixture, 'getFixtureA' in what ? this.#edges.middleOf(what, fixture) : point)
    return segment === 0 ? null : this.world.hit(segment)
  }
}

/** The edges in planck. */
class Edges extends PlanckBodies implements Adapter<Body, Material> {
  readonly #edges: (Edge | null)[] = []
  readonly #chunks: (Chunk | null)[] = []
  readonly #manifold = new WorldManifold()
  readonly #listener = (contact: Contact): void => this.#letPass(contact)
  #bodyCount = 0
  #ghosts: boolean

  constructor(physics: Physics, frame: PlanckBodies['frame'], rules: PlanckBodies['rules'], ghosts: boolean) {
    super(physics, frame, rules)
    this.#ghosts = ghosts
    physics.on('pre-solve', this.#listener)
  }

  at(edge: number): Edge | null { return this.#edges[edge] ?? null }

  of(fixture: Fixture): Edge | null {
    const number = fixture.getUserData()
    const edge = typeof number === 'number' ? this.#edges[number] : null
    return edge?.fixture === fixture ? edge : null
  }

  numberOf(fixture: Fixture): number { return fixture.getUserData() as number }

  touchedBy(contact: Contact): Fixture | null {
    return [contact.getFixtureA(), contact.getFixtureB()].find((fixture) => this.isOwn(fixture)) ?? null
  }

  /** Of its points; a sensor has none, and then that of what touches the edge. */
  middleOf(contact: Contact, edge: Fixture): Point {
    const count = contact.getManifold().pointCount
    const points = count > 0 ? contact.getWorldManifold(this.#manifold)!.points.slice(0, count)
      : [(contact.getFixtureA() === edge ? contact.getFixtureB() : contact.getFixtureA()).getAABB(0).getCenter()]
    const sum = points.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }), { x: 0, y: 0 })
    return { x: sum.x / points.length, y: sum.y / points.length }
  }

  override isOwn(fixture: Fixture): boolean { return this.of(fixture) !== null }
  isInStep(): boolean { return this.physics.isLocked() }
  isAlone(): boolean { return this.physics.getBodyCount() <= this.#bodyCount }

  get ghosts(): boolean { return this.#ghosts }
  set ghosts(on: boolean) {
    if (on === this.#ghosts) return
    this.#ghosts = on
    for (const edge of this.#edges) if (edge) this.#setGhosts(edge)
  }

  apply(changes: EdgeChanges): void {
    const { removed, added, length } = changes
    const left = new Set<number>()
    for (let k = 0; k < removed; ++k) left.add(this.#destroy(changes.removedId(k)))
    for (let k = 0; k < added; ++k) this.#create(changes, k)
    for (let k = added; k < length; ++k) {
      const edge = this.#edges[changes.id(k)]!
      this.#noteGhosts(edge, changes, k)
      this.#setGhosts(edge)
    }
    for (const number of left) if (this.#chunks[number]!.fixtures === 0) this.#destroyChunk(number)
    // planck itself wakes what touched a fixture that is destroyed.
    if (!this.isAlone()) this.#wakeAround(changes)
  }

  clear(): void {
    this.#chunks.forEach((chunk, number) => { if (chunk) this.#destroyChunk(number) })
    this.#edges.length = 0
    this.physics.off('pre-solve', this.#listener)
  }

  placeChunks(): void {
    this.#chunks.forEach((chunk, number) => chunk?.body.setTransform(this.#positionOf(number), 0))
  }

  // Switches a contact off that would push into the solid.
  #letPass(contact: Contact): void {
    const isA = this.isOwn(contact.getFixtureA())
    const fixture = isA ? contact.getFixtureA() : contact.getFixtureB()
    if (!isA && !this.isOwn(fixture)) return
    const { m_vertex1: start, m_vertex2: end } = fixture.getShape() as EdgeShape
    const { normal } = contact.getWorldManifold(this.#manifold)!
    const outward = (end.y - start.y) * normal.x - (end.x - start.x) * normal.y
    if (isA ? outward < 0 : outward > 0) contact.setEnabled(false)
  }

  #create(changes: EdgeChanges, k: number): void {
    const number = changes.chunk(k), chunk = this.#chunkAt(number)
    const { isPassable: _, ...material } = this.rules.materialOf(changes.block(k))
    const shape = new EdgeShape(this.#local(changes, k, 0), this.#local(changes, k, 2))
    const fixture = chunk.body.createFixture(shape, material)
    fixture.setUserData(changes.id(k))
    const edge = { fixture, chunk: number, segment: changes.segment(k), ghost1: null, ghost2: null }
    this.#edges[changes.id(k)] = edge
    this.#noteGhosts(edge, changes, k)
    this.#setGhosts(edge)
    ++chunk.fixtures
  }

  /** Returns the number of its chunk. */
  #destroy(id: number): number {
    const { fixture, chunk } = this.#edges[id]!
    fixture.getBody().destroyFixture(fixture)
    this.#edges[id] = null
    --this.#chunks[chunk]!.fixtures
    return chunk
  }

  #noteGhosts(edge: Edge, changes: EdgeChanges, k: number): void {
    edge.ghost1 = Number.isNaN(changes.at(k, 4)) ? null : this.#local(changes, k, 4)
    edge.ghost2 = Number.isNaN(changes.at(k, 6)) ? null : this.#local(changes, k, 6)
  }

  #setGhosts({ fixture, ghost1, ghost2 }: Edge): void {
    const shape = fixture.getShape() as EdgeShape
    shape.setPrevVertex((this.#ghosts && ghost1) || undefined)
    shape.setNextVertex((this.#ghosts && ghost2) || undefined)
  }

  // Relative to the body of the chunk. So vertices are as precise far from the origin as near it.
  #local(changes: EdgeChanges, k: number, n: number): Vec2Value {
    const { cellSize } = this.frame
    return { x: changes.at(k, n) * cellSize, y: changes.at(k, n + 1) * cellSize }
  }

  #chunkAt(number: number): Chunk {
    let chunk = this.#chunks[number]
    if (!chunk) {
      chunk = { body: this.physics.createBody({ type: 'static', position: this.#positionOf(number) }), fixtures: 0 }
      this.#chunks[number] = chunk
      ++this.#bodyCount
    }
    return chunk
  }

  #positionOf(chunk: number): Vec2Value { return this.metres(this.rules.cornerOf(chunk)) }

  #destroyChunk(number: number): void {
    this.physics.destroyBody(this.#chunks[number]!.body)
    this.#chunks[number] = null
    --this.#bodyCount
  }

  /** Those that are near one of the edges, if any body is near all of them. */
  #wakeAround(changes: EdgeChanges): void {
    const { length } = changes
    if (length === 0) return
    const all = { lowerBound: { x: Infinity, y: Infinity }, upperBound: { x: -Infinity, y: -Infinity } }
    const boxes: AABBValue[] = []
    for (let k = 0; k < length; ++k) {
      const box = this.#edges[changes.id(k)]!.fixture.getAABB(0), { lowerBound: a, upperBound: b } = box
      boxes.push(box)
      if (a.x < all.lowerBound.x) all.lowerBound.x = a.x
      if (a.y < all.lowerBound.y) all.lowerBound.y = a.y
      if (b.x > all.upperBound.x) all.upperBound.x = b.x
      if (b.y > all.upperBound.y) all.upperBound.y = b.y
    }
    let isSomebody = false
    this.physics.queryAABB(all, (near) => {
      isSomebody = !near.getBody().isStatic()
      return !isSomebody
    })
    if (!isSomebody) return
    for (const box of boxes)
      this.physics.queryAABB(box, (near) => {
        const body = near.getBody()
        if (!body.isStatic()) body.setAwake(true)
        return true
      })
  }
}
