// Bodies of box2d3-wasm, as law 13 looks at them.
import { everywhere, type Physics, type Place } from './bodies.js'
import type { Box, Form, Frame, Point, TerrainRules } from './terrain.js'
import type { CellRect } from './types.js'

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
type Vector = Vec2 & Handle
interface Rotation extends Handle {
  c: number
  s: number
}
interface Aabb extends Handle {
  lowerBound: Vector
  upperBound: Vector
}
interface Filter extends Handle {
  categoryBits: number
  maskBits: number
  groupIndex: number
}
interface Capsule extends Handle {
  readonly center1: Vector
  readonly center2: Vector
  readonly radius: number
}
interface Polygon extends Handle {
  readonly centroid: Vector
  readonly count: number
  readonly radius: number
  GetVertex(k: number): Vector
}
interface ShapeDef extends Handle {
  readonly material: { friction: number; restitution: number }
  readonly filter: { categoryBits: number; maskBits: number; groupIndex: number }
  updateBodyMass: boolean
}
interface MassData extends Handle {
  mass: number
  readonly center: Vec2
  rotationalInertia: number
}
interface ChainDef extends Handle {
  isLoop: boolean
  readonly filter: { categoryBits: number; maskBits: number; groupIndex: number }
  SetPoints(points: readonly Vec2[]): void
}
type Found = (result: { readonly shapeId: ObjectId }) => boolean

/** What terrain and falling ground use of the module that box2d3-wasm makes. */
export interface Box2D {
  b2Vec2: new (x: number, y: number) => Vector
  b2Rot: new () => Rotation
  b2AABB: new () => Aabb
  b2MassData: new () => MassData
  b2MakeRot(angle: number): any
  b2DefaultBodyDef(): { position: Vec2; type: any; rotation: any } & Handle
  b2DefaultShapeDef(): ShapeDef
  b2DefaultChainDef(): ChainDef
  b2DefaultQueryFilter(): Handle & { categoryBits: number; maskBits: number }
  // The types of box2d3-wasm name its structs otherwise, so here they are `any`.
  b2CreateBody(physics: PhysicsId, def: any): ObjectId
  b2DestroyBody(body: ObjectId): void
  readonly b2BodyType: { readonly b2_dynamicBody: any }
  b2ComputeHull(points: readonly Vec2[]): any
  b2MakePolygon(hull: any, radius: number): Handle
  b2CreatePolygonShape(body: ObjectId, def: any, polygon: any): ObjectId
  b2Body_SetMassData(body: ObjectId, data: any): void
  b2Body_IsValid(body: ObjectId): boolean
  b2Body_IsEnabled(body: ObjectId): boolean
  b2Body_Enable(body: ObjectId): void
  b2Body_Disable(body: ObjectId): void
  b2Body_SetAwake(body: ObjectId, awake: boolean): void
  b2Body_GetType(body: ObjectId): { readonly value: number }
  b2Body_GetTransform(body: ObjectId): { readonly p: Vec2; readonly q: { readonly c: number; readonly s: number } } & Handle
  b2Body_SetTransform(body: ObjectId, position: any, rotation: any): void
  b2Body_GetLinearVelocity(body: ObjectId): any
  b2Body_SetLinearVelocity(body: ObjectId, velocity: any): void
  b2Body_SetAngularVelocity(body: ObjectId, velocity: number): void
  b2Body_GetShapeCount(body: ObjectId): number
  b2Body_GetShapes(body: ObjectId, capacity: number): readonly ObjectId[]
  b2CreateChain(body: ObjectId, def: any): ObjectId
  b2DestroyChain(chain: ObjectId): void
  b2Chain_GetSegments(chain: ObjectId, capacity: number): ObjectId[]
  b2Shape_SetFriction(shape: ObjectId, friction: number): void
  b2Shape_SetRestitution(shape: ObjectId, restitution: number): void
  b2Shape_GetAABB(shape: ObjectId): Handle
  b2Shape_GetBody(shape: ObjectId): ObjectId
  b2Shape_GetType(shape: ObjectId): { readonly value: number }
  b2Shape_GetFilter(shape: ObjectId): any
  b2Shape_IsSensor(shape: ObjectId): boolean
  b2Shape_GetCircle(shape: ObjectId): any
  b2Shape_GetCapsule(shape: ObjectId): any
  b2Shape_GetPolygon(shape: ObjectId): any
  b2World_GetGravity(physics: PhysicsId): any
  b2World_GetBodyEvents(physics: PhysicsId): any
  b2World_GetCounters(physics: PhysicsId): any
  b2World_OverlapAABB(physics: PhysicsId, box: any, filter: any, found: Found): { readonly nodeVisits: number }
}

