// What a Ground is made of: its window, its bytes, and what it draws.
import { finite, int32, rect } from './check.js'
import { LgsError } from './error.js'
import { bodiesOf, numbersOf } from './ground-body.js'
import type { GroundDrawing, Motion, Shelf } from './ground-types.js'
import { islandCalls } from './island-calls.js'
import type { GroundBody } from './island-types.js'
import { linesIn } from './lines.js'
import type { CellRect, World, WorldOptions } from './types.js'
import { placeOf, worldOf } from './world.js'

const farthest = 2 ** 30
export const everywhere: CellRect = { i0: -farthest, j0: -farthest, i1: farthest, j1: farthest }

const clamped = (index: number) => Math.max(-farthest, Math.min(farthest, index))

/** The cells of the chunks that a rectangle touches, grown by some chunks. */
export function chunksAround(cells: CellRect, more = 0): CellRect {
  const { i0, j0, i1, j1 } = rect(cells), down = (index: number) => clamped((index & ~31) - 32 * more)
  const up = (index: number) => clamped((index | 31) + 32 * more)
  return { i0: down(i0), j0: down(j0), i1: up(i1), j1: up(j1) }
}

export const isSame = (a: CellRect, b: CellRect) => a.i0 === b.i0 && a.j0 === b.j0 && a.i1 === b.i1 && a.j1 === b.j1
export const contains = ({ i0, j0, i1, j1 }: CellRect, x: number, y: number) => x >= i0 && x < i1 + 1 && y >= j0 && y < j1 + 1
export const keyOf = (i: number, j: number) => `${i} ${j}`

/** Each chunk of some that are whole. */
export function* chunksIn({ i0, j0, i1, j1 }: CellRect): Generator<CellRect> {
  for (let j = j0; j <= j1; j = (j | 31) + 1)
    for (let i = i0; i <= i1; i = (i | 31) + 1) yield { i0: i, j0: j, i1: clamped(i | 31), j1: clamped(j | 31) }
}

export function shelfInMemory(): Shelf {
  const chunks = new Map<string, Uint8Array>()
  return { put: (i, j, bytes) => void chunks.set(keyOf(i, j), bytes), get: (i, j) => chunks.get(keyOf(i, j)) }
}

// --- Bytes: those of lgs::Ground in C++

type Value = Readonly<Motion> & { readonly ground: GroundBody }
export type Corner = { readonly i: number; readonly j: number }

export interface Loaded {
  readonly world: World
  readonly rocks: { readonly ground: GroundBody; readonly motion: Motion }[]
  readonly land: Corner[]
  /** What is out of the window. */
  readonly away: (Corner & { readonly bytes: Uint8Array })[]
}

/** All chunks of a world, those in memory and those on the shelf. */
export function savedGround(world: World, shelf: Shelf, rocks: readonly Value[], land: readonly Corner[]): Uint8Array {
  const { engine, address } = placeOf(world), call = islandCalls(engine), away: Corner[] = []
  const corners = engine.answer(call.unloadedChunks(address)).slice()
  for (let k = 0; k < corners.length; k += 2) away.push({ i: corners[k]!, j: corners[k + 1]! })
  const chunks = away.map(({ i, j }) => {
    const bytes = shelf.get(i, j)
    if (!bytes) throw new LgsError('unloaded', `the shelf does not give the chunk at cell (${i}, ${j})`, { cell: { i, j } })
    return bytes
  })
  const numbers = [land.length]
  for (const { i, j } of land) numbers.push(i, j)
  numbers.push(rocks.length)
  for (const { ground, x, y, angle, vx, vy, spin } of rocks) {
    const polygons = numbersOf(ground.polygons)
    for (const [name, value] of Object.entries({ x, y, angle, vx, vy, spin })) finite(`${name} of a rock`, value)
    numbers.push(x, y, Math.cos(angle), Math.sin(angle), vx, vy, spin, ground.i, ground.j, polygons.length)
    for (const number of polygons) numbers.push(number)
  }
  numbers.push(away.length)
  for (const [k, { i, j }] of away.entries()) numbers.push(i, j, chunks[k]!.length)
  const size = chunks.reduce((sum, { length }) => sum + length, 0), all = new Uint8Array(8 * numbers.length + size)
  new Float64Array(all.buffer, 0, numbers.length).set(numbers)
  let at = 8 * numbers.length
  for (const bytes of chunks) {
    all.set(bytes, at)
    at += bytes.length
  }
  engine.putBytes(all)
  const count = call.saveGround(placeOf(world).address, numbers.length, size)
  if (count < 0) throw engine.failure()
  return engine.answerBytes(count)
}

/** Reads that. */
export function loadedGround(saved: Uint8Array, window: CellRect, options: WorldOptions): Loaded {
  const { i0, j0, i1, j1 } = window, own = new Uint8Array(saved)
  const world = worldOf((engine, relation, isFloat) => {
    engine.putBytes(own)
    return islandCalls(engine).loadGround(own.length, relation, isFloat, i0, j0, i1, j1)
  }, options)
  const { engine } = placeOf(world), [count, size] = engine.answer(2) as unknown as [number, number]
  const n = engine.answer(count).slice(), bytes = engine.answerBytes(size)
  const land: Corner[] = [], rocks: Loaded['rocks'] = [], away: Loaded['away'] = []
  let at = 2
  for (let left = n[at++]!; left > 0; --left) land.push({ i: n[at++]!, j: n[at++]! })
  for (let left = n[at++]!; left > 0; --left) {
    const [x, y, cosine, sine, vx, vy, spin, length] = n.subarray(at, at + 8) as unknown as [number, number, number, number, number, number, number, number]
    const [ground] = bodiesOf(n.subarray(at + 7, (at += 8 + length)))
    rocks.push({ ground: ground!, motion: { x, y, angle: Math.atan2(sine, cosine), vx, vy, spin } })
  }
  let begin = 0
  for (let left = n[at++]!; left > 0; --left) {
    const i = n[at++]!, j = n[at++]!, end = begin + n[at++]!
    away.push({ i, j, bytes: bytes.slice(begin, end) })
    begin = end
  }
  return { world, rocks, land, away }
}

// --- Drawing

const side = 8

/** Squares that look different since they were drawn. */
export class ChangedSquares {
  readonly #corners = new Map<string, Corner>()

  /** What stands in a cell changes the outline in those around it. */
  note(i: number, j: number): void {
    for (const dj of [-1, 1])
      for (const di of [-1, 1]) {
        const corner = { i: (i + di) & -side, j: (j + dj) & -side }
        this.#corners.set(keyOf(corner.i, corner.j), corner)
      }
  }

  /** All of a world. */
  noteAll(world: World): void { for (const { i, j } of world.polygons()) this.note(i, j) }

  /** Those that the last commit or roll-back changed. */
  noteChanges(world: World): void {
    const { engine, address } = placeOf(world)
    const numbers = engine.answer(engine.call.changedCells(address))
    for (let k = 0; k < numbers.length; k += 2) this.note(numbers[k]!, numbers[k + 1]!)
  }

  /** Forgets them. */
  draw(world: World): GroundDrawing[] {
    const squares = [...this.#corners]
    this.#corners.clear()
    return squares.map(([key, { i, j }]) => {
      const cells = { i0: i, j0: j, i1: int32('i', i + side - 1), j1: j + side - 1 }
      const fills = world.polygons(cells).map(({ i, j, block, vertices }) =>
        ({ block, vertices: vertices.map((v, k) => v + (k % 2 === 0 ? i : j)) }))
      return { key, cells, fills, lines: linesIn(world, cells) }
    })
  }
}
