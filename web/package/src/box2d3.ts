// Terrain for box2d3-wasm: the outline of a world as one-sided edges with ghost vertices, kept up to date there.
// Each edge is an open chain of four points: ghost1, start, end, ghost2. Of these Box2D makes one edge. It is on the body
// of its chunk of cells. A chain cannot be changed, so one that gets another ghost is made again.
//
// Box2D cannot use edges as short as its linear slop. Which short segments are welded into one edge, and which are left
// out, is decided in C++; docs/box2d.md describes it.
import { Box2dBodies, idOf } from './box2d3-bodies.js'
import type { Box2D, Material, ObjectId, PhysicsId } from './box2d3-bodies.js'
import type { CommonOptions, EdgeChanges, Point } from './terrain.js'
import { type Adapter, TerrainBase } from './terrain-base.js'
import type { Hit, SegmentId, World } from './types.js'

export type { Box2D, Material, ObjectId, PhysicsId, Vec2 } from './box2d3-bodies.js'
export type { Overlap } from './bodies.js'
export type { OnOverlap } from './terrain.js'
export { cutOut } from './terrain-base.js'
export { FallingGround } from './box2d3-falling.js'
export type { Falling, FallingOptions } from './box2d3-falling.js'

export interface TerrainOptions extends CommonOptions<Material> {}

interface Edge {
  readonly id: number
  readonly segment: SegmentId
  readonly shape: ObjectId
  readonly chain: ObjectId
  readonly chunk: number
}

interface Chunk {
  readonly body: ObjectId
  edges: number
}

/** In metres: the linear slop of Box2D and a tenth more, for rounding. */
const shortest = 0.0055

/** It follows the world's commits from then on: give each one's changes to sync(). */
export class Box2dTerrain extends TerrainBase<ObjectId, Material> {
  readonly #edges: Edges

