// The instance of WebAssembly: there is one, for all worlds. Its functions take and return numbers; what is longer goes
// through its memory. web/wasm/ is the other side.
import { atOnce } from './check.js'
import { LgsError, engineError } from './error.js'
import type { IslandCalls } from './island-calls.js'

/** What lgs.wasm exports. Addresses are numbers. */
export interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  isMemoryOut(): number
  input(bytes: number): number
  answer(): number
  answerBytes(): number
  failure(): number
  make(relation: number, isFloat: number): number
  load(bytes: number, relation: number, isFloat: number): number
  save(world: number): number
  free(world: number): void
  shape(world: number, vertices: number): number
  shapeNumber(world: number, shape: number): number
  add(world: number, i: number, j: number, shape: number, block: number): number
  addMany(world: number, entries: number): number
  addPolygon(world: number, i: number, j: number, vertices: number, block: number): number
  remove(world: number, polygon: number): number
  removeMany(world: number, count: number): number
  replace(world: number, i: number, j: number, shape: number, block: number): number
  setBlock(world: number, polygon: number, block: number): number
  fill(world: number, i0: number, j0: number, i1: number, j1: number, shape: number, block: number): number
  clear(world: number, i0: number, j0: number, i1: number, j1: number): number
  unload(world: number, i0: number, j0: number, i1: number, j1: number): number
  reload(world: number, bytes: number): number
  reloadEmpty(world: number, i0: number, j0: number, i1: number, j1: number): number
  firstUnloaded(world: number, i0: number, j0: number, i1: number, j1: number): number
  paint(world: number, numbers: number, block: number, replace: number): number
  carve(world: number, numbers: number): number
  brushed(world: number, list: number): number
  brushChanges(world: number): number
  commit(world: number): number
  mark(world: number): number
  beginGroup(world: number): void
  endGroup(world: number, keep: number): void
  roll(world: number, mark: number, way: number): number
  forget(world: number, mark: number): number
  segments(world: number): number
  segmentsIn(world: number, i0: number, j0: number, i1: number, j1: number): number
  segment(world: number, id: number): number
  polygons(world: number): number
  polygonsIn(world: number, i0: number, j0: number, i1: number, j1: number): number
  polygon(world: number, polygon: number): number
  loops(world: number, merge: number): number
  at(world: number, x: number, y: number): number
  nearest(world: number, x: number, y: number, radius: number): number
  rayCast(world: number, x0: number, y0: number, x1: number, y1: number): number
  bounds(world: number): number
  stats(world: number): void
  version(world: number): number
  maxSegmentId(world: number): number
  circle(x: number, y: number, radius: number, corners: number): number
  rectangle(x: number, y: number, alongX: number, alongY: number, halfLength: number, halfWidth: number): number
  thickLine(points: number, radius: number, corners: number): number
  terrain(world: number, chunkCells: number, shortest: number, merge: number): number
  materialIs(terrain: number, block: number, number: number): void
  dropTerrain(terrain: number): void
  moveTerrain(terrain: number, world: number): void
  beginSync(terrain: number, what: number): number
  endSync(terrain: number, all: number): number
  chunkOf(terrain: number, chunk: number): void
  edgeOf(terrain: number, segment: number): number
  segmentAt(terrain: number, edge: number, x: number, y: number): number
  overlap(terrain: number, forms: number, numbers: number, tolerance: number): number
  released(terrain: number, forms: number, numbers: number, tolerance: number): number
  fits(terrain: number, forms: number, numbers: number, tolerance: number): number
  crossed(terrain: number, forms: number, numbers: number): number
  solids(terrain: number, points: number): void
  outlines(forms: number, numbers: number): number
  lines(world: number, i0: number, j0: number, i1: number, j1: number): number
  followCells(world: number): number
  changedCells(world: number): number
  hashes(world: number): number
  freeHashes(hashes: number): void
  updateHashes(hashes: number, world: number): number
  wholeHash(hashes: number): void
  hashesIn(hashes: number, i0: number, j0: number, i1: number, j1: number, level: number): number
  hashDifferences(a: number, b: number): number
  /** Only lgs-full.wasm has it. */
  importMap?(pathBytes: number, optionBytes: number): number
}

