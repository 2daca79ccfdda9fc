// The naive reference of the harness, in a WebAssembly of its own: web/wasm/reference.cpp.
import type { Polygon } from 'localgridseg'
import type { Point } from './svg.js'

const units = 65536

interface Exports {
  memory: WebAssembly.Memory
  _initialize(): void
  input(count: number): number
  outline(): number
  answer(): number
}

/** An edge of an outline: its ends and ghosts, eight numbers, and its block. As text two outlines can be compared. */
export interface Edge {
  readonly start: Point
  readonly end: Point
  readonly ghost1: Point
  readonly ghost2: Point
  readonly key: string
}

export type Reference = (polygons: readonly Polygon[]) => Edge[]

export async function loadReference(): Promise<Reference> {
  const bytes = await (await fetch('reference.wasm')).arrayBuffer()
  const closed = () => 8
  const system = { fd_close: closed, fd_seek: closed, fd_write: closed }
  const { instance } = await WebAssembly.instantiate(bytes, { wasi_snapshot_preview1: system })
  const { memory, _initialize, input, outline, answer } = instance.exports as unknown as Exports
  _initialize()
  return (polygons) => {
    const numbers = polygons.flatMap(({ i, j, block, vertices }) => [
      i,
      j,
      block,
      vertices.length / 2,
      ...[...vertices].map((x) => Math.round(x * units)),
    ])
    const address = input(numbers.length)
    new Float64Array(memory.buffer, address, numbers.length).set(numbers)
    const count = outline()
    return edges(new Float64Array(memory.buffer, answer(), 9 * count))
  }
}

/** Nine numbers an edge. */
export function edges(numbers: Float64Array): Edge[] {
  return Array.from({ length: numbers.length / 9 }, (_, k) => {
    const nine = [...numbers.subarray(9 * k, 9 * k + 9)]
    const at = (n: number): Point => [nine[n], nine[n + 1]]
    return { start: at(0), end: at(2), ghost1: at(4), ghost2: at(6), key: nine.join(' ') }
  })
}
