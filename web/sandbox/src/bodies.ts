// The bodies: marbles, boxes, cars. A rider is one thing that moves, of one or more bodies.
import { type Body, Box, Circle, Polygon, Vec2, WheelJoint, type World as Physics } from 'planck'
import { cell } from './scale.js'

export type RiderKind = 'marble' | 'box' | 'car'

/** How a rider starts, in cells; its speed in cells a second. */
export interface Start {
  readonly kind: RiderKind
  readonly x: number
  readonly y: number
  readonly speed: number
  /** Of a marble the radius, of a box half its side. */
  readonly size: number
  readonly colour: number
  /** It stays where it comes to rest. */
  readonly stays?: boolean
}

export interface Rider {
  readonly start: Start
  /** The first one is the main body. */
  readonly bodies: readonly Body[]
  readonly motors: readonly WheelJoint[]
  /** Where it was lately: x, y, x, y, … in metres. */
  readonly trail: number[]
}

const wheelRadius = 0.32 * cell
const chassis = [
  [-0.95, -0.22],
  [0.95, -0.22],
  [1, 0.05],
  [0.35, 0.42],
  [-0.5, 0.42],
  [-0.95, 0.15],
].map(([x, y]) => new Vec2(x * cell, y * cell))

export function makeRider(physics: Physics, start: Start): Rider {
  if (start.kind === 'car') return makeCar(physics, start)
  const body = physics.createBody({
    type: 'dynamic',
    position: new Vec2(start.x * cell, start.y * cell),
    linearVelocity: new Vec2(start.speed * cell, 0),
  })
  if (start.kind === 'marble') {
    body.createFixture(new Circle(start.size * cell), { density: 1, friction: 0.6 })
    body.setAngularVelocity(-start.speed / start.size)
    body.setAngularDamping(0.4) // so that marbles in a hollow come to rest
  } else {
    body.createFixture(new Box(start.size * cell, start.size * cell), { density: 1, friction: 0.01 })
  }
  return { start, bodies: [body], motors: [], trail: [] }
}

function makeCar(physics: Physics, start: Start): Rider {
  const place = (dx: number, dy: number): Body =>
    physics.createBody({
      type: 'dynamic',
      position: new Vec2((start.x + dx) * cell, (start.y + dy) * cell),
      linearVelocity: new Vec2(start.speed * cell, 0),
    })
  const body = place(0, 0)
  body.createFixture(new Polygon(chassis), { density: 0.8, friction: 0.1 })
  const wheels = [place(-0.6, -0.35), place(0.6, -0.35)]
  const motors = wheels.map((wheel) => {
    wheel.createFixture(new Circle(wheelRadius), { density: 0.9, friction: 1.2 })
    const options = {
      motorSpeed: 0,
      maxMotorTorque: 0.7 * cell ** 3,
      enableMotor: true,
      frequencyHz: 5,
      dampingRatio: 0.8,
    }
    return physics.createJoint(new WheelJoint(options, body, wheel, wheel.getPosition(), new Vec2(0, 1)))!
  })
  return { start, bodies: [body, ...wheels], motors, trail: [] }
}

export function removeRider(physics: Physics, rider: Rider): void {
  for (const body of rider.bodies) physics.destroyBody(body)
}

/** A rider and how it moves: x, y, angle, the velocity's x and y, and the spin of each body, in metres. */
export interface Riding {
  readonly start: Start
  readonly motions: readonly number[]
}

export function motionsOf(rider: Rider): number[] {
  return rider.bodies.flatMap((body) => {
    const { x, y } = body.getPosition()
    const v = body.getLinearVelocity()
    return [x, y, body.getAngle(), v.x, v.y, body.getAngularVelocity()].map((number) => Math.round(number * 1e4) / 1e4)
  })
}

export function setMotions(rider: Rider, motions: readonly number[]): void {
  rider.bodies.forEach((body, k) => {
    const [x, y, angle, vx, vy, spin] = motions.slice(6 * k, 6 * k + 6)
    body.setTransform(new Vec2(x, y), angle)
    body.setLinearVelocity(new Vec2(vx, vy))
    body.setAngularVelocity(spin)
  })
}

/** Puts a rider where another one is, with its motion. Both were made from the same start. */
export function copyMotion(from: Rider, to: Rider): void {
  from.bodies.forEach((body, k) => {
    const copy = to.bodies[k]
    copy.setTransform(body.getPosition(), body.getAngle())
    copy.setLinearVelocity(body.getLinearVelocity())
    copy.setAngularVelocity(body.getAngularVelocity())
    copy.setAwake(body.isAwake())
  })
}

/** Puts a rider somewhere else, upright; in cells. */
export function place(rider: Rider, x: number, y: number, speed: number): void {
  rider.trail.length = 0
  const shift = Vec2.sub(new Vec2(x * cell, y * cell), rider.bodies[0].getPosition())
  const turn = -rider.bodies[0].getAngle()
  const about = rider.bodies[0].getPosition().clone()
  for (const body of rider.bodies) {
    const arm = Vec2.sub(body.getPosition(), about)
    const turned = new Vec2(
      arm.x * Math.cos(turn) - arm.y * Math.sin(turn),
      arm.x * Math.sin(turn) + arm.y * Math.cos(turn),
    )
    body.setTransform(Vec2.add(Vec2.add(about, turned), shift), body === rider.bodies[0] ? 0 : body.getAngle())
    body.setLinearVelocity(new Vec2(speed * cell, 0))
    body.setAngularVelocity(0)
    body.setAwake(true)
  }
}
