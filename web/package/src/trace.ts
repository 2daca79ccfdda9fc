// Traces: edits as text, in the format that the `lgs` command takes. `lgs replay --check` compares what they lead to with
// CGAL. And the dump format: the outline, a line a segment.
//
//   const world = createWorld({ preserve: preserveOf(trace) })
//   const player = new TracePlayer(world)
//   for (const edit of trace.edits) player.apply(edit)
//   world.commit()
import { bad, object } from './check.js'
import { LgsError } from './error.js'
import type { Block, PolygonId, Region, World } from './types.js'
import { placeOf } from './world.js'

export type Edit = { readonly line: number } & (
  | { readonly kind: 'add'; readonly name: string; readonly i: number; readonly j: number; readonly block: Block;
      /** x, y, x, y, … in cells, from the cell's lower left corner. */
      readonly vertices: readonly number[] }
  | { readonly kind: 'remove'; readonly name: string }
  | { readonly kind: 'commit' }
  | { readonly kind: 'paint'; readonly block: Block; readonly mode: 'fill' | 'replace'; readonly region: Region }
  | { readonly kind: 'carve'; readonly region: Region }
)

export interface Trace {
  readonly preserve: readonly (readonly [Block, Block])[]
  readonly edits: readonly Edit[]
}

const badTrace = (line: number, what: string) => new LgsError('bad-trace', `line ${line}: ${what}`, { line })

/** A decimal, or a fraction of two integers. */
function coordinate(word: string, line: number): number {
  const parts = /^([-+]?\d+)\/(\d+)$/.exec(word)
  if (parts && Number(parts[2]) !== 0) return Number(parts[1]) / Number(parts[2])
  if (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word)) return Number(word)
  throw badTrace(line, `'${word}' is no coordinate: it must be a decimal or a fraction of integers`)
}

function integer(word: string | undefined, line: number, what: string): number {
  if (word === undefined || !/^-?\d+$/.test(word)) throw badTrace(line, `${what} must be a whole number`)
  return Number(word)
}

function coordinates(words: readonly string[], line: number): number[] {
  if (words.length % 2 !== 0) throw badTrace(line, 'coordinates come in pairs, and one is left')
  return words.map((word) => coordinate(word, line))
}

/** Rings are parted by |. Inside is where they run around an odd number of times. */
function region(words: readonly string[], line: number): Region {
  const rings: string[][] = [[]]
  for (const word of words) word === '|' ? rings.push([]) : rings.at(-1)!.push(word)
  return { rings: rings.map((ring) => coordinates(ring, line)), rule: 'evenOdd' }
}

function edit(words: readonly string[], line: number, hasBrushes: boolean): Edit {
  const [verb, ...rest] = words
  switch (verb) {
    case 'add':
      if (rest.length < 4) throw badTrace(line, 'add needs a name, i, j, a block and vertices')
      return {
        kind: 'add', line, name: rest[0]!, i: integer(rest[1], line, 'i'), j: integer(rest[2], line, 'j'),
        block: integer(rest[3], line, 'the block'), vertices: coordinates(rest.slice(4), line),
      }
    case 'remove':
      if (rest.length !== 1) throw badTrace(line, 'remove needs a name, and nothing more')
      return { kind: 'remove', line, name: rest[0]! }
    case 'commit':
      if (rest.length !== 0) throw badTrace(line, 'commit stands alone')
      return { kind: 'commit', line }
    case 'paint':
    case 'carve': {
      if (!hasBrushes) throw badTrace(line, `${verb} needs 'lgs-trace 2' in the first line`)
      if (verb === 'carve') return { kind: 'carve', line, region: region(rest, line) }
      const mode = rest[1]
      if (mode !== 'fill' && mode !== 'replace') throw badTrace(line, "paint needs a block, and 'fill' or 'replace'")
      return { kind: 'paint', line, block: integer(rest[0], line, 'the block'), mode, region: region(rest.slice(2), line) }
    }
    default:
      throw badTrace(line, `'${verb}' is no edit: add, remove, commit, paint or carve`)
  }
}

/** Without what comes after `by`: which of the engine's calls makes an edit, which means the same here. */
function withoutWay(words: readonly string[]): readonly string[] {
  const first: Record<string, number> = { add: 5, remove: 2, commit: 1 }
  const by = words.indexOf('by', first[words[0]!] ?? words.length)
  return by < 0 ? words : words.slice(0, by)
}

