// Traces: edits as text, in the format that the `lgs` command takes. `lgs replay --check` compares what they lead to with
// CGAL. And the dump format: the outline, a line a segment.
//
//   const player = new TracePlayer(createWorld({ preserve: preserveOf(trace) }))
//   player.play(trace)  // or player.apply(edit), one by one; and then player.world
import { bad, object } from './check.js'
import { type Edit, Words, badTrace, editOf } from './trace-text.js'
import type { Block, World } from './types.js'
import { placeOf } from './world.js'
export { TracePlayer } from './trace-player.js'
export type { Coming, Edit, Named, TraceShape } from './trace-text.js'

export interface Trace {
  readonly preserve: readonly (readonly [Block, Block])[]
  readonly edits: readonly Edit[]
  /** In `lgs-trace 4` what must be refused is a call like any other, and no fault of the trace. */
  readonly mayRefuse: boolean
}

const begins = "a trace begins with 'lgs-trace 1', 'lgs-trace 2', 'lgs-trace 3' or 'lgs-trace 4'"

const inNoRepeat = new Set(['mark', 'back', 'forward', 'forget', 'load', 'unload', 'reload', 'reloadEmpty', 'repeat'])

/** Without what comes after `by`: in version 3 that says which of the engine's calls makes an edit, which means the same. */
function withoutWay(words: readonly string[]): readonly string[] {
  const first: Record<string, number> = { add: 5, remove: 2, commit: 1 }
  const by = words.indexOf('by', first[words[0]!] ?? words.length)
  return by < 0 ? words : words.slice(0, by)
}

/** The lines that say something. */
function linesOf(text: string): Words[] {
  return text.split('\n').flatMap((whole, index) => {
    const words = whole.split(/[\s,]+/).filter((word) => word !== '')
    const comment = words.findIndex((word) => word.startsWith('#'))
    if (comment >= 0) words.length = comment
    return words.length === 0 ? [] : [new Words(index + 1, words)]
  })
}

/**
 * Reads a trace. Looks at the words alone: whether a polygon is good is seen when the trace is played. A call that this
 * package has not is refused here: groups, copies, exchange(), bodies, shapes of several polygons.
 */
export function parseTrace(text: string): Trace {
  if (typeof text !== 'string') throw bad('text', 'a string', text)
  const [first, ...lines] = linesOf(text)
  if (first?.verb !== 'lgs-trace' || !/^[1234]$/.test(first.words[1] ?? '') || first.words.length !== 2)
    throw badTrace(first?.line ?? 1, begins)
  const version = Number(first.words[1]), preserve: [Block, Block][] = []
  let at = 0
  for (; lines[at]?.verb === 'preserve'; ++at) {
    const words = lines[at]!
    preserve.push([words.integer('a block'), words.integer('a block')])
    words.end()
  }
  const editsOf = (opener: Words | null): Edit[] => {
    const edits: Edit[] = []
    while (at < lines.length) {
      const words = lines[at++]!
      if (words.verb === 'preserve') throw words.fail('preserve must come before the first edit')
      if (opener && words.verb === 'end') return edits
      if (opener && inNoRepeat.has(words.verb)) throw words.fail(`${words.verb} can not be repeated`)
      const ofVersion = version === 3 ? new Words(words.line, withoutWay(words.words)) : words
      edits.push(editOf(ofVersion, version, () => editsOf(words)))
    }
    if (opener) throw opener.fail(`${opener.verb} has no end`)
    return edits
  }
  return { preserve, edits: editsOf(null), mayRefuse: version === 4 }
}

function pairsOf(preserve: readonly (readonly [Block, Block])[]): readonly (readonly [Block, Block])[] {
  if (!Array.isArray(preserve) || !Array.from(preserve).every(Array.isArray)) throw bad('preserve', 'pairs of blocks', preserve)
  return preserve
}

/** The preserve relation of a trace, for createWorld(); undefined if it has none. */
export function preserveOf(trace: Pick<Trace, 'preserve'>): ((smaller: Block, greater: Block) => boolean) | undefined {
  const { preserve } = object('trace', 'one of parseTrace()', trace)
  const pairs = new Set(pairsOf(preserve).map(([a, b]) => `${Math.min(a, b)} ${Math.max(a, b)}`))
  if (pairs.size === 0) return undefined
  return (smaller, greater) => pairs.has(`${smaller} ${greater}`)
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
