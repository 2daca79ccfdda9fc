// Plays the edits of a trace on a world: what it must remember for that is names, marks, and the bytes of chunks.
import { bad, object } from './check.js'
import { LgsError } from './error.js'
import type { Trace } from './trace.js'
import { type Coming, type Edit, type Named, type TraceShape, badTrace } from './trace-text.js'
import type { BrushResult, CellRect, Mark, PolygonId, World } from './types.js'
import { loadWorld, optionsOf, shapeOf } from './world.js'

interface Moment {
  readonly mark: Mark
  readonly given: readonly PolygonId[]
  readonly names: ReadonlyMap<string, readonly PolygonId[]>
}

/** After these there is no world, or none that can be relied on. */
const ends = new Set<string>(['freed', 'busy', 'preserve-failed', 'out-of-memory', 'crashed'])

/** Calls after which what is ahead still is. */
const staysInTime = new Set<Edit['kind']>(['back', 'forward', 'forget', 'commit', 'repeat'])

/** Plays edits on a world, and knows polygons by their names. */
export class TracePlayer {
  #world: World
  /** The newest first. */
  #names = new Map<string, readonly PolygonId[]>()
  #given: PolygonId[] = []
  // Marks behind, in order, and those ahead, the next one last. `went` is the one that it rolled back or forward to, and
  // `leadsOn` says that nothing was done since.
  #marks: Moment[] = []
  #ahead: Moment[] = []
  #went = 0
  #leadsOn = false
  /** What chunks were unloaded as, the newest first. */
  readonly #shelf = new Map<string, { readonly i: number; readonly j: number; readonly all: Uint8Array[] }>()

