// Grabs bodies and throws them. Where there is none it moves the view.
import { type Body, type Joint, MouseJoint, Vec2 } from 'planck'
import type { Game } from '../game.js'
import { cell } from '../scale.js'
import type { Side } from '../side.js'
import type { Tool } from './tool.js'

const reach = 0.4 // cells around a body in which it is grabbed: fingers are thick
const pull = 90 // newtons a kilogram

export class Hand implements Tool {
  #side: Side | null = null
  #joint: MouseJoint | null = null

  isIdleAt(game: Game, x: number, y: number, side: number): boolean {
    return bodyAt(game.sides[side], x, y) === null
  }

  down(game: Game, x: number, y: number, side: number): void {
    const body = bodyAt(game.sides[side], x, y)
    if (body === null) return
    const options = { maxForce: pull * body.getMass(), frequencyHz: 6, dampingRatio: 0.8 }
    this.#side = game.sides[side]
    this.#joint = new MouseJoint(options, this.#side.anchor, body, body.getPosition().clone())
    this.#side.physics.createJoint(this.#joint)
    body.setAwake(true)
  }

  move(_game: Game, x: number, y: number): void {
    if (this.#holds) this.#joint!.setTarget(new Vec2(x * cell, y * cell))
  }

  // The body keeps the speed that it has: so it is thrown.
  up(): void {
    if (this.#holds) this.#side!.physics.destroyJoint(this.#joint!)
    this.#joint = null
  }

  preview(): void {}

  // The joint went with its body, if the bodies were made anew meanwhile.
  get #holds(): boolean {
    if (this.#joint === null) return false
    for (let joint: Joint | null = this.#side!.physics.getJointList(); joint !== null; joint = joint.getNext()) {
      if (joint === this.#joint) return true
    }
    return false
  }
}

/** The nearest body of a rider whose rim is near. */
function bodyAt(side: Side, x: number, y: number): Body | null {
  let best: Body | null = null
  let least = Infinity
  for (const rider of side.riders) {
    for (const body of rider.bodies) {
      const at = body.getPosition()
      const away = Math.hypot(at.x / cell - x, at.y / cell - y) - rider.start.size
      if (body.isActive() && away < Math.min(least, reach)) [best, least] = [body, away]
    }
  }
  return best
}