/** Where the importer finds files. */
export interface Files {
  read(path: string): Uint8Array | null
  list(folder: string): string[]
}

type Preserve = (smaller: number, greater: number) => boolean

/** Whether a form, by its index, is held by a block. It must not throw, and must not call the engine. */
export type Holds = (form: number, block: number) => boolean

const noFiles: Files = { read: () => null, list: () => [] }

export class Engine {
  readonly call: Exports & Partial<IslandCalls>
  #raw: Exports
  #memory: WebAssembly.Memory
  #words = new Uint32Array()
  #relations = new Map<number, Preserve>()
  #lastRelation = 0
  #isAsking = false
  #refusalOfPreserve: { error: unknown } | null = null
  #ended: LgsError | null = null

  /** Not by `new WebAssembly.Instance()`: browsers of before 2023 allow it 4 kB outside of workers. */
  static async of(module: WebAssembly.Module): Promise<Engine> {
    const closed = () => 8  // of WASI: "bad file number"
    const { exports } = await WebAssembly.instantiate(module, {
      wasi_snapshot_preview1: { fd_close: closed, fd_seek: closed, fd_write: closed },  // nothing prints
      lgs: {
        preserve: (relation: number, a: number, b: number) => engine.#ask(relation, a >>> 0, b >>> 0),
        cos: Math.cos,
        sin: Math.sin,
        holds: (form: number, block: number) => (engine.holds(form >>> 0, block >>> 0) ? 1 : 0),
        readFile: (path: number, length: number) => engine.#give(engine.#files.read(engine.#text(path, length))),
        listFolder: (path: number, length: number) =>
          engine.#give(new TextEncoder().encode(engine.#files.list(engine.#text(path, length)).join('\n'))),
      },
    })
    const engine = new Engine(exports as unknown as Exports)
    return engine
  }

  private constructor(raw: Exports) {
    this.#raw = raw
    this.#memory = raw.memory
    raw._initialize()
    const guarded: Record<string, unknown> = {}
    for (const [name, value] of Object.entries(raw))
      if (typeof value === 'function') guarded[name] = this.#guarded(value as (...a: unknown[]) => unknown)
    this.call = guarded as unknown as Exports
  }

  /** For the call of the rules of terrains that comes next. */
  holds: Holds = () => true

  get ended() { return this.#ended !== null }

  // --- Memory: it may grow in any call, and then old views are empty. So each view is made when it is needed. Above
  // 2 GiB an address comes out of a call as a negative number, which >>> 0 puts right.

  get buffer(): ArrayBuffer { return this.#memory.buffer }

  /** All memory, in words of 32 bits. Once it has grown, it is another array. */
  get words(): Uint32Array {
    if (this.#words.length === 0) this.#words = new Uint32Array(this.buffer)
    return this.#words
  }

  /** Room for arguments. */
  inputReals(count: number): Float64Array {
    const address = this.call.input(8 * count) >>> 0
    return new Float64Array(this.buffer, address, count)
  }

  /** Writes numbers as arguments, which lie elsewhere. Returns how many. */
  put(numbers: readonly number[]): number {
    this.inputReals(numbers.length).set(numbers)
    return numbers.length
  }

  /** Writes bytes as arguments, which lie elsewhere. */
  putBytes(bytes: Uint8Array): void {
    if (bytes.length > 2e9) throw new LgsError('bad-argument', 'more than 2 GB')
    this.#write(this.call.input(bytes.length), bytes)
  }

  #write(address: number, bytes: Uint8Array): void {
    new Uint8Array(this.buffer, address >>> 0, bytes.length).set(bytes)
  }

  /** The answer of the last call. It is valid until the next one. */
  answer(count: number): Float64Array {
    return new Float64Array(this.buffer, this.call.answer() >>> 0, count)
  }

  answerBytes(count: number): Uint8Array {
    return new Uint8Array(this.buffer, this.call.answerBytes() >>> 0, count).slice()
  }

  /** Why the last call was refused. */
  failure(): LgsError {
    const numbers = new Float64Array(this.buffer, this.call.failure() >>> 0, 16)
    const text = new Uint8Array(this.buffer, numbers[14], numbers[15])
    return engineError(numbers, new TextDecoder().decode(text))
  }

  // --- Files, while a map is imported

  #files = noFiles

  /** Imports with these files; nothing that they give out may throw. Returns the number of bytes of the answer. */
  importMap(path: string, options: object, files: Files): number {
    const call = this.call.importMap
    if (!call) throw new LgsError('not-ready', "the engine runs without the importer: await init() of 'localgridseg/full' before any other")
    const name = new TextEncoder().encode(path), asked = new TextEncoder().encode(JSON.stringify(options))
    const both = new Uint8Array(name.length + asked.length)
    both.set(name)
    both.set(asked, name.length)
    this.putBytes(both)
    this.#files = files
    try {
      return call(name.length, asked.length)
    } finally {
      this.#files = noFiles
    }
  }

  #text(address: number, length: number): string {
    return new TextDecoder().decode(new Uint8Array(this.buffer, address >>> 0, length))
  }

  /** Writes bytes as an input, within a call. Returns their number, or -1 for none. */
  #give(bytes: Uint8Array | null): number {
    if (!bytes) return -1
    this.#write(this.#raw.input(bytes.length), bytes)
    return bytes.length
  }