/** What is not given is as in Box2D. */
export interface Material {
  friction?: number
  restitution?: number
  categoryBits?: number
  maskBits?: number
  groupIndex?: number
  /** Bodies may be inside, as in a one-way platform: new ground of this block overlaps no body. */
  isPassable?: boolean
}

/** Names a body, shape or chain among those of one kind in a world. */
export const idOf = ({ index1, generation }: ObjectId) => index1 * 65536 + generation

const { fround } = Math
const dynamic = 2 // of b2BodyType
const shapeTypes = { circle: 0, capsule: 1, polygon: 3 }
/** Box2D's linear slop, in metres. */
export const slop = 0.005
/** Skin, in metres: what just rests beside a box does not reach into it. */
const skin = 0.005

export abstract class Box2dBodies implements Physics<ObjectId, Material> {
  readonly box2d: Box2D
  readonly physics: PhysicsId
  readonly frame: Frame
  protected readonly rules: TerrainRules<Material>
  readonly #vector: Vector
  readonly #rotation: Rotation
  readonly #aabb: Aabb
  readonly #all: Handle // a filter that lets everything through
  #others = -1 // bodies that were not known before the last step
  readonly slop = slop
  readonly epsilon = 2 ** -23

  constructor(box2d: Box2D, physics: PhysicsId, frame: Frame, rules: TerrainRules<Material>) {
    this.box2d = box2d
    this.physics = physics
    this.frame = frame
    this.rules = rules
    this.#vector = new box2d.b2Vec2(0, 0)
    this.#rotation = new box2d.b2Rot()
    this.#aabb = new box2d.b2AABB()
    this.#all = Object.assign(box2d.b2DefaultQueryFilter(), { categoryBits: 0xffffffff, maskBits: 0xffffffff })
  }
  abstract isOwn(shape: ObjectId): boolean
  /** How many bodies are the terrain's. */
  abstract ownBodyCount(): number

