// Asks the worker for a full recompute of the outline: how long it takes, and whether it is the same.
import type { World } from 'localgridseg'

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
  #answered: ((answer: Answer) => void) | null = null

  get busy(): boolean {
    return this.#answered !== null
  }

  /** While one is under way there is no other. */
  run(world: World, compare: boolean): Promise<Answer> {
    this.#worker ??= this.#start()
    const polygons = pack(world)
    const outline = compare ? outlineOf(world) : null
    const question: Question = { polygons, outline }
    this.#worker.postMessage(question, [polygons.buffer as ArrayBuffer])
    return new Promise((resolve) => {
      this.#answered = resolve
    })
  }

  #start(): Worker {
    const worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' })
    worker.addEventListener('message', (event: MessageEvent<Answer>) => {
      const resolve = this.#answered!
      this.#answered = null
      resolve(event.data)
    })
    return worker
  }
}

function pack(world: World): Float64Array {
  const numbers: number[] = []
  for (const { i, j, vertices } of world.polygons()) {
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
