// Recomputes the outline of the whole world with polygon-clipping, as an engine without local edits must do.
import polygonClipping, { type Polygon } from 'polygon-clipping'
import { differences } from './outline-compare.js'
import type { Answer, Question } from './recompute.js'

addEventListener('message', (event: MessageEvent<Question>) => {
  const polygons = unpack(event.data.polygons)
  let answer: Answer
  try {
    const start = performance.now()
    const united = polygons.length === 0 ? [] : polygonClipping.union(polygons[0], ...polygons.slice(1))
    const time = performance.now() - start
    const found = event.data.outline === null ? null : differences(event.data.outline, edgesOf(united))
    answer = { time, differences: found, error: null }
  } catch (error) {
    answer = { time: 0, differences: null, error: String(error) }
  }
  postMessage(answer)
})

// The number of vertices of each polygon, then x, y of each vertex.
function unpack(packed: Float64Array): Polygon[] {
  const polygons: Polygon[] = []
  for (let k = 0; k < packed.length; ) {
    const ring: [number, number][] = []
    const end = k + 1 + 2 * packed[k]
    for (++k; k < end; k += 2) ring.push([packed[k], packed[k + 1]])
    polygons.push([ring])
  }
  return polygons
}

function edgesOf(united: readonly Polygon[]): number[] {
  const edges: number[] = []
  for (const polygon of united) {
    for (const ring of polygon) {
      for (let k = 1; k < ring.length; ++k) edges.push(...ring[k - 1], ...ring[k])
    }
  }
  return edges
}
