// Bodies of planck, as law 13 looks at them.
import type { AABBValue, Body, CircleShape, Fixture, FixtureOpt, PolygonShape, Vec2Value, World as Physics } from 'planck'
import { BoxShape, Settings, Transform, Vec2, testOverlap } from 'planck'
import { bad } from './check.js'
import type { Physics as OfPhysics, Place } from './bodies.js'
import type { Box, Form, Frame, Point, TerrainRules } from './terrain.js'
import type { CellRect } from './types.js'

export type Material = Pick<
  FixtureOpt,
  'friction' | 'restitution' | 'filterCategoryBits' | 'filterMaskBits' | 'filterGroupIndex'
> & {
  /** Bodies may be inside, as in a one-way platform: new ground of this block overlaps no body. */
  isPassable?: boolean
}

/** As planck does, with what it takes where nothing is given. */
function collides(fixture: Fixture, { filterGroupIndex = 0, filterCategoryBits = 1, filterMaskBits = 0xffff }: Material): boolean {
  const group = fixture.getFilterGroupIndex()
  if (group === filterGroupIndex && group !== 0) return group > 0
  return (filterMaskBits & fixture.getFilterCategoryBits()) !== 0 && (filterCategoryBits & fixture.getFilterMaskBits()) !== 0
}

/** Polygons have a skin in planck: what just rests beside the box does not reach into it. */
function overlaps(fixture: Fixture, { lowerBound: a, upperBound: b }: AABBValue): boolean {
  const box = new BoxShape((b.x - a.x) / 2, (b.y - a.y) / 2, new Vec2((a.x + b.x) / 2, (a.y + b.y) / 2), 0)
  box.m_radius = 0
  const shape = fixture.getShape(), there = fixture.getBody().getTransform(), here = Transform.identity()
  for (let child = 0; child < shape.getChildCount(); ++child)
    if (testOverlap(shape, child, box, 0, there, here)) return true
  return false
}

/** Of whichever copy of planck: what is needed of it is there. */
export function isPhysics(physics: Physics): void {
  const { createBody, on, publish, queryAABB } = (physics ?? {}) as Physics
  if ([createBody, on, publish, queryAABB].some((f) => typeof f !== 'function')) throw bad('physics', 'a World of planck', physics)
}

const changing = new WeakSet<Physics>()

/**
 * Does all of some work, and then throws what a listener threw first. planck would stop where it is, between a body and its
 * contacts or in a step, and what it leaves does not work any more.
 */
export function whole<T>(physics: Physics, work: () => T): T {
  if (changing.has(physics)) return work()
  const { publish } = physics, thrown: unknown[] = []
  changing.add(physics)
  physics.publish = (...told) => {
    try {
      return publish.apply(physics, told)
    } catch (error) {
      thrown.push(error)
      return 0
    }
  }
  let result: T
  try {
    result = work()
  } finally {
    changing.delete(physics)
    physics.publish = publish
  }
  if (thrown.length > 0) throw thrown[0]
  return result
}

const canOverlap = (body: Body) => body.isDynamic() && body.isActive()

export abstract class PlanckBodies implements OfPhysics<Body, Material> {
  readonly physics: Physics
  readonly frame: Frame
  protected readonly rules: TerrainRules<Material>

  constructor(physics: Physics, frame: Frame, rules: TerrainRules<Material>) {
    this.physics = physics
    this.frame = frame
    this.rules = rules
  }
  abstract isOwn(fixture: Fixture): boolean
  whole<T>(work: () => T): T { return whole(this.physics, work) }

  get slop(): number { return Settings.linearSlop }
  readonly epsilon = 2 ** -52

  /** From cells to metres of the physics world. */
  metres({ x, y }: Point): Vec2Value {
    const { cellSize, origin } = this.frame
    return { x: (x - origin.i) * cellSize, y: (y - origin.j) * cellSize }
  }

  keyOf(body: Body): unknown { return body }
  isEnabled(body: Body): boolean { return body.isActive() }
  velocityOf(body: Body): Point { return body.getLinearVelocity() }
  wake(body: Body): void { body.setAwake(true) }
  setEnabled(body: Body, on: boolean): void { body.setActive(on) }
  setVelocity(body: Body, velocity: Point, stops: boolean): void {
    body.setLinearVelocity(velocity)
    if (stops) body.setAngularVelocity(0)
  }

  near({ x0, y0, x1, y1 }: Box): Body[] {
    const bodies = new Set<Body>()
    this.physics.queryAABB({ lowerBound: this.metres({ x: x0, y: y0 }), upperBound: this.metres({ x: x1, y: y1 }) }, (fixture) => {
      const body = fixture.getBody()
      if (canOverlap(body) && !fixture.isSensor()) bodies.add(body)
      return true
    })
    return [...bodies]
  }

  eachMoved(moved: (body: Body) => void): void {
    for (let body = this.physics.getBodyList(); body; body = body.getNext())
      if (canOverlap(body) && body.isAwake()) moved(body)
  }
  eachToNote(_known: readonly Body[], note: (body: Body) => void): void {
    for (let body = this.physics.getBodyList(); body; body = body.getNext()) if (canOverlap(body)) note(body)
  }
  bodyCount(): number { return this.physics.getBodyCount() }

  isAlive(): (body: Body) => boolean {
    const alive = new Set<Body>()
    for (let body = this.physics.getBodyList(); body; body = body.getNext()) alive.add(body)
    return (body) => alive.has(body)
  }

  placeOf(body: Body): Place {
    const { p, q } = body.getTransform(), { cellSize, origin } = this.frame
    return { x: p.x / cellSize + origin.i, y: p.y / cellSize + origin.j, cos: q.c, sin: q.s }
  }

  moveTo(body: Body, place: Place): void { body.setTransform(this.metres(place), Math.atan2(place.sin, place.cos)) }

  formsOf(body: Body, place: Place): Form<Material>[] {
    const { cellSize } = this.frame
    const point = ({ x, y }: Vec2Value) => ({
      x: place.x + (place.cos * x - place.sin * y) / cellSize,
      y: place.y + (place.sin * x + place.cos * y) / cellSize,
    })
    const forms: Form<Material>[] = []
    for (let fixture = body.getFixtureList(); fixture; fixture = fixture.getNext()) {
      if (fixture.isSensor()) continue
      const shape = fixture.getShape(), type = shape.getType(), own = fixture
      const holds = (material: Material) => !material.isPassable && collides(own, material)
      if (type === 'circle') {
        const { x, y } = point((shape as CircleShape).m_p)
        forms.push({ corners: [x, y], radius: shape.getRadius() / cellSize, x, y, holds })
      } else if (type === 'polygon') {
        const { m_vertices, m_count, m_centroid } = shape as PolygonShape
        const corners = m_vertices.slice(0, m_count).map(point).flatMap(({ x, y }) => [x, y])
        forms.push({ corners, radius: 0, ...point(m_centroid), holds })
      } // edges do not collide with edges
    }
    return forms
  }

  bodiesIn({ i0, j0, i1, j1 }: CellRect): Body[] {
    if (i1 < i0 || j1 < j0) return []
    const box: AABBValue = { lowerBound: this.metres({ x: i0, y: j0 }), upperBound: this.metres({ x: i1 + 1, y: j1 + 1 }) }
    const bodies = new Set<Body>()
    this.physics.queryAABB(box, (fixture) => {
      if (!fixture.isSensor() && !this.isOwn(fixture) && overlaps(fixture, box)) bodies.add(fixture.getBody())
      return true
    })
    return [...bodies]
  }
}
