// The ground of a game without a physics engine: rocks are values, and the game moves them. planck-ground.ts has it with
// planck.
import { placeIn } from './ground-body.js'
import { GroundBase } from './ground-base.js'
import type { GroundOptions, Host, Motion } from './ground-types.js'
import type { Islands } from './island-view.js'
import type { GroundBody } from './island-types.js'
import type { World } from './types.js'

/**
 * The ground of a game as one object: dug, painted and built; what is cut off becomes a rock; all of it is undone and
 * redone, streamed, saved, loaded and drawn. It owns the order of calls, the marks, and what came out of the ground.
 *
 *   const ground = new Ground({ anchors: { cells: [{ i0: -1000, j0: 0, i1: 1000, j1: 0 }] } })
 *   ground.edit((world) => world.fill({ i0: 0, j0: 0, i1: 39, j1: 9 }, world.shape(unitSquare), 1))
 *   ground.dig(x, y, 2)                                          // a step of undo
 *   for (const { body } of ground.rocks()) body.y -= 0.1         // yours to move; settle(body) makes it ground again
 *   for (const square of ground.draw()) repaint(square)          // what changed
 */
export class Ground extends GroundBase<Motion> {
  readonly #values: Values

  constructor(options: GroundOptions = {}) {
    super(options)
    this.#values = new Values(this.islands)
    this.start(this.#values)
  }

  protected override hold(_world: World, islands: Islands): void { this.#values.islands = islands }
}

class Values implements Host<Motion> {
  constructor(public islands: Islands) {}
  refuseInStep(): void {}
  show(): void {}
  make(_ground: GroundBody, motion: Motion): Motion { return { ...motion } }
  motionOf(body: Motion): Motion { return { ...body } }
  rests(): boolean { return false }
  settle(body: Motion, ground: GroundBody): boolean {
    placeIn(body)
    const { x, y, angle } = body
    if (angle === 0 && Number.isInteger(x) && Number.isInteger(y)) this.islands.put(ground, x, y)
    else this.islands.putAsItLies(ground, { x, y, angle })
    return true
  }
  destroy(): void {}
  forget(): void {}
  window(): void {}
  step(): void {}
  free(): void {}
}
