// Terrain for planck: the outline of a world as static edges with ghost vertices, kept up to date there.
// Each segment is one fixture. It is on the body of its chunk of cells. docs/box2d.md tells the same story for Box2D.
// planck's edges push to both sides. Here they are one-sided, as in Box2D: what comes from the solid's side passes.
import {
  type Body,
  type Contact,
  EdgeShape,
  type Fixture,
  type FixtureOpt,
  type Vec2Value,
  WorldManifold,
  type World as Physics,
} from 'planck'
import type { Block, Changes, Hit, SegmentId, SegmentList, World } from './types.js'

export type Material = Pick<
  FixtureOpt,
  'friction' | 'restitution' | 'filterCategoryBits' | 'filterMaskBits' | 'filterGroupIndex'
>

export interface TerrainOptions {
  /** The side of a cell in metres; 1 if not given. */
  cellSize?: number
  /** The cell whose lower left corner is (0, 0) of the physics world. */
  origin?: { readonly i: number; readonly j: number }
  /** Cells along the side of a chunk; 16 if not given. */
  chunkCells?: number
  /** Asked once for each block. */
  material?: (block: Block) => Material
  /** Without ghosts bodies bump at the seams. That is for comparison only: see PlanckTerrain.ghosts. */
  ghosts?: boolean
}

interface Chunk {
  readonly body: Body
  /** Its lower left corner, in cells. */
  readonly x: number
  readonly y: number
  fixtures: number
}

export class PlanckTerrain {
  readonly cellSize: number
  readonly #physics: Physics
  readonly #world: World
  readonly #origin: { readonly i: number; readonly j: number }
  readonly #chunkCells: number
  readonly #material: (block: Block) => Material
  readonly #materials = new Map<Block, Material>()
  readonly #chunks = new Map<string, Chunk>()
  readonly #chunkOf = new Map<Body, Chunk>()
  readonly #fixtures: (Fixture | null)[] = [] // by segment id
  readonly #manifold = new WorldManifold()
  readonly #listener = (contact: Contact): void => this.#letPass(contact)
  #ghosts: boolean
  #version: bigint

