// Reads the words of a trace. Each line is an edit; those of `lgs-trace 4` are any call of the engine (oracle/trace/trace.h
// has the grammar). A call that this package has not is refused here, so what is read can be played.
import { LgsError } from './error.js'
import type { Block, CellRect, Region } from './types.js'

/** A polygon that a call names: by the name that another call gave it, or as one of those that stand in a cell or were
 *  ever placed; `nth` is modulo how many these are. */
export type Named =
  | { readonly by: 'name'; readonly name: string }
  | { readonly by: 'cell'; readonly i: number; readonly j: number; readonly nth: number | 'all' }
  | { readonly by: 'given'; readonly nth: number }

/** What a call places: x, y, x, y, … in cells, from the cell's lower left corner; or a shape by an id, which need not be
 *  one. */
export type TraceShape = { readonly vertices: readonly number[] } | { readonly id: number }
export interface Coming {
  readonly i: number
  readonly j: number
  readonly block: Block
  readonly shape: TraceShape
  readonly name: string | null
}

export type Edit = { readonly line: number } & (
  | { readonly kind: 'add'; readonly name: string | null; readonly i: number; readonly j: number; readonly block: Block;
      /** x, y, x, y, … in cells, from the cell's lower left corner. */
      readonly vertices: readonly number[] }
  | { readonly kind: 'remove'; readonly goes: Named }
  | { readonly kind: 'commit' | 'load' | 'mark' }
  | { readonly kind: 'paint'; readonly block: Block; readonly mode: 'fill' | 'replace'; readonly region: Region }
  | { readonly kind: 'carve'; readonly region: Region }
  | { readonly kind: 'shape'; readonly shape: TraceShape }
  | { readonly kind: 'place' | 'replace'; readonly comes: Coming }
  | { readonly kind: 'many'; readonly comes: readonly Coming[] }
  | { readonly kind: 'removeMany'; readonly goes: readonly Named[] }
  | { readonly kind: 'setBlock'; readonly goes: Named; readonly block: Block }
  | { readonly kind: 'fill'; readonly cells: CellRect; readonly block: Block; readonly shape: TraceShape }
  | { readonly kind: 'clear' | 'unload' | 'reloadEmpty'; readonly cells: CellRect }
  | { readonly kind: 'reload'; readonly cells: CellRect; readonly isBackwards: boolean }
  /** Marks are counted from the oldest, those ahead from the last, modulo how many there are. */
  | { readonly kind: 'back'; readonly mark: number; readonly undone: 'drop' | 'keep' }
  | { readonly kind: 'forward' | 'forget'; readonly mark: number }
  | { readonly kind: 'repeat'; readonly times: number; readonly edits: readonly Edit[] }
)

export const badTrace = (line: number, what: string) => new LgsError('bad-trace', `line ${line}: ${what}`, { line })

/** Calls of C++ that this package has not. */
const others: Record<string, string> = {
  exchange: 'exchange()', group: 'groups of edits', copy: 'copies of a world', leave: 'forgetChunks()',
  take: 'bodies in a trace', put: 'bodies in a trace', foresee: 'foresee() in a trace',
}
const isReal = (word: string) => /^[-+.\d]/.test(word)

/** The words of a line, read one after the other. */
export class Words {
  #at = 1
  constructor(readonly line: number, readonly words: readonly string[]) {}

