// Rocks: ground that was cut off falls in every physics world, and is ground again where it came to rest.
import type { Body } from 'planck'
import { type GroundBody, Islands, LgsError } from 'localgridseg/islands'
import { FallingGround } from 'localgridseg/planck'
import type { Changes, Mark } from 'localgridseg'
import { kindOf } from './blocks.js'
import type { Ground } from './ground.js'
import type { Side } from './side.js'

const patience = 30 // steps, between attempts to put one back that has no room
const farthest = 2 ** 30
const longestMemory = 400 // marks

interface Place {
  readonly x: number
  readonly y: number
  readonly angle: number
}

export class Rocks {
  readonly #ground: Ground
  #islands: Islands | null = null
  #falling: { readonly side: Side; readonly ground: FallingGround }[] = []
  readonly #lying = new WeakMap<GroundBody, Place>() // where one was when it became ground, or was lost
  readonly #inAir = new Map<Mark, readonly GroundBody[]>()
  #wait = 0

  constructor(ground: Ground) {
    this.#ground = ground
  }

  /** Of another world. Its lowest row of cells holds. */
  reset(): void {
    this.#islands?.free()
    const { world } = this.#ground
    const lowest = world.bounds()?.j0 ?? 0
    this.#islands = new Islands(world, { cells: [{ i0: -farthest, j0: -farthest, i1: farthest, j1: lowest }] })
    this.#falling = []
    this.#inAir.clear()
  }

  /** The physics worlds of now. What falls in the first one falls in all of them. */
  set sides(sides: readonly Side[]) {
    const first = this.#falling[0]
    this.#falling = sides.map((side) => this.#falling.find((each) => each.side === side) ?? this.#over(side))
    for (const { ground } of this.#falling) {
      if (first === undefined || ground === first.ground || ground.bodies.length > 0) continue
      for (const { body, ground: rock } of first.ground.bodies) {
        const copy = ground.make(rock, first.ground.placeOf(body))!.body
        copy.setLinearVelocity(body.getLinearVelocity())
        copy.setAngularVelocity(body.getAngularVelocity())
      }
    }
  }

  #over(side: Side): { side: Side; ground: FallingGround } {
    const material = (block: number) => ({ friction: Math.max(0.3, kindOf(block).friction) })
    return { side, ground: new FallingGround(side.physics, side.terrain, this.#islands!, { material }) }
  }

  /** What falls in a physics world: for the picture. */
  of(side: Side): readonly { readonly body: Body; readonly ground: GroundBody }[] {
    return this.#falling.find((each) => each.side === side)?.ground.bodies ?? []
  }

  get #rocks(): GroundBody[] {
    return this.#falling[0]?.ground.bodies.map(({ ground }) => ground) ?? []
  }

  /** When a mark is made: a roll-back to it brings back who falls now. */
  note(mark: Mark): void {
    const rocks = this.#rocks
    if (rocks.length > 0) this.#inAir.set(mark, rocks)
    if (this.#inAir.size > longestMemory) this.#inAir.delete(this.#inAir.keys().next().value!)
  }

  /**
   * After every commit, and after the physics worlds were told. Of what was cut in two the part falls that nothing holds;
   * if that is both, as of a platform in the air, it is the smaller one.
   */
  update(changes: Changes): void {
    const islands = this.#islands!
    islands.update(changes)
    const loose = new Set(islands.loose())
    const cut = new Set(
      islands.changes.cutOff.flatMap(({ from, into }) => (loose.has(into) ? [into] : loose.has(from) ? [from] : [])),
    )
    if (cut.size === 0) return
    const boxes = [...cut].map((id) => islands.island(id)!)
    const rocks: GroundBody[] = []
    this.#ground.editAlone(
      () => rocks.push(...[...cut].map((id) => islands.take(id))) > 0,
      boxes.map(({ x0, y0, x1, y1 }) => ({ i0: Math.floor(x0), j0: Math.floor(y0), i1: Math.floor(x1), j1: Math.floor(y1) })),
    )
    for (const rock of rocks) for (const { ground } of this.#falling) ground.make(rock)
  }

  /** After a roll-back to a mark. */
  rollBack(changes: Changes, mark: Mark): void {
    this.#islands!.update(changes)
    const wanted = new Set(this.#inAir.get(mark))
    for (const rock of this.#rocks) if (!wanted.delete(rock)) this.#remove(rock)
    for (const rock of wanted) for (const { ground } of this.#falling) ground.make(rock, this.#lying.get(rock))
  }

  /** After each step: who sleeps in the first physics world is ground again, and who fell out of the world is gone. */
  afterStep(bottom: number): void {
    const first = this.#falling[0]?.ground
    if (first === undefined) return
    const isTime = --this.#wait <= 0
    for (const { body, ground: rock } of first.bodies) {
      if (first.placeOf(body).y < bottom) this.#lose(rock, first.placeOf(body))
      else if (isTime && first.rests(body)) this.#settle(first, body, rock)
    }
  }

  #settle(first: FallingGround, body: Body, rock: GroundBody): void {
    this.#wait = patience
    const place = first.placeOf(body)
    const settle = () => {
      const isDone = hasRoom(() => first.settle(body))
      if (isDone) this.#lose(rock, place)
      return isDone
    }
    this.#ground.editAlone(settle, [cellsOf(rock, place)])
  }

  #lose(rock: GroundBody, place: Place): void {
    this.#lying.set(rock, place)
    this.#remove(rock)
  }

  #remove(rock: GroundBody): void {
    for (const { side, ground } of this.#falling) {
      const found = ground.bodies.find((each) => each.ground === rock)
      if (found === undefined) continue
      ground.forget(found.body)
      side.physics.destroyBody(found.body)
    }
  }
}

/** A cell may be full to its limits: then a rock stays what it is. */
function hasRoom(settle: () => boolean): boolean {
  try {
    return settle()
  } catch (error) {
    if (error instanceof LgsError) return false
    throw error
  }
}

/** The cells that a rock may reach into where it lies. */
function cellsOf({ polygons }: GroundBody, { x, y, angle }: Place) {
  const width = polygons.reduce((most, { i }) => Math.max(most, i + 1), 0)
  const height = polygons.reduce((most, { j }) => Math.max(most, j + 1), 0)
  const xs = [0, width * Math.cos(angle), -height * Math.sin(angle), width * Math.cos(angle) - height * Math.sin(angle)]
  const ys = [0, width * Math.sin(angle), height * Math.cos(angle), width * Math.sin(angle) + height * Math.cos(angle)]
  const floor = (value: number) => Math.floor(Math.max(-farthest, Math.min(farthest, value)))
  return {
    i0: floor(x + Math.min(...xs) - 1),
    j0: floor(y + Math.min(...ys) - 1),
    i1: floor(x + Math.max(...xs) + 1),
    j1: floor(y + Math.max(...ys) + 1),
  }
}
