// Arguments, before they go into WebAssembly. There a number of the wrong kind would be cut to another one.
import { LgsError } from './error.js'
import type { CellRect, Vertices } from './types.js'

const shown = (value: unknown) =>
  typeof value === 'string' ? JSON.stringify(value) : Object(value) === value ? 'an object' : String(value)

export function bad(name: string, wanted: string, value: unknown): LgsError {
  return new LgsError('bad-argument', `${name} must be ${wanted}, and is ${shown(value)}`)
}

/** A column or row of cells. */
export function int32(name: string, value: number): number {
  if (typeof value !== 'number' || (value | 0) !== value) throw bad(name, 'a whole number of 32 bits', value)
  return value
}

/** A block, or the id of a shape or a segment. */
export function uint32(name: string, value: number): number {
  if (typeof value !== 'number' || value >>> 0 !== value) throw bad(name, 'a whole number from 0 to 4294967295', value)
  return value
}

export function real(name: string, value: number): number {
  if (typeof value !== 'number') throw bad(name, 'a number', value)
  return value
}

export function finite(name: string, value: number): number {
  if (!Number.isFinite(value)) throw bad(name, 'a finite number', value)
  return value
}

/** Options, changes, places: whatever has names. */
export function object<T extends object>(name: string, wanted: string, value: T): T {
  if (typeof value !== 'object' || value === null) throw bad(name, wanted, value)
  return value
}

/** What a function of the game gives: no promise. */
export function atOnce<T>(name: string, wanted: string, value: T): T {
  if (typeof (value as PromiseLike<unknown> | null)?.then === 'function') throw bad(name, `${wanted}, and no promise,`, value)
  return value
}

/** Options, all of them known: a word that is misspelt would say nothing. */
export function options<T extends object>(name: string, known: readonly (keyof T & string)[], value: T): T {
  object(name, `{ ${known.join(', ')} }`, value)
  const unknown = Object.keys(value).find((key) => !(known as readonly string[]).includes(key))
  if (unknown !== undefined) throw new LgsError('bad-argument', `${name} has no '${unknown}', but ${known.join(', ')}`)
  return value
}

/** A mark: a number that mark() gave. */
export function whole(name: string, value: number): number {
  if (!Number.isSafeInteger(value) || value < 0) throw bad(name, 'a mark of this world', value)
  return value
}

/** A length in metres, or a number of cells, of the options of a terrain. */
export function within(name: string, value: number, least: number, most: number): number {
  if (typeof value !== 'number' || !(value >= least && value <= most)) throw bad(name, `a number from ${least} to ${most}`, value)
  return value
}

export function rect(cells: CellRect): CellRect {
  object('cells', '{ i0, j0, i1, j1 }', cells)
  return { i0: int32('i0', cells.i0), j0: int32('j0', cells.j0), i1: int32('i1', cells.i1), j1: int32('j1', cells.j1) }
}

/**
 * A copy of an array of numbers, each read once: a getter may give another one later, or free the world. And an array
 * in the memory of WebAssembly is empty once that has grown.
 */
export function reals(name: string, from: ArrayLike<number>, wanted = 'an array of numbers'): number[] {
  const length: unknown = typeof from === 'object' ? from?.length : null
  if (typeof length !== 'number') throw bad(name, wanted, from)
  const numbers: number[] = []
  for (let k = 0; k < length; ++k) {
    const value: unknown = from[k]
    if (typeof value !== 'number') throw bad(`${name}[${k}]`, 'a number', value)
    numbers.push(value)
  }
  return numbers
}

/** x, y, x, y, … of either form of vertices. */
export function flat(name: string, vertices: Vertices): number[] {
  if (Array.isArray(vertices?.[0])) {
    const pairs = vertices as readonly (readonly [number, number])[]
    const numbers: number[] = []
    for (let k = 0, { length } = pairs; k < length; ++k) {
      const pair = pairs[k]
      if (!Array.isArray(pair) || pair.length !== 2) throw bad(`${name}[${k}]`, 'a pair of numbers', pair)
      numbers.push(real(`${name}[${k}][0]`, pair[0]), real(`${name}[${k}][1]`, pair[1]))
    }
    return numbers
  }
  const numbers = reals(name, vertices as ArrayLike<number>, 'an array of numbers, or of pairs')
  if (numbers.length % 2 !== 0) throw bad(`the length of ${name}`, 'even: x, y, x, y, …', numbers.length)
  return numbers
}
