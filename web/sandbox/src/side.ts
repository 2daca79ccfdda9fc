// One physics world over the ground: with ghost vertices, or without.
import { World as Physics, Settings } from 'planck'
import type { Changes, World } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { kindOf } from './blocks.js'
import { copyMotion, makeRider, place, removeRider, type Rider, type Start } from './bodies.js'
import { KickMeter } from './kicks.js'
import type { Mirror } from './mirror.js'
import { Rules } from './rules.js'
import { cell, gravity } from './scale.js'

export const stepTime = 1 / 60

// planck's settings are for metres. The bodies here are a quarter of that. No body moves farther in a step than the
// radius of the smallest one, so nothing can pass through the ground, and no step needs to look for the time of impact.
// They are those of all worlds, and rocks of the digger fall as fast as they fall: so they are set for a step alone.
const small = { linearSleepTolerance: 0.025, angularSleepTolerance: 0.1, maxTranslation: 0.07 }
const { linearSleepTolerance, angularSleepTolerance, maxTranslation } = Settings
const usual = { linearSleepTolerance, angularSleepTolerance, maxTranslation }
Settings.aabbExtension = 0.01

const mostTrails = 40 // riders: a crowd leaves no trails
const trailSteps = 60
const longestRest = 480 // steps
const slow = 0.03 // metres a second: who is slower lies still

/** Where riders that have left the world begin again, in cells. */
export interface Gate {
  readonly x: number
  readonly y: number
  readonly speed: number
  /** Who is below this has left. */
  readonly bottom: number
}

export class Side {
  readonly physics = new Physics({ gravity: { x: 0, y: -gravity } })
  readonly riders: Rider[] = []
  readonly terrain: PlanckTerrain
  readonly kicks: KickMeter
  /** A body that never moves: what holds a joint of the mouse. */
  readonly anchor = this.physics.createBody()
  readonly #rules: Rules
  readonly #waiting: Rider[] = []
  readonly #resting = new Map<Rider, number>() // for how many steps it has lain still
  readonly #fallen = new Map<Rider, number>() // for how many steps a car has not been on its wheels
  #wait = 0

  constructor(world: World, mirror: Mirror, ghosts: boolean) {
    this.physics.setContinuousPhysics(false)
    const material = (block: number) => ({ friction: kindOf(block).friction })
    this.terrain = new PlanckTerrain(this.physics, world, { cellSize: cell, ghosts, material })
    this.#rules = new Rules(this.physics, this.terrain, mirror)
    // After the rules: it counts no contact that they switch off.
    this.kicks = new KickMeter(this.physics, this.terrain, mirror)
  }

  get ghosts(): boolean {
    return this.terrain.ghosts
  }

  setGhosts(on: boolean): void {
    this.terrain.ghosts = on
    for (const rider of this.riders) for (const body of rider.bodies) body.setAwake(true)
    this.kicks.reset()
  }

  sync(changes: Changes): void {
    this.terrain.sync(changes)
  }

  add(start: Start): void {
    this.riders.push(makeRider(this.physics, start))
    if (this.riders.length > mostTrails) for (const { trail } of this.riders) trail.length = 0
  }

  removeAll(): void {
    for (const rider of this.riders) removeRider(this.physics, rider)
    this.riders.length = 0
    this.#fallen.clear()
    this.#resting.clear()
    this.#waiting.length = 0
    this.kicks.reset()
  }

  /** Makes the same riders as the other side has, moving as they do. */
  copyFrom(other: Side): void {
    this.removeAll()
    for (const rider of other.riders) {
      this.add(rider.start)
      copyMotion(rider, this.riders[this.riders.length - 1])
    }
  }

  /** `drive` is the speed of the cars' wheels, in radians a second. */
  step(drive: number, gate: Gate): void {
    for (const rider of this.riders) {
      for (const motor of rider.motors) {
        motor.setMotorSpeed(-drive)
        if (drive !== 0) rider.bodies[0].setAwake(true)
      }
    }
    this.kicks.beginStep()
    Object.assign(Settings, small)
    this.physics.step(stepTime, 8, 3)
    Object.assign(Settings, usual)
    this.#rules.afterStep()
    if (this.riders.length <= mostTrails) this.#noteTrails()
    this.#turnCars()
    this.#bringBack(gate)
  }

  // A car that lies on its back or its side for a second is put on its wheels.
  #turnCars(): void {
    for (const rider of this.riders) {
      if (rider.motors.length === 0) continue
      const [body] = rider.bodies
      const since = Math.cos(body.getAngle()) < 0.3 ? (this.#fallen.get(rider) ?? 0) + 1 : 0
      this.#fallen.set(rider, since)
      if (since < 60) continue
      const at = this.terrain.point(body.getPosition())
      place(rider, at.x, at.y + 1, 0)
    }
  }

  #noteTrails(): void {
    for (const { bodies, trail } of this.riders) {
      const { x, y } = bodies[0].getPosition()
      trail.push(x, y)
      if (trail.length > 2 * trailSteps) trail.splice(0, 2)
    }
  }

  // Who fell out of the world waits, and comes in again one after the other. So does who has lain still for long, in a
  // pit perhaps. Who was dropped by hand stays where it lies.
  #bringBack(gate: Gate): void {
    for (const rider of this.riders) {
      const at = this.terrain.point(rider.bodies[0].getPosition())
      const isStill = rider.start.stays !== true && rider.bodies[0].getLinearVelocity().length() < slow
      const rest = isStill ? (this.#resting.get(rider) ?? 0) + 1 : 0
      this.#resting.set(rider, rest)
      if ((at.y > gate.bottom && rest < longestRest) || this.#waiting.includes(rider)) continue
      this.#resting.delete(rider)
      this.#waiting.push(rider)
      for (const body of rider.bodies) body.setActive(false)
    }
    if (--this.#wait > 0 || this.#waiting.length === 0) return
    const rider = this.#waiting.shift()!
    for (const body of rider.bodies) body.setActive(true)
    place(rider, gate.x, gate.y, gate.speed)
    this.#wait = 45
  }
}