  constructor(world: World) { this.#world = world }

  /** A trace that loads a world goes on in another one, and frees the one before. */
  get world(): World { return this.#world }

  /** All edits, and a commit. Refusals of `lgs-trace 4` are answers, and are passed over; others throw. */
  play(trace: Trace): void {
    const { edits, mayRefuse } = object('trace', 'one of parseTrace()', trace)
    if (!Array.isArray(edits)) throw bad('trace', 'one of parseTrace()', trace)
    for (const edit of edits) this.#play(edit, mayRefuse)
    this.#world.commit()
  }
  #play(edit: Edit, mayRefuse: boolean): void {
    if (edit.kind === 'repeat') {
      for (let k = 0; k < edit.times; ++k) for (const part of edit.edits) this.#play(part, mayRefuse)
      return
    }
    try {
      this.apply(edit)
    } catch (error) {
      if (!mayRefuse || !(error instanceof LgsError) || ends.has(error.code)) throw error
    }
  }

  /** An edit that the world refuses throws the world's LgsError, with the line; then nothing has changed. */
  apply(edit: Edit): void {
    object('edit', 'one of a trace', edit)
    const led = this.#leadsOn
    if (!staysInTime.has(edit.kind)) this.#leadsOn = false  // refused or not: it may have made a shape
    try {
      this.#apply(edit)
    } catch (error) {
      if (error instanceof LgsError && error.code === 'bad-trace') this.#leadsOn = led  // there was nothing to call
      if (error instanceof TypeError) throw bad('edit', 'one of a trace', edit)  // something of it is missing
      if (!(error instanceof LgsError) || error.line !== null) throw error
      const { code, message, name: _, ...where } = error
      throw new LgsError(code, `line ${edit.line}: ${message}`, { ...where, line: edit.line })
    }
  }

  #apply(edit: Edit): void {
    const world = this.#world
    switch (edit.kind) {
      case 'repeat':
        for (let k = 0; k < edit.times; ++k) for (const part of edit.edits) this.apply(part)
        return
      case 'mark':
        this.#marks.push({ mark: world.mark(), given: [...this.#given], names: new Map(this.#names) })
        return
      case 'back':
        return this.#back(edit.mark, edit.undone)
      case 'forward':
        return this.#forward(edit.mark)
      case 'forget':
        return this.#forget(edit.mark)
      case 'load':
        return this.#load()
      case 'commit':
        world.commit()
        return
      case 'add':
        this.#free(edit.name, edit.line)
        this.#placed(edit.name, world.addPolygon(edit.i, edit.j, edit.vertices, edit.block))
        break
      case 'shape':
        this.#shape(edit.shape)
        break
      case 'place':
      case 'replace': {
        const { i, j, block, shape, name } = edit.comes
        this.#free(name, edit.line)
        const id = this.#shape(shape)
        this.#placed(name, edit.kind === 'place' ? world.add(i, j, id, block) : world.replace(i, j, id, block))
        break
      }
      case 'many':
        this.#many(edit.comes, edit.line)
        break
      case 'remove':
        world.remove(this.#one(edit.goes, edit.line))
        break
      case 'removeMany':
        world.removeMany(edit.goes.flatMap((named) => this.#idsOf(named, edit.line)))
        break
      case 'setBlock':
        world.setBlock(this.#one(edit.goes, edit.line), edit.block)
        break
      case 'fill':
        this.#fill(edit.cells, edit.shape, edit.block)
        break
      case 'clear':
        world.clear(edit.cells)
        break
      case 'carve':
        this.#stroked(world.carve(edit.region))
        break
      case 'paint':
        this.#stroked(world.paint(edit.region, edit.block, edit.mode))
        break
      case 'unload':
        for (const { i, j, bytes } of world.unload(edit.cells)) {
          const kept = this.#shelf.get(`${i} ${j}`) ?? { i, j, all: [] }
          kept.all.unshift(bytes)
          this.#shelf.set(`${i} ${j}`, kept)
        }
        break
      case 'reload':
        this.#reload(edit.cells, edit.isBackwards)
        break
      case 'reloadEmpty':
        world.reloadEmpty(edit.cells)
    }
  }

  // --- Polygons, by names and otherwise. An id comes back for another polygon only by a roll-back, where names go, too. The newest
  // one of a name that is alive, and in memory, is the one meant.

  #stateOf(id: PolygonId): 'there' | 'unloaded' | 'gone' {
    try {
      this.#world.polygon(id)
      return 'there'
    } catch (error) {
      if (!(error instanceof LgsError) || ends.has(error.code)) throw error
      return error.code === 'unloaded' ? 'unloaded' : 'gone'
    }
  }
  #idOf(name: string): PolygonId | undefined {
    return this.#names.get(name)?.find((id) => this.#stateOf(id) === 'there')
  }
  #free(name: string | null, line: number): void {
    if (name !== null && this.#idOf(name) !== undefined) throw badTrace(line, `the name '${name}' is taken`)
  }
  #placed(name: string | null, id: PolygonId): void {
    this.#given.push(id)
    if (name === null) return
    const before = this.#names.get(name) ?? []
    this.#names.set(name, [id, ...before.filter((other) => this.#stateOf(other) !== 'gone')])
  }
  #idsOf(named: Named, line: number): PolygonId[] {
    const nth = (ids: PolygonId[], k: number) => [ids.length === 0 ? 0 : ids[k % ids.length]!]
    if (named.by === 'given') return nth(this.#given, named.nth)
    if (named.by === 'cell') {
      const ids = this.#world.polygonsAt(named.i, named.j).map(({ id }) => id)
      return named.nth === 'all' ? ids : nth(ids, named.nth)
    }
    const id = this.#idOf(named.name)
    if (id === undefined) throw badTrace(line, `there is no polygon '${named.name}'`)
    return [id]
  }
  /** 0, which is no polygon, if there is none: the world refuses it. */
  #one(named: Named, line: number): PolygonId { return this.#idsOf(named, line)[0] ?? 0 }

  // --- What is placed

  #shape(shape: TraceShape): number { return 'id' in shape ? shapeOf(this.#world, shape.id) : this.#world.shape(shape.vertices) }

  #many(comes: readonly Coming[], line: number): void {
    for (const { name } of comes) this.#free(name, line)
    const entries = comes.flatMap(({ i, j, shape, block }) => [i, j, this.#shape(shape), block])
    this.#world.addMany(Int32Array.from(entries)).forEach((id, k) => this.#placed(comes[k]!.name, id))
  }

  #fill(cells: CellRect, shape: TraceShape, block: number): void {
    if (this.#world.fill(cells, this.#shape(shape), block) === 0) return
    const last = new Map<string, PolygonId>()  // of each cell, in the order of the cells
    for (const { i, j, id } of this.#world.polygons(cells)) last.set(`${i} ${j}`, id)
    for (let j = cells.j0; j <= cells.j1; ++j) for (let i = cells.i0; i <= cells.i1; ++i) this.#placed(null, last.get(`${i} ${j}`)!)
  }

  /** What a brush makes has no name. */
  #stroked({ added, changed }: BrushResult): void {
    const made = [...added, ...changed.flatMap(({ now }) => now)]
    for (const id of made.sort((a, b) => a - b)) this.#placed(null, id)
  }

  // --- Time

  #back(nth: number, undone: 'drop' | 'keep'): void {
    if (this.#marks.length === 0) return
    const to = nth % this.#marks.length
    this.#world.rollBack(this.#marks[to]!.mark, undone)
    if (undone === 'keep') {
      if (!this.#leadsOn) this.#ahead = []
      this.#ahead.push(...this.#marks.slice(to + 1).reverse())
      this.#went = to
      this.#leadsOn = true
    } else if (to < this.#went) {
      this.#ahead = []
    } else if (to > this.#went) {
      this.#leadsOn = false
    }
    this.#marks.length = to + 1
    this.#remember(this.#marks[to]!)
  }

  #forward(nth: number): void {
    if (this.#ahead.length === 0) return
    const to = nth % this.#ahead.length
    this.#world.redo(this.#ahead[to]!.mark)
    this.#marks.length = this.#went + 1
    this.#marks.push(...this.#ahead.splice(to).reverse())
    this.#went = this.#marks.length - 1
    this.#leadsOn = true
    this.#remember(this.#marks[this.#went]!)
  }

  #remember({ given, names }: Moment): void {
    this.#given = [...given]
    this.#names = new Map(names)
  }

  #forget(nth: number): void {
    if (this.#marks.length === 0) return
    const at = nth % this.#marks.length
    this.#world.forget(this.#marks[at]!.mark)
    this.#marks.splice(at, 1)
    if (at <= this.#went || this.#marks.length === 0) this.#ahead = []
  }

  // --- Memory

  #load(): void {
    this.#world.commit()
    const loaded = loadWorld(this.#world.save(), optionsOf(this.#world))
    this.#world.free()
    this.#world = loaded
    this.#marks = []
    this.#ahead = []
    this.#went = 0
    this.#leadsOn = false
  }

  /** The newest bytes that fit: the world may have rolled back since it gave newer ones. */
  #reload({ i0, j0, i1, j1 }: CellRect, isBackwards: boolean): void {
    const chunks = [...this.#shelf.values()].filter(({ i, j }) => i0 <= i && i <= i1 && j0 <= j && j <= j1)
    chunks.sort((a, b) => (isBackwards ? -1 : 1) * (a.i - b.i || a.j - b.j))
    for (const { all } of chunks) all.find((bytes) => this.#comesBack(bytes))
  }
  #comesBack(bytes: Uint8Array): boolean {
    try {
      this.#world.reload(bytes)
      return true
    } catch (error) {
      if (error instanceof LgsError && !ends.has(error.code)) return false
      throw error
    }
  }
}
