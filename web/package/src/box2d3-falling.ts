// Ground that falls, as bodies of box2d3-wasm.
import type { Box2dTerrain } from './box2d3.js'
import { type Box2D, idOf, type Material, type ObjectId, type PhysicsId, setMaterial, slop, taken } from './box2d3-bodies.js'
import { type Falling as FallingOf, FallingBase, type FallingMass, type FallingOptions as OptionsOf, type FallingPart, type Lies, type Maker } from './falling-base.js'
import type { Islands } from './islands.js'

export type FallingOptions = OptionsOf<Material>
export type Falling = FallingOf<ObjectId>

export class FallingGround extends FallingBase<ObjectId, Material> {
  constructor(box2d: Box2D, physics: PhysicsId, terrain: Box2dTerrain, islands: Islands, options: FallingOptions = {}) {
    super(terrain, islands, options, new InBox2d(box2d, physics, options))
  }
}

class InBox2d implements Maker<ObjectId> {
  readonly #box2d: Box2D
  readonly #physics: PhysicsId
  readonly #options: FallingOptions
  readonly slop = slop
  readonly gap = slop // shapes have no skin

  constructor(box2d: Box2D, physics: PhysicsId, options: FallingOptions) {
    this.#box2d = box2d
    this.#physics = physics
    this.#options = options
  }

  get gravity() { return taken(this.#box2d.b2World_GetGravity(this.#physics)) }
  keyOf(body: ObjectId) { return idOf(body) }

  make(place: Lies, parts: readonly FallingPart[], mass: FallingMass): ObjectId | null {
    const box2d = this.#box2d
    const shapes = parts.map(({ block, corners }) => ({ corners, material: this.#options.material?.(block) ?? {} }))
    let body: ObjectId | null = null
    for (const { corners, material } of shapes) {
      const points = corners.map(({ x, y }) => new box2d.b2Vec2(x, y)), hull = box2d.b2ComputeHull(points)
      if (hull.count >= 3) { // not if it is too thin once it is rounded to float
        body ??= this.#bodyAt(place)
        const definition = box2d.b2DefaultShapeDef(), polygon = box2d.b2MakePolygon(hull, 0)
        definition.updateBodyMass = false
        setMaterial(definition, material)
        box2d.b2CreatePolygonShape(body, definition, polygon)
        for (const handle of [definition, polygon]) handle.delete()
      }
      for (const handle of [hull, ...points]) handle.delete()
    }
    if (body !== null) this.#setMass(body, mass)
    return body
  }

  #bodyAt({ x, y, angle }: Lies): ObjectId {
    const box2d = this.#box2d, def = box2d.b2DefaultBodyDef(), turned = box2d.b2MakeRot(angle)
    def.type = box2d.b2BodyType.b2_dynamicBody
    Object.assign(def.position, { x, y })
    def.rotation = turned
    const body = box2d.b2CreateBody(this.#physics, def)
    for (const handle of [def, turned]) handle.delete()
    return body
  }

  #setMass(body: ObjectId, { mass, center, inertia }: FallingMass): void {
    const data = new this.#box2d.b2MassData()
    data.mass = mass
    Object.assign(data.center, center)
    data.rotationalInertia = inertia
    this.#box2d.b2Body_SetMassData(body, data)
    data.delete()
  }

  placeOf(body: ObjectId): Lies {
    const transform = this.#box2d.b2Body_GetTransform(body), { p: { x, y }, q: { c, s } } = transform
    transform.delete()
    return { x, y, angle: Math.atan2(s, c) }
  }

  whole<T>(work: () => T): T { return work() } // Box2D calls nobody
  destroy(body: ObjectId): void { this.#box2d.b2DestroyBody(body) }
}