  /** `box2d` is the module, `physics` a world of it. Puts in what was committed. */
  constructor(box2d: Box2D, physics: PhysicsId, world: World, options: TerrainOptions = {}) {
    super(world, options, shortest)
    this.#edges = new Edges(box2d, physics, this.frame, this.rules)
    this.start(this.#edges)
  }

  /** The shape of a segment; null if the segment is left out. */
  shape(segment: SegmentId): ObjectId | null { return this.#edges.at(this.rules.edgeOf(segment))?.shape ?? null }

  /**
   * The segment of a shape; 0 if the shape is not of this terrain. Short segments may be welded: then the one nearest to
   * a point in metres, or without a point the first one.
   */
  segment(shape: ObjectId, point?: Point): SegmentId {
    const edge = this.#edges.of(shape)
    if (edge === null) return 0
    return point ? this.rules.segmentAt(edge.id, this.point(point)) : edge.segment
  }

  /** Which tile was hit? Null if the shape is not of this terrain. The point is as for segment(). */
  hit(shape: ObjectId, point?: Point): Hit | null {
    const segment = this.segment(shape, point)
    return segment === 0 ? null : this.world.hit(segment)
  }
}

/** The edges in Box2D. */
class Edges extends Box2dBodies implements Adapter<ObjectId, Material> {
  readonly #edges: (Edge | null)[] = []
  readonly #edgeOf = new Map<number, Edge>() // by the index of its shape
  readonly #chunks: (Chunk | null)[] = []
  #bodyCount = 0

  at(edge: number): Edge | null { return this.#edges[edge] ?? null }

  of(shape: ObjectId): Edge | null {
    const edge = this.#edgeOf.get(shape.index1)
    return edge !== undefined && idOf(edge.shape) === idOf(shape) ? edge : null
  }

  override isOwn(shape: ObjectId): boolean { return this.of(shape) !== null }
  override ownBodyCount(): number { return this.#bodyCount }
  isAlone(): boolean { return this.bodyCount() <= this.#bodyCount }

  apply(changes: EdgeChanges): void {
    const { removed, length } = changes, left = new Set<number>()
    // Box2D itself wakes what touched a chain that is destroyed.
    for (let k = 0; k < removed; ++k) left.add(this.#destroy(changes.removedId(k)))
    for (let k = changes.added; k < length; ++k) this.#destroy(changes.id(k))
    this.#create(changes)
    for (const number of left) if (this.#chunks[number]!.edges === 0) this.#destroyChunk(number)
    if (!this.isAlone()) for (let k = 0; k < length; ++k) this.wakeAround(this.#edges[changes.id(k)]!.shape)
  }

  clear(): void {
    this.#chunks.forEach((chunk, number) => { if (chunk) this.#destroyChunk(number) })
    this.#edges.length = 0
    this.#edgeOf.clear()
    this.deleteHandles()
  }

  placeChunks(): void {
    this.#chunks.forEach((chunk, number) => {
      if (chunk) this.moveTo(chunk.body, { ...this.rules.cornerOf(number), cos: 1, sin: 0 })
    })
  }

  #create(changes: EdgeChanges): void {
    const { box2d } = this, { cellSize } = this.frame
    const def = box2d.b2DefaultChainDef()
    const points = [0, 1, 2, 3].map(() => new box2d.b2Vec2(0, 0))
    for (let k = 0; k < changes.length; ++k) {
      const at = (n: number) => changes.at(k, n) * cellSize
      const [x0, y0, x1, y1] = [at(0), at(1), at(2), at(3)]
      // Where an edge has no ghost, it is straight ahead.
      const ghost1 = Number.isNaN(at(4)) ? [2 * x0 - x1, 2 * y0 - y1] : [at(4), at(5)]
      const ghost2 = Number.isNaN(at(6)) ? [2 * x1 - x0, 2 * y1 - y0] : [at(6), at(7)]
      const places = [ghost1, [x0, y0], [x1, y1], ghost2] as [number, number][]
      places.forEach(([x, y], n) => Object.assign(points[n]!, { x, y }))
      def.SetPoints(points)
      const { friction = 0.6, restitution = 0, categoryBits = 1, maskBits = 0xffffffff, groupIndex = 0 } =
        this.rules.materialOf(changes.block(k))
      Object.assign(def.filter, { categoryBits, maskBits, groupIndex })
      const number = changes.chunk(k), chunk = this.#chunkAt(number)
      const chain = box2d.b2CreateChain(chunk.body, def)
      const shape = box2d.b2Chain_GetSegments(chain, 1)[0]!
      // In box2d3-wasm 5.2 the materials of a chain's definition are not those of its segments.
      box2d.b2Shape_SetFriction(shape, friction)
      box2d.b2Shape_SetRestitution(shape, restitution)
      const id = changes.id(k), edge = { id, segment: changes.segment(k), chain, shape, chunk: number }
      this.#edges[id] = edge
      this.#edgeOf.set(shape.index1, edge)
      ++chunk.edges
    }
    for (const handle of [def, ...points]) handle.delete()
  }

  /** Returns the number of its chunk. */
  #destroy(id: number): number {
    const { chain, shape, chunk } = this.#edges[id]!
    this.box2d.b2DestroyChain(chain)
    this.#edges[id] = null
    this.#edgeOf.delete(shape.index1)
    --this.#chunks[chunk]!.edges
    return chunk
  }

  #chunkAt(number: number): Chunk {
    let chunk = this.#chunks[number]
    if (!chunk) {
      const def = this.box2d.b2DefaultBodyDef()
      Object.assign(def.position, this.metres(this.rules.cornerOf(number)))
      chunk = { body: this.box2d.b2CreateBody(this.physics, def), edges: 0 }
      def.delete()
      this.#chunks[number] = chunk
      ++this.#bodyCount
    }
    return chunk
  }

  #destroyChunk(number: number): void {
    this.box2d.b2DestroyBody(this.#chunks[number]!.body)
    this.#chunks[number] = null
    --this.#bodyCount
  }
}
