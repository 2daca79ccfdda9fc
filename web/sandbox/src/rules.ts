// What contacts with special ground do: one-way ground lets through what comes from below, sticky ground slows
// down, a conveyor carries along.
import type { Body, Contact, World as Physics } from 'planck'
import type { PlanckTerrain } from 'localgridseg/planck'
import { CONVEYOR, ONE_WAY, STICKY } from './blocks.js'
import type { Mirror } from './mirror.js'

const deepest = 0.1 // metres: what is deeper in a one-way top came from below
const belt = 0.6 // metres a second
const slowdown = 0.93 // what sticky ground leaves of the speed, in each step

export class Rules {
  readonly #terrain: PlanckTerrain
  readonly #mirror: Mirror
  readonly #holds = new Map<Contact, boolean>() // of contacts with one-way ground, decided when they begin
  readonly #stuck = new Set<Body>()

  constructor(physics: Physics, terrain: PlanckTerrain, mirror: Mirror) {
    this.#terrain = terrain
    this.#mirror = mirror
    physics.on('pre-solve', (contact) => this.#look(contact))
    physics.on('end-contact', (contact) => this.#holds.delete(contact))
  }

  afterStep(): void {
    for (const body of this.#stuck) {
      body.setLinearVelocity(body.getLinearVelocity().clone().mul(slowdown))
      body.setAngularVelocity(body.getAngularVelocity() * slowdown)
    }
    this.#stuck.clear()
  }

  #look(contact: Contact): void {
    const isA = this.#terrain.segment(contact.getFixtureA()) !== 0
    const segment = this.#terrain.segment(isA ? contact.getFixtureA() : contact.getFixtureB())
    if (segment === 0) return
    const block = this.#mirror.block[segment]
    if (block === STICKY) this.#stuck.add((isA ? contact.getFixtureB() : contact.getFixtureA()).getBody())
    if (block === CONVEYOR) contact.setTangentSpeed(belt)
    if (block !== ONE_WAY) return
    let holds = this.#holds.get(contact)
    if (holds === undefined) {
      const manifold = contact.getWorldManifold(null)!
      const up = isA ? manifold.normal.y : -manifold.normal.y
      const mover = (isA ? contact.getFixtureB() : contact.getFixtureA()).getBody()
      holds =
        up > 0.5 &&
        mover.getLinearVelocity().y < 0.5 &&
        Math.min(...manifold.separations.slice(0, manifold.pointCount)) > -deepest
      this.#holds.set(contact, holds)
    }
    if (!holds) contact.setEnabled(false)
  }
}
