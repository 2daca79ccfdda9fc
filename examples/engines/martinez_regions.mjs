// martinez-polygon-clipping as an engine of regions for `lgs check --engine`. What is solid is kept in doubles.
//
//     npm ci --prefix examples/engines
//     lgs check --engine 'node examples/engines/martinez_regions.mjs' --edits 500
import { diff, union, xor } from 'martinez-polygon-clipping'
import { serve, trianglesOf } from './regions.mjs'

const closed = (ring) => [...ring, ring[0]]
const added = (call) => (a, b) => (a.length && b.length ? call(a, b) ?? [] : [...a, ...b]) // it takes nothing empty

// Its rings touch themselves in a vertex, and then their parts need not run the same way around.
function loopsOf(ring) {
  const loops = [], path = []
  for (const p of ring.slice(1)) {
    const first = path.findIndex((q) => q[0] === p[0] && q[1] === p[1])
    if (first >= 0) loops.push(path.splice(first))
    path.push(p)
  }
  return [...loops, path]
}

const isInside = ([x, y], loops) => loops.flatMap((loop) => loop.filter(([ax, ay], k) => {
  const [bx, by] = loop[(k + 1) % loop.length]
  return (ay > y) !== (by > y) && x < ax + (y - ay) * (bx - ax) / (by - ay)
})).length % 2 === 1

// A place a little to the left of the longest side says which way around it is.
function turned(loop, loops) {
  const sides = loop.map((a, k) => ({ a, b: loop[(k + 1) % loop.length] }))
    .map(({ a, b }) => ({ a, dx: b[0] - a[0], dy: b[1] - a[1], length: Math.hypot(b[0] - a[0], b[1] - a[1]) }))
  const { a, dx, dy, length } = sides.reduce((one, other) => (other.length > one.length ? other : one))
  return isInside([a[0] + dx / 2 - dy / length / 64, a[1] + dy / 2 + dx / length / 64], loops) ? loop : [...loop].reverse()
}

serve({
  greeting: 'martinez regions slants round=1',
  nothing: [],
  regionOf: (rings) => trianglesOf(rings).reduce((region, triangle) => added(xor)(region, [[closed(triangle)]]), []),
  unite: added(union),
  subtract: (a, b) => (a.length && b.length ? diff(a, b) ?? [] : a),
  ringsOf(solid) {
    const loops = solid.flat().flatMap(loopsOf)
    return loops.map((loop) => turned(loop, loops))
  },
})
