// The ground of a game without a physics engine: rocks are values, and the game moves them. planck-ground.ts has it with
// planck.
import { rect } from './check.js'
import { LgsError } from './error.js'
import { massOf, placeIn } from './ground-body.js'
import { GroundBase } from './ground-base.js'
import type { GroundOptions, Host, Motion } from './ground-types.js'
import type { Islands } from './island-view.js'
import type { GroundBody } from './island-types.js'
import type { CellRect, World } from './types.js'
import { group } from './world.js'

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
    this.#values = new Values(this.world, this.islands)
    this.start(() => this.#values)
  }

  protected override hold(world: World, islands: Islands): void { Object.assign(this.#values, { world, islands }) }
}

const most = 0.04 // that may be in the ground already: a hundredth of a cell along the sides of a square
const overlap = new Error('it reaches into the ground')

/** All cells that it may reach into, as far as there can be any. */
function cellsAround({ polygons }: GroundBody, { x, y, angle }: { x: number; y: number; angle: number }): CellRect {
  const cos = Math.cos(angle), sin = Math.sin(angle)
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity]
  for (const { i, j, vertices } of polygons)
    for (let k = 0; k < vertices.length; k += 2) {
      const a = i + vertices[k]!, b = j + vertices[k + 1]!
      x0 = Math.min(x0, x + cos * a - sin * b)
      x1 = Math.max(x1, x + cos * a - sin * b)
      y0 = Math.min(y0, y + sin * a + cos * b)
      y1 = Math.max(y1, y + sin * a + cos * b)
    }
  const clamped = (index: number) => Math.max(-(2 ** 30), Math.min(2 ** 30, Math.floor(index)))
  return rect({ i0: clamped(x0 - 1), j0: clamped(y0 - 1), i1: clamped(x1 + 1), j1: clamped(y1 + 1) })
}

class Values implements Host<Motion> {
  constructor(public world: World, public islands: Islands) {}
  refuseInStep(): void {}
  whole<T>(work: () => T): T { return work() }
  living() { return () => true }
  show(): void {}
  make(_ground: GroundBody, motion: Motion): Motion { return { ...motion } }
  motionOf(body: Motion): Motion { return { ...body } }
  rests(): boolean { return false }
  settle(body: Motion, ground: GroundBody): boolean {
    placeIn(body)
    const { x, y, angle } = body
    try {
      if (angle === 0 && Number.isInteger(x) && Number.isInteger(y)) this.islands.put(ground, x, y)
      else group(this.world, () => this.#putAsItLies(ground, body))
      return true
    } catch (error) {
      if (error === overlap || (error instanceof LgsError && error.code === 'overlap')) return false
      throw error
    }
  }
  #putAsItLies(ground: GroundBody, { x, y, angle }: Motion): void {
    const cells = cellsAround(ground, { x, y, angle }), before = massOf(this.world.polygons(cells)).area
    this.islands.putAsItLies(ground, { x, y, angle })
    const missing = ground.mass.area - (massOf(this.world.polygons(cells)).area - before)
    if (missing > most * Math.sqrt(ground.mass.area)) throw overlap
  }
  destroy(): void {}
  forget(): void {}
  window(): void {}
  step(): void {}
  free(): void {}
}
