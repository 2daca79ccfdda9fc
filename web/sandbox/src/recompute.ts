// Asks the worker how long a full recompute of the outline takes.
import type { CellRect, World } from 'localgridseg'

export interface Answer {
  /** Of the union alone, in milliseconds. */
  readonly time: number
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
  async run(world: () => World, cells?: CellRect): Promise<Answer> {
    ++this.#waiting
    const answer = this.#last.then(() => this.#ask(world(), cells))
    this.#last = answer
    const result = await answer
    --this.#waiting
    return result
  }

  #ask(world: World, cells?: CellRect): Promise<Answer> {
    const worker = (this.#worker ??= new Worker(new URL('worker.js', import.meta.url), { type: 'module' }))
    const polygons = pack(world, cells)
    return new Promise((resolve) => {
      worker.onmessage = ({ data }: MessageEvent<Answer>) => resolve(data)
      worker.postMessage(polygons, [polygons.buffer as ArrayBuffer])
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
