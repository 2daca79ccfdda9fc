// Islands by a flood fill that shares no code with the library: all pairs of polygons, with whole numbers.
import assert from 'node:assert/strict'

export const bedrock = 9

/** In quarters of a cell: x, y, x, y, … */
const corners = ({ i, j, vertices }) => Array.from(vertices, (v, k) => 4 * v + 4 * (k % 2 === 0 ? i : j))

function turn(a, b, c, d, e, f) { return Math.sign((c - a) * (f - b) - (d - b) * (e - a)) }

function edgesMeet([a, b, c, d], [e, f, g, h]) {
  if (Math.max(a, c) < Math.min(e, g) || Math.max(e, g) < Math.min(a, c)) return false
  if (Math.max(b, d) < Math.min(f, h) || Math.max(f, h) < Math.min(b, d)) return false
  return turn(a, b, c, d, e, f) * turn(a, b, c, d, g, h) <= 0 && turn(e, f, g, h, a, b) * turn(e, f, g, h, c, d) <= 0
}

function edgesOf(polygon) {
  const v = corners(polygon)
  return Array.from({ length: v.length / 2 }, (_, k) => [v[2 * k], v[2 * k + 1], v[(2 * k + 2) % v.length], v[(2 * k + 3) % v.length]])
}

/** Sets of polygons that share at least a point. */
function flood(polygons) {
  const edges = polygons.map(edgesOf), left = new Set(polygons.keys()), found = []
  while (left.size > 0) {
    const [first] = left, part = [first]
    left.delete(first)
    for (const a of part)
      for (const b of [...left])
        if (edges[a].some((e) => edges[b].some((f) => edgesMeet(e, f)))) {
          left.delete(b)
          part.push(b)
        }
    found.push(part.map((k) => polygons[k]))
  }
  return found
}

export const areaOf = (polygon) => edgesOf(polygon).reduce((sum, [a, b, c, d]) => sum + a * d - b * c, 0) / 32
export const isHeld = (part) => part.some(({ block }) => block === bedrock)

export function assertIsFlood(islands, world) {
  const parts = flood(world.polygons())
  const byId = new Map(parts.map((part) => [islands.of(part[0].id), part]))
  assert.deepEqual([...byId.keys()].sort((a, b) => a - b), islands.all())
  assert.equal(byId.size, parts.length)
  for (const [id, part] of byId) {
    for (const polygon of part) assert.equal(islands.of(polygon.id), id)
    const { area, x0, y0, x1, y1, anchors } = islands.island(id)
    const xs = part.flatMap((p) => corners(p).filter((_, k) => k % 2 === 0)), ys = part.flatMap((p) => corners(p).filter((_, k) => k % 2 === 1))
    assert.deepEqual([x0, y0, x1, y1].map((v) => 4 * v), [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)])
    assert.equal(anchors, part.filter(({ block }) => block === bedrock).length)
    assert.ok(area >= part.reduce((sum, p) => sum + areaOf(p), 0), 'holes count')
  }
  return byId
}