  protected deleteHandles(): void {
    for (const handle of [this.#vector, this.#rotation, this.#aabb, this.#all]) handle.delete()
  }

  /** From cells to metres of the physics world. */
  metres({ x, y }: Point): Vec2 {
    const { cellSize, origin } = this.frame
    return { x: (x - origin.i) * cellSize, y: (y - origin.j) * cellSize }
  }

  bodyCount(): number { return this.#counters().bodyCount }
  #counters(): { bodyCount: number; shapeCount: number } {
    const counters = this.box2d.b2World_GetCounters(this.physics)
    const { bodyCount, shapeCount } = counters
    counters.delete()
    return { bodyCount, shapeCount }
  }

  // In a step a question finds nothing, and has not even looked. Otherwise it looks at a node of a tree at least, if there
  // is a shape.
  isInStep(): boolean {
    const { nodeVisits } = this.#shapesIn({ x0: 0, y0: 0, x1: 0, y1: 0 }, () => true)
    return nodeVisits === 0 && this.#counters().shapeCount > 0
  }

  #shapesIn({ x0, y0, x1, y1 }: Box, found: Found): { readonly nodeVisits: number } {
    this.#aabb.lowerBound = Object.assign(this.#vector, this.metres({ x: x0, y: y0 }))
    this.#aabb.upperBound = Object.assign(this.#vector, this.metres({ x: x1, y: y1 }))
    return this.box2d.b2World_OverlapAABB(this.physics, this.#aabb, this.#all, found)
  }

  whole<T>(work: () => T): T { return work() } // Box2D calls nobody
  keyOf(body: ObjectId): number { return idOf(body) }
  isAlive(): (body: ObjectId) => boolean { return (body) => this.box2d.b2Body_IsValid(body) }
  isEnabled(body: ObjectId): boolean { return this.box2d.b2Body_IsEnabled(body) }
  wake(body: ObjectId): void { this.box2d.b2Body_SetAwake(body, true) }
  setEnabled(body: ObjectId, on: boolean): void { on ? this.box2d.b2Body_Enable(body) : this.box2d.b2Body_Disable(body) }
  velocityOf(body: ObjectId): Point { return taken(this.box2d.b2Body_GetLinearVelocity(body)) }
  setVelocity(body: ObjectId, { x, y }: Point, stops: boolean): void {
    this.box2d.b2Body_SetLinearVelocity(body, Object.assign(this.#vector, { x, y }))
    if (stops) this.box2d.b2Body_SetAngularVelocity(body, 0)
  }

  #canOverlap(body: ObjectId): boolean {
    return this.box2d.b2Body_GetType(body).value === dynamic && this.box2d.b2Body_IsEnabled(body)
  }

  near(box: Box): ObjectId[] {
    const bodies = new Map<number, ObjectId>()
    this.#shapesIn(box, ({ shapeId }) => {
      const body = this.box2d.b2Shape_GetBody(shapeId)
      if (!bodies.has(idOf(body)) && this.#canOverlap(body) && !this.box2d.b2Shape_IsSensor(shapeId)) bodies.set(idOf(body), body)
      return true
    })
    return [...bodies.values()]
  }

  eachMoved(moved: (body: ObjectId) => void): void {
    const events = this.box2d.b2World_GetBodyEvents(this.physics)
    for (let k = 0; k < events.moveCount; ++k) {
      const event = events.GetMoveEvent(k), body = event.bodyId
      event.delete()
      if (this.box2d.b2Body_IsValid(body) && this.#canOverlap(body)) moved(body)
    }
    events.delete()
  }

  // Box2D lists no bodies, but counts them. If there are as many as before that are not known, none has come.
  eachToNote(known: readonly ObjectId[], note: (body: ObjectId) => void): void {
    const alive = known.filter((body) => this.box2d.b2Body_IsValid(body)), ids = new Set(alive.map(idOf))
    for (const body of alive) if (this.#canOverlap(body)) note(body)
    const others = this.bodyCount() - this.ownBodyCount() - alive.length
    if (others === this.#others) return
    for (const body of this.near(everywhere)) if (!ids.has(idOf(body))) note(body)
    this.#others = others
  }

  placeOf(body: ObjectId): Place {
    const transform = this.box2d.b2Body_GetTransform(body), { cellSize, origin } = this.frame
    const { p: { x, y }, q: { c: cos, s: sin } } = transform
    transform.delete()
    return { x: x / cellSize + origin.i, y: y / cellSize + origin.j, cos, sin }
  }

  moveTo(body: ObjectId, place: Place): void {
    Object.assign(this.#vector, this.metres(place))
    Object.assign(this.#rotation, { c: place.cos, s: place.sin })
    this.box2d.b2Body_SetTransform(body, this.#vector, this.#rotation)
  }

  formsOf(body: ObjectId, place: Place): Form<Material>[] {
    const { box2d } = this, { cellSize, origin } = this.frame, { x: left, y: low } = this.metres(place), { cos, sin } = place
    const point = ({ x, y }: Point) => ({ // as b2Body_GetWorldPoint() rounds
      x: fround(fround(left) + fround(fround(cos * x) - fround(sin * y))) / cellSize + origin.i,
      y: fround(fround(low) + fround(fround(sin * x) + fround(cos * y))) / cellSize + origin.j,
    })
    const forms: Form<Material>[] = []
    for (const shape of box2d.b2Body_GetShapes(body, box2d.b2Body_GetShapeCount(body))) {
      if (box2d.b2Shape_IsSensor(shape)) continue
      const outline = this.#outlineOf(shape)
      if (outline === null) continue
      const corners = outline.hull.map(point).flatMap(({ x, y }) => [x, y])
      const holds = (material: Material) => !material.isPassable && this.#collides(shape, material)
      forms.push({ corners, radius: outline.radius / cellSize, ...point(outline.middle), holds })
    }
    return forms
  }

  /** A shape in its body; by its centre Box2D decides on which side of an edge it is. Null if edges do not hold it. */
  #outlineOf(shape: ObjectId): { hull: Point[]; radius: number; middle: Point } | null {
    const { box2d } = this
    switch (box2d.b2Shape_GetType(shape).value) {
      case shapeTypes.circle: {
        const circle = box2d.b2Shape_GetCircle(shape), middle = pointOf(circle.center), { radius } = circle
        circle.delete()
        return { hull: [middle], radius, middle }
      }
      case shapeTypes.capsule: {
        const capsule: Capsule = box2d.b2Shape_GetCapsule(shape)
        const a = pointOf(capsule.center1), b = pointOf(capsule.center2), { radius } = capsule
        capsule.delete()
        return { hull: [a, b], radius, middle: { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 } }
      }
      case shapeTypes.polygon: {
        const polygon: Polygon = box2d.b2Shape_GetPolygon(shape), { count, radius } = polygon
        const hull = Array.from({ length: count }, (_, k) => pointOf(polygon.GetVertex(k))), middle = pointOf(polygon.centroid)
        polygon.delete()
        return { hull, radius, middle }
      }
      default:
        return null
    }
  }

  /** As Box2D does, with what it takes where nothing is given. */
  #collides(shape: ObjectId, { categoryBits = 1, maskBits = 0xffffffff, groupIndex = 0 }: Material): boolean {
    const filter: Filter = this.box2d.b2Shape_GetFilter(shape)
    const { categoryBits: category, maskBits: mask, groupIndex: group } = filter
    filter.delete()
    if (group === groupIndex && group !== 0) return group > 0
    return (maskBits & category) !== 0 && (categoryBits & mask) !== 0
  }

  wakeAround(edge: ObjectId): void {
    const { box2d } = this
    const box = box2d.b2Shape_GetAABB(edge)
    const near: ObjectId[] = []
    box2d.b2World_OverlapAABB(this.physics, box, this.#all, ({ shapeId }) => {
      if (!this.isOwn(shapeId)) near.push(shapeId)
      return true
    })
    box.delete()
    for (const shape of near) box2d.b2Body_SetAwake(box2d.b2Shape_GetBody(shape), true)
  }

  /** By the boxes of shapes, which are a little larger than these. */
  bodiesIn({ i0, j0, i1, j1 }: CellRect): ObjectId[] {
    if (i1 < i0 || j1 < j0) return []
    const bodies = new Map<number, ObjectId>(), within = skin / this.frame.cellSize
    this.#shapesIn({ x0: i0 + within, y0: j0 + within, x1: i1 + 1 - within, y1: j1 + 1 - within }, ({ shapeId }) => {
      const body = this.box2d.b2Shape_GetBody(shapeId)
      if (!this.isOwn(shapeId) && !this.box2d.b2Shape_IsSensor(shapeId)) bodies.set(idOf(body), body)
      return true
    })
    return [...bodies.values()]
  }
}

/** What is part of something: that is deleted, not the part. */
const pointOf = ({ x, y }: Vec2): Vec2 => ({ x, y })

/** What is not given is as in Box2D. */
export function setMaterial(def: ShapeDef, { friction, restitution, categoryBits, maskBits, groupIndex }: Material): void {
  if (friction !== undefined) def.material.friction = friction
  if (restitution !== undefined) def.material.restitution = restitution
  if (categoryBits !== undefined) def.filter.categoryBits = categoryBits
  if (maskBits !== undefined) def.filter.maskBits = maskBits
  if (groupIndex !== undefined) def.filter.groupIndex = groupIndex
}

/** What a function gave; its handle is deleted. */
export function taken(handle: Vector): Vec2 {
  const { x, y } = handle
  handle.delete()
  return { x, y }
}
