// Asks the worker for a full recompute of the outline: how long it takes, and whether it is the same.
import type { CellRect, World } from 'localgridseg'

export interface Question {
  readonly polygons: Float64Array
  /** Edges to compare with: x, y, x, y of each; null if only the time is asked. */
  readonly outline: Float64Array | null
}

export interface Answer {
  /** Of the union alone, in milliseconds. */
  readonly time: number
  readonly differences: Float64Array | null
  /** What polygon-clipping threw, if it did. */
  readonly error: string | null
}

export class Recompute {
  #worker: Worker | null = null
  #waiting = 0
  #last: Promise<unknown> = Promise.resolve()

  get busy(): boolean {
    return this.#waiting > 0
  }

  /** One after the other, each of the world as it is when its turn comes; of all of it, or of some cells. */
  async run(world: () => World, compare: boolean, cells?: CellRect): Promise<Answer> {
    ++this.#waiting
    const answer = this.#last.then(() => this.#ask(world(), compare, cells))
    this.#last = answer
    const result = await answer
    --this.#waiting
    return result
  }

  #ask(world: World, compare: boolean, cells?: CellRect): Promise<Answer> {
    const worker = (this.#worker ??= new Worker(new URL('worker.js', import.meta.url), { type: 'module' }))
    const polygons = pack(world, cells)
    const question: Question = { polygons, outline: compare ? outlineOf(world) : null }
    return new Promise((resolve) => {
      worker.onmessage = ({ data }: MessageEvent<Answer>) => resolve(data)
      worker.postMessage(question, [polygons.buffer as ArrayBuffer])
    })
  }
}

function pack(world: World, cells?: CellRect): Float64Array {
  const numbers: number[] = []
  for (const { i, j, vertices } of world.polygons(cells)) {
    numbers.push(vertices.length / 2)
    for (let k = 0; k < vertices.length; k += 2) numbers.push(i + vertices[k], j + vertices[k + 1])
  }
  return Float64Array.from(numbers)
}

function outlineOf(world: World): Float64Array {
  const { geometry, length } = world.segments()
  const edges = new Float64Array(4 * length)
  for (let k = 0; k < length; ++k) edges.set(geometry.subarray(8 * k, 8 * k + 4), 4 * k)
  return edges
}
