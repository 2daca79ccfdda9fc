// The ground of a game as one object. ground.ts has it without physics, planck-ground.ts with planck. lgs/ground.h is the
// same in C++, by the same rules:
//
//  1. A stroke is one step of undo, with what it cuts off. A stroke that is refused changes nothing.
//  2. Matter is neither doubled nor lost. Undo over a take destroys the body, and the ground is back; undo over a settle
//     takes the ground away, and the rock lies there as a body, at rest. Redo does either again.
//  3. While there is something to redo nothing falls and nothing settles, as both are edits, which end the redo.
//  4. What reaches the edge of memory is held, unless `atEdge` is 'open'. What is loose when it comes in falls. Undo and redo
//     go on over chunks that left and came back. New land ends the redo.
//  5. Bodies outside of the window are disabled, the game's too, and enabled when it is there again.
//  6. A call that is refused has changed nothing, and one that is not is done, also where a function of the game throws that
//     it asks (ground-asking.ts). None of these, and no listener of contacts, can change the ground meanwhile.
import { atOnce, bad, options as known, within } from './check.js'
import { LgsError } from './error.js'
import { Asking, preserving } from './ground-asking.js'
import { ChangedSquares, everywhere, loadedGround, savedGround } from './ground-parts.js'
import { GroundRocks, type Tries } from './ground-rocks.js'
import type { GroundDrawing, GroundOptions, Host, Rock } from './ground-types.js'
import { GroundWindow } from './ground-window.js'
import { inspect, shown } from './inspect.js'
import { Islands, refuseInTry } from './island-view.js'
import { circle } from './regions.js'
import type { Block, CellRect, Changes, Mark, Region, Vertices, World, WorldOptions } from './types.js'
import { createWorld, group } from './world.js'

const names = ['anchors', 'atEdge', 'preserve', 'land', 'shelf', 'chunksAtOnce', 'undoSteps', 'follow'] as const

export abstract class GroundBase<Body> {
  protected readonly asking = new Asking()
  readonly #options: GroundOptions
  readonly #ofWorld: WorldOptions
  readonly #undoSteps: number
  #world: World
  #islands: Islands
  #host: Host<Body> | null = null
  #rocks!: GroundRocks<Body> // of now, and of what can be undone or redone
  #marks: Mark[] = []        // after each stroke; those behind #now are ahead
  #oldest = 0                // the number of the first mark,
  #now = 0                   // and of that at or after which the world is
  #looksAtAll = false        // something may hang in the air that no update will name
  readonly #window: GroundWindow
  readonly #squares = new ChangedSquares()

  /** An empty ground. */
  protected constructor(options: GroundOptions) {
    const { anchors, atEdge, preserve, undoSteps = 64, follow } = known('options', names, options)
    if (follow !== undefined && typeof follow !== 'function') throw bad('follow', 'a function', follow)
    this.#options = { ...(anchors && { anchors }), ...(atEdge && { atEdge }), ...(follow && { follow }) }
    this.#ofWorld = typeof preserve === 'function' ? { preserve: preserving(this.asking, preserve) } : preserve === undefined ? {} : { preserve }
    this.#window = new GroundWindow(options, this.#ofWorld, this.asking)
    this.#undoSteps = within('undoSteps', undoSteps, 0, 1e6)
    this.#world = createWorld(this.#ofWorld)
    try {
      this.#islands = new Islands(this.#world, anchors, atEdge)
    } catch (error) {
      this.#world.free()
      throw error
    }
    this.#marks = [this.#world.mark()]
  }

  /** The constructors end with it. */
  protected start(make: () => Host<Body>): void {
    try {
      this.#host = make()
      this.#rocks = new GroundRocks(this.#host)
    } catch (error) {
      this.#islands.free()
      this.#world.free()
      throw error
    }
  }

  get #live(): Host<Body> {
    if (this.#host === null) throw new LgsError('freed', 'this ground was freed')
    return this.#host
  }
  /** What changes the ground is done in it. */
  #during<T>(change: (host: Host<Body>) => T): T {
    return this.asking.during(() => {
      const host = this.#live
      host.refuseInStep()
      refuseInTry(this.#islands)
      return host.whole(() => {
        this.#rocks.dropGone()
        return change(host)
      })
    })
  }

  // --- Strokes

  /** Frees a circle, or a region. Refused as carve() is; so is what reaches out of the window. */
  dig(region: Region): void
  dig(x: number, y: number, radius: number): void
  dig(what: Region | number, y = 0, radius = 0): void {
    const region = typeof what === 'object' ? what : circle(what, y, radius)
    this.edit((world) => world.carve(region))
  }

