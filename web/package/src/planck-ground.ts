// The ground of a game with planck.
import type { Body, World as Physics } from 'planck'
import { GroundBase } from './ground-base.js'
import { object, within } from './check.js'
import type { Asking } from './ground-asking.js'
import { contains, everywhere } from './ground-parts.js'
import type { GroundOptions, Host, Motion } from './ground-types.js'
import type { Islands } from './island-view.js'
import type { GroundBody } from './island-types.js'
import { FallingGround, type FallingOptions } from './planck-falling.js'
import { PlanckTerrain, type TerrainOptions } from './planck.js'
import { whole } from './planck-bodies.js'
import type { CellRect, Changes, World } from './types.js'

/**
 * The ground of a game as one object: dug, painted and built; what is cut off falls as a body, and is ground again where it
 * rests; all of it is undone and redone, streamed, saved, loaded and drawn. It owns the order of calls, the marks, and the
 * bodies that came out of the ground.
 *
 *   const ground = new Ground(physics, { anchors: { cells: [{ i0: -1000, j0: 0, i1: 1000, j1: 0 }] } }, { cellSize: 0.5 })
 *   ground.dig(x, y, 2)                                          // in cells; a step of undo
 *   ground.step(1 / 60)                                          // physics.step(), and what rests becomes ground
 *   if (pressed('z')) ground.undo()
 *   for (const square of ground.draw()) repaint(square)          // what changed
 */
export class Ground extends GroundBase<Body> {
  #host!: InPlanck

  /** Of what material() and density() throw the same is true as of the functions in GroundOptions: such a block is as without. */
  constructor(physics: Physics, options: GroundOptions = {}, terrain: TerrainOptions = {}, falling: FallingOptions = {}) {
    super(options)
    this.start(() => (this.#host = new InPlanck(physics, this.world, this.islands, terrain, falling, this.asking)))
  }

  /** For questions such as what was hit; it is synced already. */
  get terrain(): PlanckTerrain { return this.#host.terrain }

  protected override hold(world: World, islands: Islands): void { this.#host.hold(world, islands) }
}

class InPlanck implements Host<Body> {
  readonly terrain: PlanckTerrain
  readonly #physics: Physics
  readonly #ofFalling: FallingOptions
  #falling: FallingGround
  #window = everywhere
  #world: World
  #isWhole = true // whether all of the window is in memory
  #away = new Set<Body>() // out of the window, and disabled
  #coming: Body[] = []    // enabled since the last sync

  constructor(physics: Physics, world: World, islands: Islands, terrain: TerrainOptions, falling: FallingOptions, asking: Asking) {
    const isMaterial = (material: object) => object('what material() gives', 'an object', material)
    this.#physics = physics
    this.#world = world
    this.#ofFalling = asking.in(asking.in(falling, 'material', {}, isMaterial),
      'density', 1, (density: number) => within('a density', density, 0, Number.MAX_VALUE))
    this.terrain = new PlanckTerrain(physics, world, asking.in(terrain, 'material', {}, isMaterial))
    try {
      this.#falling = new FallingGround(physics, this.terrain, islands, this.#ofFalling)
    } catch (error) {
      this.terrain.destroy()
      throw error
    }
  }

  hold(world: World, islands: Islands): void {
    this.#world = world
    this.terrain.resync(world)
    this.#falling = new FallingGround(this.#physics, this.terrain, islands, this.#ofFalling)
  }

  refuseInStep(): void { this.terrain.refuseInStep() }
  whole<T>(work: () => T): T { return whole(this.#physics, work) }
  living(): (body: Body) => boolean {
    const all = this.#all()
    return (body) => all.has(body)
  }
  /** Who came back is put out of the ground, if that came there since it was disabled. */
  show(changes: Changes): void {
    const coming = this.#coming
    this.#coming = []
    this.terrain.sync(changes)
    if (coming.some((body) => body.isActive() && this.#whereIs(body) !== 'outside')) this.terrain.resync()
  }

  make(ground: GroundBody, { x, y, angle, vx, vy, spin }: Motion): Body | null {
    const body = this.#falling.make(ground, { x, y, angle })?.body ?? null, { cellSize } = this.terrain
    body?.setLinearVelocity({ x: vx * cellSize, y: vy * cellSize })
    body?.setAngularVelocity(spin)
    if (body && this.#isAway(body)) this.#disable(body)
    return body
  }
  motionOf(body: Body): Motion {
    const { x, y } = body.getLinearVelocity(), { cellSize } = this.terrain
    return { ...this.#falling.placeOf(body), vx: x / cellSize, vy: y / cellSize, spin: body.getAngularVelocity() }
  }
  /** Who lies on another body alone would fall again. */
  rests(body: Body): boolean { return this.#falling.rests(body) }
  settle(body: Body): boolean { return this.#falling.settle(body) }
  forget(body: Body): void { this.#falling.forget(body) }
  destroy(body: Body): void {
    this.forget(body)
    this.#away.delete(body)
    this.#physics.destroyBody(body)
  }

  /** Bodies come back before the sync. */
  window(cells: CellRect, isWhole: boolean): void {
    this.#window = cells
    this.#isWhole = isWhole
    const all = this.#away.size > 0 ? this.#all() : this.#away
    for (const body of this.#away) {
      if (all.has(body) && this.#isAway(body)) continue
      this.#away.delete(body)
      if (!all.has(body)) continue
      body.setActive(true)
      this.terrain.moved(body)
      this.#coming.push(body)
    }
    this.#disableAway()
  }

  step(dt: number): void {
    this.terrain.beforeStep()
    this.#physics.step(dt)
    this.terrain.afterStep()
    this.#disableAway()
  }

  free(): void {
    this.window(everywhere, true)
    this.terrain.destroy()
  }

  #all(): Set<Body> {
    const bodies = new Set<Body>()
    for (let body = this.#physics.getBodyList(); body; body = body.getNext()) bodies.add(body)
    return bodies
  }
  #whereIs(body: Body): string {
    const { x, y } = this.terrain.point(body.getWorldCenter())
    return this.#world.at(x, y).where
  }
  #isAway(body: Body): boolean {
    const { x, y } = this.terrain.point(body.getWorldCenter())
    return !contains(this.#window, x, y) || (!this.#isWhole && this.#whereIs(body) === 'unloaded')
  }
  #disableAway(): void {
    if (this.#window === everywhere) return
    for (let body = this.#physics.getBodyList(); body; body = body.getNext()) {
      if (!body.isDynamic() || !body.isActive() || !this.#isAway(body)) continue
      this.#disable(body)
    }
  }
  #disable(body: Body): void {
    body.setActive(false)
    this.#away.add(body)
  }
}
