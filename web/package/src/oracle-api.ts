// The naive reference and the checker of the harness, in a separate module of WebAssembly: beside the engine of the
// page, or without it. web/wasm/oracle.cpp is the other side.
import { bad } from './check.js'
import { LgsError } from './error.js'

interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  input(bytes: number): number
  output(): number
  outputBytes(): number
  answer(nameBytes: number, bytes: number): number
  outline(nameBytes: number, bytes: number): number
  check(nameBytes: number, bytes: number): number
  page(nameBytes: number, bytes: number): number
}

let oracle: Exports | null = null
let starting: Promise<void> | null = null

/** Unless it runs or starts already. Where that failed, or the engine stopped, it starts again. */
export function start(compile: () => Promise<WebAssembly.Module>): Promise<void> {
  starting ??= instantiate(compile).catch((error: unknown) => {
    starting = null
    throw error
  })
  return starting
}

async function instantiate(compile: () => Promise<WebAssembly.Module>): Promise<void> {
  const module = await compile(), closed = () => 8  // of WASI: "bad file number"; nothing prints
  const system = { wasi_snapshot_preview1: { fd_close: closed, fd_seek: closed, fd_write: closed } }
  const exports = (await WebAssembly.instantiate(module, system)).exports as unknown as Exports
  exports._initialize()
  oracle = exports
}

interface Said {
  readonly isRight: boolean
  readonly text: string
}

/** Calls with a text and its name. */
function ask(what: 'answer' | 'outline' | 'check' | 'page', text: string, name: string): Said {
  if (typeof text !== 'string') throw bad('text', 'a string', text)
  if (typeof name !== 'string') throw bad('name', 'a string', name)
  if (!oracle) throw new LgsError('not-ready', "await init() of 'localgridseg/oracle' first")
  const encoder = new TextEncoder(), parts = [encoder.encode(name), encoder.encode(text)] as const
  try {
    const bytes = parts[0].length + parts[1].length, at = oracle.input(bytes) >>> 0
    const input = new Uint8Array(oracle.memory.buffer, at, bytes)
    input.set(parts[0])
    input.set(parts[1], parts[0].length)
    const said = oracle[what](parts[0].length, parts[1].length)
    const output = new TextDecoder().decode(new Uint8Array(oracle.memory.buffer, oracle.output() >>> 0, oracle.outputBytes()))
    if (said < 0) throw new LgsError('bad-trace', output, said < -1 ? { line: -1 - said } : {})
    return { isRight: said === 0, text: output }
  } catch (cause) {
    if (cause instanceof LgsError) throw cause
    oracle = starting = null
    throw new LgsError('crashed', 'the engine or the reference stopped in this trace, or memory ran out; init() is needed', { cause })
  }
}

/** What `lgs oracle --oracle naive` answers to these lines (`reset`, `preserve`, `add`, `remove`, `commit`): after each
 *  commit `refused NAME REASON` for what must be refused, the outline as lines of a dump, and `end`. */
export const answer = (lines: string): string => ask('answer', lines, '').text

/** The outline that the laws demand at the end of a trace, as lines of a dump: `segment`, start, end, both ghosts in
 *  units of 1/65536 cell, and the block. Of calls that are no adds and removes the engine says what they place. */
export const outline = (trace: string): string => ask('outline', trace, 'trace').text

/** What a check found. */
export interface Checked {
  readonly isRight: boolean
  /** What is wrong and where, or what was compared: lines. */
  readonly report: string
}

/** Plays a trace with the engine that is compiled in, and holds it to the laws and the naive reference after each
 *  commit: what `lgs replay --check --oracle naive` says. Throws 'bad-trace' where an edit is rightly refused. */
export function check(trace: string, name: string = 'trace'): Checked {
  const { isRight, text } = ask('check', trace, name)
  return { isRight, report: text }
}

/** The same as a page of HTML that steps through the trace; at its end is the mismatch, if there is one. */
export const page = (trace: string, name: string = 'trace'): string => ask('page', trace, name).text