  /** Paints a circle, or a region. Refused as World.paint() is. */
  paint(region: Region, block: Block, mode?: 'fill' | 'replace'): void
  paint(x: number, y: number, radius: number, block: Block, mode?: 'fill' | 'replace'): void
  paint(what: Region | number, ...rest: (number | string | undefined)[]): void {
    const [block, mode] = typeof what === 'object' ? rest : rest.slice(2)
    const region = typeof what === 'object' ? what : circle(what, rest[0] as number, rest[1] as number)
    this.edit((world) => world.paint(region, block as Block, mode as 'fill' | 'replace' | undefined))
  }

  /** Places a polygon in a cell. Refused as addPolygon() is. */
  place(i: number, j: number, vertices: Vertices, block: Block): void {
    this.edit((world) => world.addPolygon(i, j, vertices, block))
  }

  /** Any edits, as one stroke, and what they give. If one of them throws nothing is changed. */
  edit<T>(edits: (world: World) => T): T {
    if (typeof edits !== 'function') throw bad('edits', 'a function', edits)
    return this.#during(() => {
      const result = group(this.#world, (world) => atOnce('what edits() gives', 'anything', edits(world)))
      this.#dropFuture()
      this.#commit()
      this.#mark()
      return result
    })
  }

  /** Whether there is a stroke to take back. */
  get canUndo(): boolean { return this.#now > this.#oldest }
  /** Whether there is one to make again. */
  get canRedo(): boolean { return this.#now + 1 < this.#oldest + this.#marks.length }
  /** Takes the last stroke back, and what fell or settled since. Whether there was one. */
  undo(): boolean { return this.#during(() => this.canUndo && this.#go(this.#now - 1)) }
  /** Makes it again. Whether there was one. */
  redo(): boolean { return this.#during(() => this.canRedo && this.#go(this.#now + 1)) }
  /** Releases all steps of undo, as after the game built a level. */
  forgetUndo(): void {
    this.#during(() => {
      this.#dropFuture()
      while (this.canUndo) this.#forgetOldest()
    })
  }

  // --- Time

  /** A step of the physics, in seconds. Then at most one rock that rests becomes ground. */
  step(dt: number): void {
    this.#during((host) => {
      host.step(within('dt', dt, 0, 1e9))
      this.#rocks.dropGone()
      if (!this.canRedo) this.#becameGround(this.#rocks.settleNext(this.#now))
    })
  }

  // --- Space

  /**
   * The chunks with a cell of a rectangle are in memory from now on, and no others; until it is called the first time, all
   * are. With `land` there is land there, and one chunk further. False while that is not so, and the next call goes on:
   * there are more than `chunksAtOnce`, or the shelf did not give a chunk, or other bytes. Undo and redo go on over it, but
   * new land ends the redo. It costs nothing if the chunks are the same and all are there.
   */
  window(cells: CellRect): boolean {
    return this.#during((host) => {
      const window = this.#window
      if (!window.moveTo(cells)) return true
      window.stream(this.#world, this.#now, this.#dropFuture)
      host.window(window.cells, window.isWhole)
      this.#commit()
      this.#keepLand()
      return window.isWhole
    })
  }

  /** Where nothing else has happened since the last mark, it is made anew behind the land: so undo does not take that away. */
  #keepLand(): void {
    const now = this.#now
    if (!this.#window.hasNew(now) || this.#rocks.anyOf(now)) return
    const mark = this.#marks.pop()!
    this.#marks.push(this.#world.mark())
    this.#world.forget(mark)
    this.#window.keepNew(now)
    this.#window.forgetBefore(this.#oldest)
  }

  // --- Saving

  /** All ground, in memory or on the shelf, and all rocks; no steps of undo. Refused as 'unloaded', if the shelf does not
   *  give a chunk. The bytes are those of lgs::Ground in C++. */
  save(): Uint8Array {
    return this.#during(() => savedGround(this.#world, this.#window.shelf, this.#rocks.values(), this.#window.land))
  }

  /** What was saved takes the place of all that is there. What hangs in the air falls. Throws 'not-a-snapshot', and nothing
   *  is changed, if these are not the bytes of a save. */
  load(saved: Uint8Array): void {
    if (!(saved instanceof Uint8Array)) throw bad('saved', 'a Uint8Array', saved)
    this.#during((host) => this.#load(host, saved))
  }
  #load(host: Host<Body>, saved: Uint8Array): void {
    void this.#world.version  // refused where the engine has ended
    const { world, rocks, land, away } = loadedGround(saved, this.#window.cells, this.#ofWorld)
    world.commit()
    this.#rocks.destroyAll()
    const old = this.#world, oldIslands = this.#islands
    this.#world = world
    this.#islands = new Islands(world, this.#options.anchors, this.#options.atEdge)
    this.#marks = [world.mark()]
    this.#oldest = this.#now = 0
    this.#window.restart(land, away)
    this.#squares.noteAll(old)
    this.#squares.noteAll(world)
    host.window(this.#window.cells, false)
    this.hold(world, this.#islands)
    oldIslands.free()
    old.free()
    for (const { ground, motion } of rocks) this.#rocks.add(ground, -1, undefined, motion)
    this.#rocks.makeFrom(0)
    this.#looksAtAll = true
    this.#commit()
  }

  /** Another world, while the old one is still there. */
  protected abstract hold(world: World, islands: Islands): void

  // --- Looking

  /** The squares that look different since the last call, the first time all. */
  draw(): GroundDrawing[] {
    void this.#live
    return this.#squares.draw(this.#world)
  }

  /** The rocks in the air, as they lie now. */
  rocks(): Rock<Body>[] {
    void this.#live
    this.#rocks.dropGone()
    return this.#rocks.values()
  }

  /** Puts a rock into the ground now, as it lies. False, and nothing has changed, where it does not fit. */
  settle(body: Body): boolean {
    return this.#during(() => this.#becameGround(this.#rocks.settle(body, this.#now)))
  }
  /** For a rock whose body the game destroyed, or keeps: it is not the ground's any more. */
  forget(body: Body): void {
    this.#during(() => this.#rocks.forget(body))
  }

  /** For questions: to edit or commit it goes around this object. load() makes another one. */
  get world(): World { return this.#world }
  /** For questions. */
  get islands(): Islands { return this.#islands }

  /** Gives all memory back; bodies and edges leave the physics world. A second call does nothing. */
  free(): void {
    if (this.#host === null) return
    this.#during((host) => {
      this.#rocks.destroyAll()
      host.free()
      this.#islands.free()
      this.#world.free()
      this.#host = null
    })
  }
  [Symbol.dispose](): void { this.free() }
  [inspect](): unknown {
    if (this.#host === null) return shown('Ground', { freed: true })
    return shown('Ground', { world: this.#world, rocks: this.#rocks.values().length, canUndo: this.canUndo, canRedo: this.canRedo })
  }

  // --- Commits

  #show(changes: Changes): void {
    this.#live.show(changes)
    this.#islands.update(changes)
    this.#squares.noteChanges(this.#world)
    this.asking.ask(() => this.#options.follow?.(this.#world, changes), undefined)
  }

  /** With what falls by it, which has tried so often to become ground. */
  #commit(tries?: Tries): void {
    this.#show(this.#world.commit())
    const before = this.#rocks.count
    while (this.#takeLoose(tries)) this.#show(this.#world.commit())
    this.#rocks.makeFrom(before)
  }

  #takeLoose(tries?: Tries): boolean {
    if (!this.#options.anchors) return false
    if (this.canRedo) {
      this.#looksAtAll = true
      return false
    }
    const ids = this.#looksAtAll ? this.#islands.all() : this.#islands.loose(), before = this.#rocks.count
    this.#looksAtAll = false
    for (const id of ids)
      if (this.#islands.island(id)?.anchors === 0) this.#rocks.add(this.#islands.take(id), this.#now, tries)
    return this.#rocks.count !== before
  }

  /** Whether one did. */
  #becameGround(tries: Tries | null): boolean {
    if (tries === null) return false
    this.#dropFuture()
    this.#commit(tries)
    return true
  }

  // --- Undo

  #go(to: number): true {
    const mark = this.#marks[to - this.#oldest]!
    const changes = to < this.#now ? this.#world.rollBack(mark, 'keep') : this.#world.redo(mark)
    this.#now = to
    this.#rocks.leave(to)
    if (this.#window.cells !== everywhere) this.#looksAtAll = true  // what held something may have left or come in since
    this.#show(changes)
    this.#rocks.comeBack(to)
    if (this.#window.remakeLand(this.#world, to, this.#dropFuture)) {
      this.#commit()
      this.#keepLand()
    } else if (!this.canRedo && this.#looksAtAll) {
      this.#commit()
    }
    return true
  }

  /** Before an edit is kept: what was undone can not come back, and what was made again stays. */
  readonly #dropFuture = (): void => {
    this.#marks.length = this.#now - this.#oldest + 1
    this.#rocks.dropFuture(this.#now)
  }

  #mark(): void {
    this.#marks.push(this.#world.mark())
    ++this.#now
    if (this.#marks.length > this.#undoSteps + 1) this.#forgetOldest()
  }

  #forgetOldest(): void {
    this.#world.forget(this.#marks.shift()!)
    ++this.#oldest
    this.#rocks.forgetBefore(this.#oldest)
    this.#window.forgetBefore(this.#oldest)
  }
}
