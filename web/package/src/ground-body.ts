// Ground that has left its world: its convex parts, what it weighs, and how it is read from and written to the engine.
import { bad, finite, int32, object, reals, uint32, within } from './check.js'
import { type Engine, engine } from './engine.js'
import { type IslandCalls, islandCalls } from './island-calls.js'
import type { ConvexPart, GroundBody, GroundPolygon, Mass } from './island-types.js'

/** The numbers of polygons, as lgs::web::inputBody() reads them. */
export function numbersOf(polygons: readonly GroundPolygon[]): number[] {
  if (!Array.isArray(polygons)) throw bad('polygons', 'an array of polygons', polygons)
  const numbers: number[] = []
  Array.from(polygons as readonly GroundPolygon[], (polygon, k) => {
    object(`polygons[${k}]`, '{ i, j, block, vertices }', polygon)
    const { i, j, block, vertices } = polygon
    const corners = reals('vertices', vertices)
    if (corners.length % 2 !== 0) throw bad('the length of vertices', 'even: x, y, x, y, …', corners.length)
    for (const corner of corners) within('a vertex', corner, 0, 1)
    numbers.push(int32('i', i), int32('j', j), uint32('block', block), corners.length / 2, ...corners)
  })
  return numbers
}

/** Writes the polygons of a body as the input of the call that comes next. */
export function putPolygons(to: Engine, body: { readonly polygons: readonly GroundPolygon[] }): number {
  return to.put(numbersOf(body?.polygons))
}

/** Of an answer that has of each body the number of its numbers, the origin, the mass and the polygons. */
export function bodiesOf(n: Float64Array): GroundBody[] {
  const bodies: GroundBody[] = []
  for (let at = 0; at < n.length; ) {
    const end = at + 1 + n[at]!, polygons: GroundPolygon[] = []
    for (let k = at + 7; k < end; ) {
      const last = k + 4 + 2 * n[k + 3]!
      polygons.push({ i: n[k]!, j: n[k + 1]!, block: n[k + 2]!, vertices: n.slice(k + 4, last) })
      k = last
    }
    bodies.push({ i: n[at + 1]!, j: n[at + 2]!, polygons, mass: massIn(n, at + 3) })
    at = end
  }
  return bodies
}

const massIn = (n: Float64Array, k: number): Mass =>
  ({ area: n[k]!, x: n[k + 1]!, y: n[k + 2]!, secondMoment: n[k + 3]! })

function withIslands(): { engine: Engine; call: IslandCalls } {
  const e = engine()
  return { engine: e, call: islandCalls(e) }
}

/**
 * Convex parts of a body, each of one block, that make it up exactly, on vertices that are there already. A part has at
 * most `maxVertices` of them (3 to 4,096). Whole cells of one block are merged to rectangles.
 */
export function convexParts(body: { readonly polygons: readonly GroundPolygon[] }, maxVertices = 8): ConvexPart[] {
  within('maxVertices', int32('maxVertices', maxVertices), 3, 4096)
  const { engine: e, call } = withIslands()
  const count = call.convexParts(putPolygons(e, body), maxVertices)
  if (count < 0) throw e.failure()
  const n = e.answer(count), parts: ConvexPart[] = []
  for (let k = 0; k < count; ) {
    const end = k + 2 + 2 * n[k + 1]!
    parts.push({ block: n[k]!, vertices: n.slice(k + 2, end) })
    k = end
  }
  return parts
}

/** What some of its polygons weigh, say those of one material, where each square cell weighs one. */
export function massOf(polygons: readonly GroundPolygon[]): Mass {
  const { engine: e, call } = withIslands()
  if (!call.massOf(putPolygons(e, { polygons }))) throw e.failure()
  return massIn(e.answer(4), 0)
}

/** Where a body lies: its origin in cells of the world, and its angle. */
export function placeIn(place: { x: number; y: number; angle: number }): [number, number, number, number] {
  object('place', '{ x, y, angle }', place)
  const { x, y, angle } = place
  finite('angle', angle)
  return [finite('x', x), finite('y', y), Math.cos(angle), Math.sin(angle)]
}
