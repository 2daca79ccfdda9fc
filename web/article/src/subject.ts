// What is tested: an engine that makes an outline of placed polygons, the real one or the one with a bug.
import { createWorld, type World } from 'localgridseg'
import type { Point } from './svg.js'

export interface Placed {
  readonly i: number
  readonly j: number
  readonly ring: readonly Point[]
}

export type Subject = (placed: readonly Placed[]) => Promise<Float64Array>

/** Nine numbers a segment: its geometry and its block. */
export function outlineOf(world: World, placed: readonly Placed[]): Float64Array {
  for (const { i, j, ring } of placed) world.addPolygon(i, j, ring, 1)
  world.commit()
  const { geometry, block, length } = world.segments()
  const numbers = new Float64Array(9 * length)
  for (let k = 0; k < length; ++k) {
    numbers.set(geometry.subarray(8 * k, 8 * k + 8), 9 * k)
    numbers[9 * k + 8] = block[k]
  }
  return numbers
}

export const soundEngine: Subject = async (placed) => {
  const world = createWorld()
  const numbers = outlineOf(world, placed)
  world.free()
  return numbers
}

/** One question after the other. */
export function plantedEngine(): Subject {
  const worker = new Worker(new URL('engine-worker.js', import.meta.url), { type: 'module' })
  let last: Promise<unknown> = Promise.resolve()
  return (placed) => {
    const answer = last.then(
      () =>
        new Promise<Float64Array>((resolve) => {
          worker.onmessage = ({ data }: MessageEvent<Float64Array>) => resolve(data)
          worker.postMessage(placed)
        }),
    )
    last = answer
    return answer
  }
}