  /** Puts in what was committed. From then on give each commit's changes to sync(). */
  constructor(physics: Physics, world: World, options: TerrainOptions = {}) {
    this.cellSize = options.cellSize ?? 1
    this.#physics = physics
    this.#world = world
    this.#origin = options.origin ?? { i: 0, j: 0 }
    this.#chunkCells = options.chunkCells ?? 16
    this.#material = options.material ?? (() => ({}))
    this.#ghosts = options.ghosts ?? true
    this.#version = world.version
    this.#create(world.segments())
    physics.on('pre-solve', this.#listener)
  }

  /** What a commit or a roll-back did, each once and in order. Not during a step of the physics world. */
  sync(changes: Changes): void {
    if (changes.before === changes.after) return
    if (changes.before !== this.#version) {
      throw new Error('these changes do not follow those that the terrain shows: call resync()')
    }
    this.#version = changes.after
    const left = new Set<Chunk>()
    for (const id of changes.removed.slice()) left.add(this.#destroy(id)) // listeners of contacts may use the package
    this.#create(changes.added)
    this.#relink(changes.relinked)
    for (const chunk of left) if (chunk.fixtures === 0) this.#destroyChunk(chunk)
    // planck itself wakes what touched a fixture that is destroyed.
    for (const id of changes.added.id) this.#wakeAround(id)
    for (const id of changes.relinked.id) this.#wakeAround(id)
  }

  /** Makes everything anew, after changes were left out. */
  resync(): void {
    this.#clear()
    this.#version = this.#world.version
    this.#create(this.#world.segments())
  }

  /** Takes everything out of the physics world. */
  destroy(): void {
    this.#clear()
    this.#version = -1n
    this.#physics.off('pre-solve', this.#listener)
  }

  get ghosts(): boolean {
    return this.#ghosts
  }

  set ghosts(on: boolean) {
    if (on === this.#ghosts) return
    this.#ghosts = on
    this.#relink(this.#world.segments())
  }

  fixture(segment: SegmentId): Fixture | null {
    return this.#fixtures[segment] ?? null
  }

  /** The segment of a fixture; 0 if the fixture is not of this terrain. */
  segment(fixture: Fixture): SegmentId {
    const id = fixture.getUserData()
    return typeof id === 'number' && this.#fixtures[id] === fixture ? id : 0
  }

  /** Which tile was hit? Null if the fixture is not of this terrain. */
  hit(fixture: Fixture): Hit | null {
    const segment = this.segment(fixture)
    return segment === 0 ? null : this.#world.hit(segment)
  }

  /** From cells of the world to metres of the physics world, and back. */
  position(x: number, y: number): Vec2Value {
    return { x: (x - this.#origin.i) * this.cellSize, y: (y - this.#origin.j) * this.cellSize }
  }

  point(position: Vec2Value): Vec2Value {
    return { x: position.x / this.cellSize + this.#origin.i, y: position.y / this.cellSize + this.#origin.j }
  }

  // Switches a contact off that would push into the solid.
  #letPass(contact: Contact): void {
    const isA = this.segment(contact.getFixtureA()) !== 0
    const fixture = isA ? contact.getFixtureA() : contact.getFixtureB()
    if (!isA && this.segment(fixture) === 0) return
    const { m_vertex1: start, m_vertex2: end } = fixture.getShape() as EdgeShape
    const { normal } = contact.getWorldManifold(this.#manifold)!
    const outward = (end.y - start.y) * normal.x - (end.x - start.x) * normal.y
    if (isA ? outward < 0 : outward > 0) contact.setEnabled(false)
  }

  #create(segments: SegmentList): void {
    // First, since a callback that makes the memory of WebAssembly grow empties the arrays.
    for (const block of new Set(segments.block)) this.#materialOf(block)
    const { id, geometry, block, cell } = segments
    for (let k = 0; k < id.length; ++k) {
      const chunk = this.#chunkAt(cell[2 * k]!, cell[2 * k + 1]!)
      const shape = new EdgeShape(this.#local(chunk, geometry, 8 * k), this.#local(chunk, geometry, 8 * k + 2))
      this.#setGhosts(shape, chunk, geometry, 8 * k)
      const fixture = chunk.body.createFixture(shape, this.#materialOf(block[k]!))
      fixture.setUserData(id[k])
      this.#fixtures[id[k]!] = fixture
      ++chunk.fixtures
    }
  }

  #relink(segments: SegmentList): void {
    const { id, geometry } = segments
    for (let k = 0; k < id.length; ++k) {
      const fixture = this.#fixtures[id[k]!]!
      const chunk = this.#chunkOf.get(fixture.getBody())!
      this.#setGhosts(fixture.getShape() as EdgeShape, chunk, geometry, 8 * k)
    }
  }

  #destroy(id: SegmentId): Chunk {
    const fixture = this.#fixtures[id]!
    const chunk = this.#chunkOf.get(fixture.getBody())!
    chunk.body.destroyFixture(fixture)
    this.#fixtures[id] = null
    --chunk.fixtures
    return chunk
  }

  #destroyChunk(chunk: Chunk): void {
    this.#physics.destroyBody(chunk.body)
    this.#chunks.delete(`${chunk.x} ${chunk.y}`)
    this.#chunkOf.delete(chunk.body)
  }

  #clear(): void {
    for (const chunk of this.#chunks.values()) this.#destroyChunk(chunk)
    this.#fixtures.length = 0
  }

  #setGhosts(shape: EdgeShape, chunk: Chunk, geometry: ArrayLike<number>, at: number): void {
    shape.setPrevVertex(this.#ghost(chunk, geometry, at + 4))
    shape.setNextVertex(this.#ghost(chunk, geometry, at + 6))
  }

  #ghost(chunk: Chunk, geometry: ArrayLike<number>, at: number): Vec2Value | undefined {
    return this.#ghosts && !Number.isNaN(geometry[at]!) ? this.#local(chunk, geometry, at) : undefined
  }

  // Relative to the body of the chunk. So vertices are as precise far from the origin as near it.
  #local(chunk: Chunk, geometry: ArrayLike<number>, at: number): Vec2Value {
    return { x: (geometry[at]! - chunk.x) * this.cellSize, y: (geometry[at + 1]! - chunk.y) * this.cellSize }
  }

  #chunkAt(i: number, j: number): Chunk {
    const x = Math.floor(i / this.#chunkCells) * this.#chunkCells
    const y = Math.floor(j / this.#chunkCells) * this.#chunkCells
    const key = `${x} ${y}`
    let chunk = this.#chunks.get(key)
    if (chunk === undefined) {
      const body = this.#physics.createBody({ type: 'static', position: this.position(x, y) })
      chunk = { body, x, y, fixtures: 0 }
      this.#chunks.set(key, chunk)
      this.#chunkOf.set(body, chunk)
    }
    return chunk
  }

  #materialOf(block: Block): Material {
    let material = this.#materials.get(block)
    if (material === undefined) {
      material = this.#material(block)
      this.#materials.set(block, material)
    }
    return material
  }

  #wakeAround(id: SegmentId): void {
    this.#physics.queryAABB(this.#fixtures[id]!.getAABB(0), (near) => {
      const body = near.getBody()
      if (!body.isStatic()) body.setAwake(true)
      return true
    })
  }
}
