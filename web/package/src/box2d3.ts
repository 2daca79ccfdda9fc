// Terrain for box2d3-wasm: the outline of a world as one-sided edges with ghost vertices, kept up to date there.
// Each segment is an open chain of four points: ghost1, start, end, ghost2. Of these Box2D makes one edge. It is on the
// body of its chunk of cells. A chain cannot be changed, so one that gets another ghost is made anew.
//
// Box2D cannot use edges as short as its linear slop. Such segments are left out, and the ghosts of the edges beside them
// are on the other side of the gap. Several short segments in a row leave a gap as long as the row.
import type { Block, Changes, Hit, SegmentId, World } from './types.js'

/** A world of Box2D. */
export interface PhysicsId {
  readonly index1: number
  readonly generation: number
}
/** A body, shape or chain of Box2D. */
export interface ObjectId extends PhysicsId {
  readonly world0: number
}
export interface Vec2 {
  x: number
  y: number
}
interface Handle {
  delete(): void
}
interface Box extends Handle {
  lowerBound: Vec2
  upperBound: Vec2
}
interface ChainDef extends Handle {
  isLoop: boolean
  readonly filter: { categoryBits: number; maskBits: number; groupIndex: number }
  SetPoints(points: readonly Vec2[]): void
}

/** What the terrain uses of the module that box2d3-wasm makes. */
export interface Box2D {
  b2Vec2: new (x: number, y: number) => Vec2 & Handle
  b2DefaultBodyDef(): { position: Vec2 } & Handle
  b2DefaultChainDef(): ChainDef
  b2DefaultQueryFilter(): Handle
  // The types of box2d3-wasm call its structs by names of their own, so here they are `any`.
  b2CreateBody(physics: PhysicsId, def: any): ObjectId
  b2DestroyBody(body: ObjectId): void
  b2Body_SetAwake(body: ObjectId, awake: boolean): void
  b2CreateChain(body: ObjectId, def: any): ObjectId
  b2DestroyChain(chain: ObjectId): void
  b2Chain_GetSegments(chain: ObjectId, capacity: number): ObjectId[]
  b2Shape_SetFriction(shape: ObjectId, friction: number): void
  b2Shape_SetRestitution(shape: ObjectId, restitution: number): void
  b2Shape_GetAABB(shape: ObjectId): Box
  b2Shape_GetBody(shape: ObjectId): ObjectId
  b2World_OverlapAABB(
    physics: PhysicsId, box: any, filter: any, found: (result: { readonly shapeId: ObjectId }) => boolean): unknown
}

/** What is not given is as in Box2D. */
export interface Material {
  friction?: number
  restitution?: number
  categoryBits?: number
  maskBits?: number
  groupIndex?: number
}

export interface TerrainOptions {
  /** The side of a cell in metres; 1 if not given. */
  cellSize?: number
  /** The cell whose lower left corner is (0, 0) of the physics world. */
  origin?: { readonly i: number; readonly j: number }
  /** Cells along the side of a chunk; 16 if not given. */
  chunkCells?: number
  /** Asked once for each block. */
  material?: (block: Block) => Material
}

interface Edge {
  readonly segment: SegmentId
  readonly chain: ObjectId
  readonly shape: ObjectId
}

interface Chunk {
  readonly body: ObjectId
  /** Its lower left corner, in cells. */
  readonly x: number
  readonly y: number
}

type Point = readonly [number, number]

/** In metres: the linear slop of Box2D and a tenth more, for rounding. What is shorter is left out. */
const least = 0.0055

export class Box2dTerrain {
  readonly cellSize: number
  readonly #box2d: Box2D
  readonly #physics: PhysicsId
  readonly #world: World
  readonly #origin: { readonly i: number; readonly j: number }
  readonly #chunkCells: number
  readonly #material: (block: Block) => Material
  readonly #materials = new Map<Block, Material>()
  readonly #chunks = new Map<string, Chunk>()
  readonly #edges = new Map<SegmentId, Edge>()
  readonly #edgeOf = new Map<number, Edge>() // by the index of its shape
  #version: bigint

  /** `box2d` is the module, `physics` a world of it. Puts in what was committed. Then sync() each commit's changes. */
  constructor(box2d: Box2D, physics: PhysicsId, world: World, options: TerrainOptions = {}) {
    this.cellSize = options.cellSize ?? 1
    this.#box2d = box2d
    this.#physics = physics
    this.#world = world
    this.#origin = options.origin ?? { i: 0, j: 0 }
    this.#chunkCells = options.chunkCells ?? 16
    this.#material = options.material ?? (() => ({}))
    this.#version = world.version
    this.#create([...world.segments().id])
  }

  /** What a commit or a roll-back did, each once and in order. Not during a step of the physics world. */
  sync(changes: Changes): void {
    if (changes.before === changes.after) return
    if (changes.before !== this.#version) {
      throw new Error('these changes do not follow those that the terrain shows: call resync()')
    }
    this.#version = changes.after
    const anew = this.#withThoseBeyondGaps([...changes.added.id, ...changes.relinked.id])
    // Box2D itself wakes what touched a chain that is destroyed.
    for (const id of changes.removed) this.#destroy(id)
    for (const id of anew) this.#destroy(id)
    this.#create(anew)
    this.#wakeAround(anew)
  }

  /** Makes everything anew, after changes were left out. */
  resync(): void {
    this.#clear()
    this.#version = this.#world.version
    this.#create([...this.#world.segments().id])
  }

  /** Takes everything out of the physics world. */
  destroy(): void {
    this.#clear()
    this.#version = -1n
  }

  /** The shape of a segment; null if the segment is left out. */
  shape(segment: SegmentId): ObjectId | null {
    return this.#edges.get(segment)?.shape ?? null
  }

