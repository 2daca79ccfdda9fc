// The functions of a game that a Ground asks: its land, its shelf, its materials, who follows it. One that throws does not
// stop a change half way: what stands in its place is said where it is asked, the call ends, and then throws it.
import { atOnce, bad } from './check.js'
import { preserveFailed } from './engine.js'
import { LgsError } from './error.js'
import { keyOf, shelfInMemory } from './ground-parts.js'
import type { Shelf } from './ground-types.js'
import type { WorldOptions } from './types.js'

export class Asking {
  #isChanging = false
  #thrown: { readonly error: unknown } | null = null

  /** One change, all of it, in which no other one begins. Throws what was thrown first. */
  during<T>(change: () => T): T {
    if (this.#isChanging) throw new LgsError('busy', 'the ground is changing: what it calls meanwhile must not change it')
    this.#isChanging = true
    let result: T | undefined
    try {
      result = change()
    } catch (error) {
      this.#thrown ??= { error }
    }
    this.#isChanging = false
    const thrown = this.#thrown
    this.#thrown = null
    if (thrown !== null) throw thrown.error
    return result as T
  }

  /** What a function of the game gives; if it throws within a change, something else. */
  ask<T>(question: () => T, otherwise: T): T {
    if (!this.#isChanging) return question()
    try {
      return question()
    } catch (error) {
      this.#thrown ??= { error }
      return otherwise
    }
  }

  /** Options of which one function is asked so. */
  in<T extends object, Name extends keyof T & string>(options: T, name: Name, otherwise: unknown, check: (given: any) => unknown): T {
    const own = options?.[name]
    if (typeof own !== 'function') return options
    return { ...options, [name]: (...told: unknown[]) => this.ask(() => check(own.apply(options, told)), otherwise) }
  }
}

/** A pair of blocks for which it throws is cancelled, also in what is saved, and loaded again. */
export function preserving(asking: Asking, preserve: NonNullable<WorldOptions['preserve']>): NonNullable<WorldOptions['preserve']> {
  const cancelled = new Set<string>()
  return (smaller, greater) => asking.ask(() => {
    if (cancelled.has(`${smaller} ${greater}`)) return false
    try {
      return atOnce('what preserve() gives', 'true or false', preserve(smaller, greater))
    } catch (cause) {
      cancelled.add(`${smaller} ${greater}`)
      throw preserveFailed(cause)
    }
  }, false)
}

/** A shelf that takes everything: what the game's does not take is kept until it does. */
export class SafeShelf implements Shelf {
  readonly #asking: Asking
  readonly #shelf: Shelf
  readonly #kept = new Map<string, { readonly i: number; readonly j: number; readonly bytes: Uint8Array }>()

  constructor(asking: Asking, shelf: Shelf = shelfInMemory()) {
    for (const name of ['put', 'get'] as const) if (typeof shelf?.[name] !== 'function') throw bad(`shelf.${name}`, 'a function', shelf?.[name])
    this.#asking = asking
    this.#shelf = shelf
  }

  put(i: number, j: number, bytes: Uint8Array): void {
    this.#kept.set(keyOf(i, j), { i, j, bytes })
    this.#asking.ask(() => {
      this.#shelf.put(i, j, bytes)
      this.#kept.delete(keyOf(i, j))
    }, undefined)
  }

  get(i: number, j: number): Uint8Array | null {
    const kept = this.#kept.get(keyOf(i, j))
    if (kept) return kept.bytes
    return this.#asking.ask(() => {
      const bytes = this.#shelf.get(i, j) ?? null
      if (bytes !== null && !(bytes instanceof Uint8Array)) throw bad('what shelf.get() gives', 'a Uint8Array, or nothing', bytes)
      return bytes
    }, null)
  }

  putKept(): void { for (const { i, j, bytes } of [...this.#kept.values()]) this.put(i, j, bytes) }
  /** Whether nothing is kept. */
  get hasAll(): boolean { return this.#kept.size === 0 }
  /** Before other ground comes. */
  dropKept(): void { this.#kept.clear() }
}
