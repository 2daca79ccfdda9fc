// A terrain for whichever physics engine: when which of its edges and bodies change. planck.ts and box2d3.ts say how.
import { bad, object, real, rect } from './check.js'
import { Bodies, type Overlap, type Physics } from './bodies.js'
import { LgsError } from './error.js'
import { checked, type CommonOptions, type EdgeChanges, type Frame, type OnOverlap, onOverlapOf, originOf, type Point, TerrainRules } from './terrain.js'
import type { CellRect, Changes, Region, World } from './types.js'
import { placeOf } from './world.js'

/** What the engine of a terrain does. */
export interface Adapter<Body, Material> extends Physics<Body, Material> {
  /** Whether it is in a step, in which nothing can be changed. */
  isInStep(): boolean
  /** Whether there are no bodies but the terrain's. */
  isAlone(): boolean
  /** Removes, makes and relinks edges, and wakes the bodies there. */
  apply(changes: EdgeChanges): void
  /** Moves the bodies of chunks to where they are now. */
  placeChunks(): void
  /** Removes all edges. */
  clear(): void
  /** Bodies that reach into cells, but the terrain's. */
  bodiesIn(cells: CellRect): Body[]
  /** Does work, all of it, even if a listener throws: that comes out at its end. */
  whole<T>(work: () => T): T
}

export abstract class TerrainBase<Body, Material> {
  protected world: World
  protected readonly rules: TerrainRules<Material>
  protected readonly frame: Frame
  readonly #onOverlap: OnOverlap
  #adapter!: Adapter<Body, Material>
  #bodies!: Bodies<Body, Material>
  #isSyncing = false
  #isGone = false

  /** `shortest` is in metres. */
  protected constructor(world: World, options: CommonOptions<Material>, shortest: number, more: readonly string[] = []) {
    const { cellSize, origin, chunkCells, merge, onOverlap, material } = checked(options, more)
    this.world = world
    this.frame = { cellSize, origin }
    this.#onOverlap = onOverlap
    this.rules = new TerrainRules(world, chunkCells, shortest / cellSize, merge, material)
  }