  /** The segment of a shape; 0 if the shape is not of this terrain. */
  segment(shape: ObjectId): SegmentId {
    const edge = this.#edgeOf.get(shape.index1)
    const isSame = edge?.shape.generation === shape.generation && edge.shape.world0 === shape.world0
    return isSame ? edge.segment : 0
  }

  /** Which tile was hit? Null if the shape is not of this terrain. */
  hit(shape: ObjectId): Hit | null {
    const segment = this.segment(shape)
    return segment === 0 ? null : this.#world.hit(segment)
  }

  /** From cells of the world to metres of the physics world, and back. */
  position(x: number, y: number): Vec2 {
    return { x: (x - this.#origin.i) * this.cellSize, y: (y - this.#origin.j) * this.cellSize }
  }
  point(position: Vec2): Vec2 {
    return { x: position.x / this.cellSize + this.#origin.i, y: position.y / this.cellSize + this.#origin.j }
  }

  #create(segments: Iterable<SegmentId>): void {
    const box2d = this.#box2d
    const def = box2d.b2DefaultChainDef()
    const points = [0, 1, 2, 3].map(() => new box2d.b2Vec2(0, 0))
    for (const id of segments) {
      const { start, end, block, i, j } = this.#world.segment(id)
      if (this.#isShort(start, end)) continue
      const chunk = this.#chunkAt(i, j)
      const chainOfFour = [this.#ghost(id, 'predecessor'), start, end, this.#ghost(id, 'successor')] as const
      chainOfFour.forEach(([x, y], k) => {
        // Relative to the body of the chunk. So vertices are as precise far from the origin as near it.
        points[k]!.x = (x - chunk.x) * this.cellSize
        points[k]!.y = (y - chunk.y) * this.cellSize
      })
      def.SetPoints(points)
      const { friction = 0.6, restitution = 0, categoryBits = 1, maskBits = 0xffffffff, groupIndex = 0 } =
        this.#materialOf(block)
      Object.assign(def.filter, { categoryBits, maskBits, groupIndex })
      const chain = box2d.b2CreateChain(chunk.body, def)
      const shape = box2d.b2Chain_GetSegments(chain, 1)[0]!
      // In box2d3-wasm 5.2 the materials of a chain's definition are not those of its segments.
      box2d.b2Shape_SetFriction(shape, friction)
      box2d.b2Shape_SetRestitution(shape, restitution)
      const edge = { segment: id, chain, shape }
      this.#edges.set(id, edge)
      this.#edgeOf.set(shape.index1, edge)
    }
    for (const handle of [def, ...points]) handle.delete()
  }

  #destroy(id: SegmentId): void {
    const edge = this.#edges.get(id)
    if (edge === undefined) return
    this.#box2d.b2DestroyChain(edge.chain)
    this.#edges.delete(id)
    this.#edgeOf.delete(edge.shape.index1)
  }

  #clear(): void {
    for (const { body } of this.#chunks.values()) this.#box2d.b2DestroyBody(body)
    this.#chunks.clear()
    this.#edges.clear()
    this.#edgeOf.clear()
  }

  #isShort(a: Point, b: Point): boolean {
    return Math.hypot(b[0] - a[0], b[1] - a[1]) * this.cellSize < least
  }

  /** The first point of the outline before or after a segment that is far enough from it; else one straight ahead. */
  #ghost(id: SegmentId, way: 'predecessor' | 'successor'): Point {
    const segment = this.#world.segment(id)
    const [from, to] = way === 'successor' ? [segment.start, segment.end] : [segment.end, segment.start]
    for (let next = segment[way]; next !== 0 && next !== id; ) {
      const { start, end, [way]: beyond } = this.#world.segment(next)
      const point = way === 'successor' ? end : start
      if (!this.#isShort(to, point)) return point
      next = beyond
    }
    return [2 * to[0] - from[0], 2 * to[1] - from[1]]
  }

  /** And the segments that have a short one of these beside them: their ghosts are beyond it. */
  #withThoseBeyondGaps(ids: readonly SegmentId[]): Set<SegmentId> {
    const all = new Set(ids)
    for (const id of ids) {
      for (const way of ['predecessor', 'successor'] as const) {
        let segment = this.#world.segment(id)
        while (this.#isShort(segment.start, segment.end) && segment[way] !== 0 && segment[way] !== id) {
          segment = this.#world.segment(segment[way])
        }
        all.add(segment.id)
      }
    }
    return all
  }

  #chunkAt(i: number, j: number): Chunk {
    const x = Math.floor(i / this.#chunkCells) * this.#chunkCells
    const y = Math.floor(j / this.#chunkCells) * this.#chunkCells
    const key = `${x} ${y}`
    let chunk = this.#chunks.get(key)
    if (chunk === undefined) {
      const def = this.#box2d.b2DefaultBodyDef()
      Object.assign(def.position, this.position(x, y))
      chunk = { body: this.#box2d.b2CreateBody(this.#physics, def), x, y }
      def.delete()
      this.#chunks.set(key, chunk)
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

  #wakeAround(segments: Iterable<SegmentId>): void {
    const box2d = this.#box2d
    const filter = box2d.b2DefaultQueryFilter()
    const near: ObjectId[] = []
    for (const id of segments) {
      const shape = this.shape(id)
      if (shape === null) continue
      const box = box2d.b2Shape_GetAABB(shape)
      box2d.b2World_OverlapAABB(this.#physics, box, filter, ({ shapeId }) => {
        if (this.segment(shapeId) === 0) near.push(shapeId)
        return true
      })
      box.delete()
    }
    filter.delete()
    for (const shape of near) box2d.b2Body_SetAwake(box2d.b2Shape_GetBody(shape), true)
  }
}