  // --- Relations

  /** Keeps a relation for the engine, and returns its number. */
  keepRelation(preserve: Preserve): number {
    const answers = new Map<number, Map<number, boolean>>()
    this.#relations.set(++this.#lastRelation, (a, b) => {
      let ofA = answers.get(a)
      if (!ofA) answers.set(a, (ofA = new Map()))
      let answer = ofA.get(b)
      if (answer === undefined) {
        ofA.set(b, false)  // what it is if preserve() throws
        ofA.set(b, (answer = Boolean(atOnce('what preserve() gives', 'true or false', preserve(a, b)))))
      }
      return answer
    })
    return this.#lastRelation
  }

  dropRelation(number: number): void { this.#relations.delete(number) }

  #ask(relation: number, a: number, b: number): number {
    this.#isAsking = true
    try {
      return this.#relations.get(relation)!(a, b) ? 1 : 0
    } catch (error) {  // it must not run through the engine
      this.#refusalOfPreserve ??= { error }
      return 0
    } finally {
      this.#isAsking = false
    }
  }

  // --- Calls that end badly

  /** A function of the engine that throws nothing but an LgsError. No function has more than seven arguments. */
  #guarded(f: (...a: unknown[]) => unknown) {
    return (a: unknown, b: unknown, c: unknown, d: unknown, e: unknown, g: unknown, h: unknown) => {
      if (this.#isAsking) throw new LgsError('busy', 'preserve() must not call the package')
      if (this.#ended) throw this.#ended
      let result: unknown
      try {
        result = f(a, b, c, d, e, g, h)
      } catch (cause) {
        this.#ended = this.#raw.isMemoryOut()
          ? new LgsError('out-of-memory', 'the memory of WebAssembly is full; init() and new worlds are needed', { cause })
          : new LgsError('crashed', 'the engine stopped, which is a bug; init() and new worlds are needed', { cause })
        throw this.#ended
      }
      if (this.#refusalOfPreserve) this.#tellOfPreserve()
      return result
    }
  }

  #tellOfPreserve(): never {
    const cause = this.#refusalOfPreserve!.error
    this.#refusalOfPreserve = null
    throw preserveFailed(cause)
  }
}

export const preserveFailed = (cause: unknown) =>
  new LgsError('preserve-failed', 'preserve() threw; the pair of blocks is cancelled from now on', { cause })

let current: Engine | null = null
let starting: Promise<void> | null = null

/** Starts the engine, unless it runs or starts already. Where that failed, or the engine stopped, it starts again. */
export function start(compile: () => Promise<WebAssembly.Module>): Promise<void> {
  if (current?.ended) current = starting = null
  starting ??= compile().then(Engine.of).then(
    (engine) => { current = engine },
    (error) => {
      starting = null
      throw error
    })
  return starting
}

export function engine(): Engine {
  if (!current) throw new LgsError('not-ready', 'await init() first')
  return current
}
