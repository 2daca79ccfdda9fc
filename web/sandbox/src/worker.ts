// Recomputes the outline of the whole world with polygon-clipping, as an engine without local edits must do.
import polygonClipping, { type Polygon } from 'polygon-clipping'
import type { Answer } from './recompute.js'

addEventListener('message', (event: MessageEvent<Float64Array>) => {
  const polygons = unpack(event.data)
  let answer: Answer
  try {
    const start = performance.now()
    if (polygons.length > 0) polygonClipping.union(polygons[0], ...polygons.slice(1))
    const time = performance.now() - start
    answer = { time, error: null }
  } catch (error) {
    answer = { time: 0, error: String(error) }
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