  /** Puts in what was committed. The constructor of a terrain ends with it. */
  protected start(adapter: Adapter<Body, Material>): void {
    this.#adapter = adapter
    this.#bodies = new Bodies(adapter, this.rules)
    try {
      this.#during(() => {
        this.rules.follow(this.world)
        adapter.apply(this.rules.endAll())
      })
    } catch (error) {
      this.#end()
      throw error
    }
  }

  get cellSize(): number { return this.frame.cellSize }

  /**
   * Shows what a commit or a roll-back did, each once and in order, before the next edit. Throws, and has changed nothing:
   * 'busy' in a step of the physics world, as in a listener of contacts: note what was hit, and dig after the step.
   * 'left-out', 'shown-already', 'not-the-last' if the changes do not follow what is shown: resync() repairs that.
   */
  sync(changes: Changes, onOverlap: OnOverlap = this.#onOverlap): void {
    onOverlapOf(onOverlap)
    this.#during(() => {
      if (!this.rules.fits(changes)) return
      this.#show('last', onOverlap, () => this.rules.end())
    })
  }

  /** Commits the world, and shows it: sync(world.commit()). In a step it does not commit. */
  commit(): Changes {
    this.refuseInStep()
    const changes = this.world.commit()
    this.sync(changes)
    return changes
  }

  /**
   * Compares the terrain with its world, and changes what differs, after changes were left out. Or with another world,
   * which is the terrain's from now on: one that was loaded. Free the old one after that, not before. Bodies may have
   * been put elsewhere meanwhile: a body in the ground is pushed or disabled, and one that is disabled and free is enabled.
   */
  resync(world: World = this.world): void {
    this.#during(() => {
      this.rules.follow(world)
      this.world = world
      this.#show('all', this.#onOverlap, () => this.rules.endAll())
    })
  }

  #show(which: 'last' | 'all', onOverlap: OnOverlap, end: () => EdgeChanges): void {
    const bodies = this.#bodies, catches = onOverlap !== 'leave'
    const matters = which === 'all' || ((catches || bodies.holdsSomebody) && !this.#adapter.isAlone())
    const box = matters ? this.rules.begin(which) : null
    bodies.overlaps = box !== null && catches ? bodies.find(box) : []
    this.#adapter.apply(end())
    bodies.settle(box !== null, onOverlap)
    if (which === 'all') bodies.noteAll(box!)
  }

  /** What answers, until destroy() has taken the handles of the physics engine away. */
  get #asked(): Bodies<Body, Material> {
    if (this.#isGone) throw new LgsError('freed', 'this terrain was destroyed')
    return this.#bodies
  }

  /** Throws 'busy' where nothing can be changed now. */
  refuseInStep(): void {
    if (this.isInStep)
      throw new LgsError('busy', 'the physics world is in a step: note what was hit, and change the ground after the step')
    if (this.#isSyncing) throw new LgsError('busy', 'the terrain is changing: a listener of contacts must not change it')
  }

  #during<T>(work: () => T): T {
    this.refuseInStep()
    this.#isSyncing = true
    try {
      return this.#adapter.whole(work)
    } finally {
      this.#isSyncing = false
    }
  }

  /** Whether the physics world is in a step, in which nothing can be changed. */
  get isInStep(): boolean {
    void this.#asked
    return this.#adapter.isInStep()
  }

  /** Takes everything out of the physics world. A second call does nothing. */
  destroy(): void {
    if (this.#isGone) return
    this.#during(() => this.#end())
  }
  #end(): void {
    this.#isGone = true
    this.#adapter.clear()
    this.rules.drop()
  }

  // --- Bodies: law 13

  /** Between a commit and its sync(): which bodies the new ground would overlap, how deep, and their displacement. */
  overlapsWith(changes: Changes): Overlap<Body>[] {
    return this.#during(() => {
      if (!this.rules.fits(changes)) return []
      const box = this.rules.begin('last')
      return box === null ? [] : this.#bodies.find(box)
    })
  }

  /** The bodies that the last sync() or resync() pushed or disabled. */
  get overlaps(): readonly Overlap<Body>[] { return this.#bodies.overlaps }

  /** The bodies that are disabled now. */
  get disabled(): Body[] { return this.#bodies.disabled }

  /**
   * Call it before each step, when bodies are made and moved. It notes where those are that are new, or that the game has
   * put elsewhere: from there on afterStep() guards them. Without it their first step is not guarded.
   */
  beforeStep(): void {
    this.refuseInStep()
    this.#asked.beforeStep()
  }

  /**
   * Call it after each step. The solver presses a light body through an edge when a heavy one lies on it, and lets
   * something fast through now and then. Such a body is put back to where it was free, at rest. Returns them.
   */
  afterStep(): Body[] {
    this.refuseInStep()
    return this.#bodies.afterStep()
  }

  /**
   * Notes where one body is, as beforeStep() does, for a game that does not call that: of a body that it has made, or put
   * elsewhere, through a portal. Else that seems to have come through the ground between, and afterStep() puts it back.
   * Not needed before resync().
   */
  moved(body: Body): void { this.#asked.moved(body) }

  /** Whether the ground leaves a body room: where it is, or at a place in metres. */
  fits(body: Body, place?: { x: number; y: number; angle: number }): boolean {
    if (place === undefined) return this.#asked.fits(body)
    const at = this.point(place), angle = real('angle', place.angle)
    return this.#asked.fits(body, { ...at, cos: Math.cos(angle), sin: Math.sin(angle) })
  }

  /** Polygons around the shapes of a body, for a brush. */
  outlinesOf(body: Body): Region { return { rings: this.#asked.outlinesOf(body) } }

  /** The bodies that reach into a rectangle of cells, but the terrain's; each once. Sensors are not looked at. */
  bodiesIn(cells: CellRect): Body[] {
    void this.#asked
    return this.#adapter.bodiesIn(rect(cells))
  }

  // --- Places

  /**
   * Makes the corner of another cell (0, 0) of the physics world, which keeps its origin near the player. Moves the
   * terrain's bodies; the others are yours to move, before. Where that rounded a centre into the ground, the body is moved
   * on by some units.
   */
  moveOrigin(cell: { readonly i: number; readonly j: number }): void {
    this.refuseInStep()
    this.frame.origin = originOf(cell)
    this.#adapter.placeChunks()
    if (!this.#adapter.isAlone()) this.#bodies.afterRounding()
  }

  /** From cells of the world to metres of the physics world, and back. */
  position(x: number, y: number): { x: number; y: number } {
    const { cellSize, origin } = this.frame
    return { x: (real('x', x) - origin.i) * cellSize, y: (real('y', y) - origin.j) * cellSize }
  }

  point(position: Point): { x: number; y: number } {
    const { cellSize, origin } = this.frame, { x, y } = object('position', '{ x, y }', position)
    return { x: real('x', x) / cellSize + origin.i, y: real('y', y) / cellSize + origin.j }
  }
}

/**
 * Shows changes, as sync() does. But the bodies that overlap them stay where they are: their outlines are carved out of the ground,
 * and that is committed and shown as well. If a brush is refused somewhere, because a cell is full to its limits, the
 * terrain does with bodies what its options say.
 */
export function cutOut<Body, Material>(terrain: TerrainBase<Body, Material>, world: World, changes: Changes): void {
  if (!(terrain instanceof TerrainBase)) throw bad('terrain', 'a terrain', terrain)
  placeOf(world)
  const regions = terrain.overlapsWith(changes).map(({ body }) => terrain.outlinesOf(body))
  // The terrain gets the changes while they are the last ones: what is carved comes with the next commit.
  const isCut = regions.every((region) => carved(world, region))
  isCut ? terrain.sync(changes, 'leave') : terrain.sync(changes)
  terrain.sync(world.commit())
}

function carved(world: World, { rings }: Region): boolean {
  try {
    for (const ring of rings) world.carve({ rings: [ring] })
    return true
  } catch (error) {
    if (!(error instanceof LgsError)) throw error
    return false
  }
}