  fail(what: string): LgsError { return badTrace(this.line, what) }
  get verb(): string { return this.words[0]! }
  get isAtEnd(): boolean { return this.#at >= this.words.length }
  take(word: string): boolean {
    const isIt = this.words[this.#at] === word
    if (isIt) ++this.#at
    return isIt
  }
  word(what: string): string {
    if (this.isAtEnd) throw this.fail(`${this.verb} ends before ${what}`)
    return this.words[this.#at++]!
  }
  integer(what: string): number {
    const word = this.word(what)
    if (!/^-?\d+$/.test(word)) throw this.fail(`${what} must be a whole number`)
    return Number(word)
  }
  /** A number that may be left out. */
  count(): number { return this.isAtEnd || !/^\d+$/.test(this.words[this.#at]!) ? 0 : this.integer('the number') }
  rect(): CellRect {
    const [i0, j0, i1, j1] = ['i', 'j', 'the last i', 'the last j'].map((what) => this.integer(what)) as [number, number, number, number]
    return { i0, j0, i1, j1 }
  }
  /** Coordinates up to another word, or to the end. */
  coordinates(): number[] {
    const numbers: number[] = []
    while (!this.isAtEnd && isReal(this.words[this.#at]!)) numbers.push(this.#coordinate(this.words[this.#at++]!))
    if (numbers.length % 2 !== 0) throw this.fail('coordinates come in pairs, and one is left')
    return numbers
  }
  /** A decimal, or a fraction of two integers. */
  #coordinate(word: string): number {
    const parts = /^([-+]?\d+)\/(\d+)$/.exec(word)
    if (parts && Number(parts[2]) !== 0) return Number(parts[1]) / Number(parts[2])
    if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word)) return Number(word)
    throw this.fail(`'${word}' is no coordinate: it must be a decimal or a fraction of integers`)
  }
  /** Rings are parted by |. Inside is where they run around an odd number of times. */
  region(): Region {
    const rings = [this.coordinates()]
    while (this.take('|')) rings.push(this.coordinates())
    const rule = this.take('united') ? 'nonZero' : 'evenOdd'
    if (this.take('around')) throw this.lacks('strokes around blocks that stay')
    return { rings, rule }
  }
  polygon(): number[] { return this.take('none') ? [] : this.coordinates() }
  shape(): TraceShape {
    if (this.take('id')) return { id: this.integer('the id') }
    const vertices = this.polygon()
    if (this.take('|')) throw this.lacks('shapes of several polygons')
    return { vertices }
  }
  coming(): Coming {
    const [i, j, block] = [this.integer('i'), this.integer('j'), this.integer('the block')], shape = this.shape()
    const name = this.take('as') ? this.word('the name') : null
    if (name !== null && 'id' in shape) throw this.fail('more names than polygons')
    return { i, j, block, shape, name }
  }
  named(): Named {
    const word = this.word('the polygon'), parts = /^(.*)#(.*)$/.exec(word)
    if (!parts) return { by: 'name', name: word }
    const [, of, which] = parts as unknown as [string, string, string], cell = /^(-?\d+):(-?\d+)$/.exec(of)
    if (of === 'beside' || of === 'handle') throw this.lacks('handles that it has not given out')
    const nth = which === 'all' && cell ? 'all' : Number(which)
    if (nth !== 'all' && !/^\d+$/.test(which)) throw this.fail(`'${word}' names no polygon`)
    if (cell) return { by: 'cell', i: Number(cell[1]), j: Number(cell[2]), nth }
    if (of !== 'given' || nth === 'all') throw this.fail(`'${word}' names no polygon`)
    return { by: 'given', nth }
  }
  /** In C++ there are several ways to hand over a polygon, and here one, which gives the same. */
  end(): void {
    if (this.take('in')) {
      this.word('the notation')
      if (this.count() !== 0) throw this.lacks('coordinates beside the lattice in this notation')
    }
    if (this.take('room')) throw this.lacks('room for handles')
    if (!this.isAtEnd) throw this.fail(`'${this.words[this.#at]}' is too much for ${this.verb}`)
  }
  lacks(what: string): LgsError { return this.fail(`JavaScript has no ${what}: the lgs command plays this line`) }
}

/** An edit that any version has. */
function plain(words: Words): Edit | null {
  const { verb, line } = words
  switch (verb) {
    case 'add': {
      if (words.words.length < 5) throw words.fail('add needs a name, i, j, a block and vertices')
      const name = words.word('the name')
      const [i, j, block] = [words.integer('i'), words.integer('j'), words.integer('the block')]
      return { kind: 'add', line, name, i, j, block, vertices: words.coordinates() }
    }
    case 'remove':
      return { kind: 'remove', line, goes: { by: 'name', name: words.word('the name') } }
    case 'commit':
      return { kind: 'commit', line }
    case 'carve':
      return { kind: 'carve', line, region: words.region() }
    case 'paint': {
      const block = words.integer('the block'), mode = words.word("'fill' or 'replace'")
      if (mode !== 'fill' && mode !== 'replace') throw words.fail("paint needs a block, and 'fill' or 'replace'")
      return { kind: 'paint', line, block, mode, region: words.region() }
    }
    default:
      return null
  }
}

/** An edit that version 4 alone has, or has in a wider form. `edits` reads the lines up to an `end`. */
function call(words: Words, edits: () => readonly Edit[]): Edit | null {
  const { verb, line } = words
  switch (verb) {
    case 'add': {
      const name = words.word('the name'), [i, j, block] = [words.integer('i'), words.integer('j'), words.integer('the block')]
      return { kind: 'add', line, name: name === '-' ? null : name, i, j, block, vertices: words.polygon() }
    }
    case 'remove':
      return { kind: 'remove', line, goes: words.named() }
    case 'commit':
      words.count()  // C++ can be told to commit on several threads
      return { kind: 'commit', line }
    case 'mark':
    case 'load':
      return { kind: verb, line }
    case 'shape':
      return { kind: 'shape', line, shape: words.shape() }
    case 'place':
    case 'replace':
      return { kind: verb, line, comes: words.coming() }
    case 'many': {
      const comes: Coming[] = []
      if (!words.isAtEnd) do comes.push(words.coming())
      while (words.take(';'))
      return { kind: 'many', line, comes }
    }
    case 'removeMany': {
      const goes: Named[] = []
      while (!words.isAtEnd) goes.push(words.named())
      return { kind: 'removeMany', line, goes }
    }
    case 'setBlock':
      return { kind: 'setBlock', line, goes: words.named(), block: words.integer('the block') }
    case 'fill':
      return { kind: 'fill', line, cells: words.rect(), block: words.integer('the block'), shape: words.shape() }
    case 'clear':
    case 'unload':
    case 'reloadEmpty':
      return { kind: verb, line, cells: words.rect() }
    case 'reload':
      return { kind: 'reload', line, cells: words.rect(), isBackwards: words.count() % 2 !== 0 }
    case 'back':
      return { kind: 'back', line, mark: words.integer('the mark'), undone: words.take('keep') ? 'keep' : 'drop' }
    case 'forward':
    case 'forget':
      return { kind: verb, line, mark: words.integer('the mark') }
    case 'repeat': {
      const times = words.integer('the number')
      if (times < 0 || times > 1000) throw words.fail('calls are repeated 1000 times at most')
      return { kind: 'repeat', line, times, edits: edits() }
    }
    default:
      return plain(words)
  }
}

/** The edit of a line of a trace of this version. */
export function editOf(words: Words, version: number, edits: () => readonly Edit[]): Edit {
  const { verb } = words
  if (version === 1 && (verb === 'paint' || verb === 'carve')) throw words.fail(`${verb} needs 'lgs-trace 2' in the first line`)
  if (version === 4 && verb in others) throw words.lacks(others[verb]!)
  const edit = version === 4 ? call(words, edits) : plain(words)
  if (!edit) throw words.fail(`'${verb}' is no edit: add, remove, commit, paint or carve${version === 4 ? ', or a call of the engine' : ''}`)
  words.end()
  return edit
}