/** Reads a trace. Looks at the words alone: whether a polygon is good is seen when the trace is played. */
export function parseTrace(text: string): Trace {
  if (typeof text !== 'string') throw bad('text', 'a string', text)
  const preserve: [Block, Block][] = []
  const edits: Edit[] = []
  let version = ''
  text.split('\n').forEach((whole, index) => {
    const line = index + 1
    const words = whole.split(/[\s,]+/).filter((word) => word !== '')
    const comment = words.findIndex((word) => word.startsWith('#'))
    if (comment >= 0) words.length = comment
    if (words.length === 0) return
    if (version === '') {
      if (words[0] !== 'lgs-trace' || !/^[123]$/.test(words[1] ?? '') || words.length !== 2)
        throw badTrace(line, "a trace begins with 'lgs-trace 1', 'lgs-trace 2' or 'lgs-trace 3'")
      version = words[1]!
    } else if (words[0] === 'preserve') {
      if (edits.length > 0) throw badTrace(line, 'preserve must come before the first edit')
      if (words.length !== 3) throw badTrace(line, 'preserve needs two blocks')
      preserve.push([integer(words[1], line, 'a block'), integer(words[2], line, 'a block')])
    } else {
      edits.push(edit(version === '3' ? withoutWay(words) : words, line, version !== '1'))
    }
  })
  if (version === '') throw badTrace(1, "a trace begins with 'lgs-trace 1', 'lgs-trace 2' or 'lgs-trace 3'")
  return { preserve, edits }
}

function pairsOf(preserve: readonly (readonly [Block, Block])[]): readonly (readonly [Block, Block])[] {
  if (!Array.isArray(preserve) || !Array.from(preserve).every(Array.isArray)) throw bad('preserve', 'pairs of blocks', preserve)
  return preserve
}

/** The preserve relation of a trace, for createWorld(); undefined if it has none. */
export function preserveOf(trace: Trace): ((smaller: Block, greater: Block) => boolean) | undefined {
  const { preserve } = object('trace', 'one of parseTrace()', trace)
  const pairs = new Set(pairsOf(preserve).map(([a, b]) => `${Math.min(a, b)} ${Math.max(a, b)}`))
  if (pairs.size === 0) return undefined
  return (smaller, greater) => pairs.has(`${smaller} ${greater}`)
}

/** Plays edits on a world, and knows polygons by their names. */
export class TracePlayer {
  readonly #names = new Map<string, PolygonId>()
  readonly #ofId = new Map<PolygonId, string>()
  constructor(readonly world: World) {}

  /** An edit that the world refuses throws the world's LgsError, with the line; then nothing has changed. */
  apply(edit: Edit): void {
    object('edit', 'one of a trace', edit)
    try {
      this.#apply(edit)
    } catch (error) {
      if (!(error instanceof LgsError) || error.line !== null) throw error
      const { code, message, name: _, ...where } = error
      throw new LgsError(code, `line ${edit.line}: ${message}`, { ...where, line: edit.line })
    }
  }

  #apply(edit: Edit): void {
    switch (edit.kind) {
      case 'add': {
        if (this.#names.has(edit.name)) throw badTrace(edit.line, `the name '${edit.name}' is taken`)
        const id = this.world.addPolygon(edit.i, edit.j, edit.vertices, edit.block)
        this.#names.set(edit.name, id)
        this.#ofId.set(id, edit.name)
        break
      }
      case 'remove': {
        const id = this.#names.get(edit.name)
        if (id === undefined) throw badTrace(edit.line, `there is no polygon '${edit.name}'`)
        this.world.remove(id)
        this.#forget(id)
        break
      }
      case 'commit':
        this.world.commit()
        break
      case 'paint':
      case 'carve': {
        const { removed, changed } = edit.kind === 'carve' ? this.world.carve(edit.region)
          : this.world.paint(edit.region, edit.block, edit.mode)
        for (const id of removed) this.#forget(id)
        for (const { old } of changed) this.#forget(old)
      }
    }
  }

  #forget(id: PolygonId): void {
    const name = this.#ofId.get(id)
    if (name === undefined) return
    this.#ofId.delete(id)
    this.#names.delete(name)
  }
}

/** The world's polygons as a trace: they are its edits, and a commit. With a preserve relation, name its pairs. */
export function traceOf(world: World, preserve: readonly (readonly [Block, Block])[] = []): string {
  placeOf(world)
  const lines = ['lgs-trace 1', ...pairsOf(preserve).map(([a, b]) => `preserve ${a} ${b}`)]
  world.polygons().forEach(({ i, j, block, vertices }, k) => lines.push(`add p${k} ${i} ${j} ${block}  ${vertices.join(' ')}`))
  return [...lines, 'commit', ''].join('\n')
}

/** Lattice units, for a dump. */
const units = (cells: number) => cells * 65_536

/** The outline as of the last commit, sorted by start, end and block: what `lgs replay --dump` writes. */
export function dump(world: World): string {
  placeOf(world)
  const { length, geometry, block, predecessor, successor } = world.segments()
  const rows = Array.from({ length }, (_, k) => {
    const g = Array.from(geometry.subarray(8 * k, 8 * k + 8), units)
    const ghost = (id: number, at: number) => (id === 0 ? '- -' : `${g[at]} ${g[at + 1]}`)
    const key = [...g.slice(0, 4), block[k]!]
    const ghosts = `${ghost(predecessor[k]!, 4)} ${ghost(successor[k]!, 6)}`
    return { key, text: `segment ${g.slice(0, 4).join(' ')} ${ghosts} ${block[k]}` }
  })
  rows.sort((a, b) => {
    const at = a.key.findIndex((v, k) => v !== b.key[k])
    return at < 0 ? 0 : a.key[at]! - b.key[at]!
  })
  return rows.map(({ text }) => text + '\n').join('')
}
