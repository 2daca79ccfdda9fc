// Regions for brushes: those of your own, and those that the engine makes, with integers only, so alike everywhere.
import { bad, finite, flat, int32, options } from './check.js'
import { type Engine, engine } from './engine.js'
import type { Region, Vertices } from './types.js'

/** The numbers of a region, as lgs::web::inputRegion() reads them. */
export function putRegion(to: Engine, region: Region): number {
  const { rings: given, rule = 'nonZero' } = options('region', ['rings', 'rule'], region)
  if (!Array.isArray(given)) throw bad('region', '{ rings: [vertices, …] }', region)
  if (rule !== 'nonZero' && rule !== 'evenOdd') throw bad('rule', "'nonZero' or 'evenOdd'", rule)
  const rings = Array.from(given as Vertices[], (ring, k) => flat(`rings[${k}]`, ring))  // map() leaves holes
  const count = rings.reduce((sum, ring) => sum + ring.length, 2 + rings.length)
  const numbers = to.inputReals(count)
  numbers[0] = rings.length
  numbers[1] = rule === 'evenOdd' ? 1 : 0
  let next = 2 + rings.length
  rings.forEach((ring, k) => {
    numbers[2 + k] = ring.length / 2
    numbers.set(ring, next)
    next += ring.length
  })
  return count
}

function answered(from: Engine, count: number): Region {
  const numbers = from.answer(count)
  const rings: Float64Array[] = []
  for (let k = 0; k < count; ) {
    const end = k + 1 + 2 * numbers[k]!
    rings.push(numbers.slice(k + 1, end))
    k = end
  }
  return { rings }
}

/** A length: from nothing to the most that a brush takes. What is below a lattice unit is taken for one. */
function length(name: string, value: number): number {
  if (typeof value !== 'number' || !(value >= 0 && value <= 2048)) throw bad(name, 'from 0 to 2048 cells', value)
  return value
}

function corners(value: number): number {
  if (int32('corners', value) < 1 || value > 4096) throw bad('corners', 'from 1 to 4096', value)
  return value
}

/** A circle as a polygon. `count` is rounded up to a multiple of 8. */
export function circle(x: number, y: number, radius: number, count = 32): Region {
  const e = engine()
  return answered(e, e.call.circle(finite('x', x), finite('y', y), length('radius', radius), corners(count)))
}

/** A rectangle that is turned: (alongX, alongY) is the direction of its length. */
export function rectangle(x: number, y: number, alongX: number, alongY: number, halfLength: number,
                          halfWidth: number): Region {
  const e = engine()
  return answered(e, e.call.rectangle(finite('x', x), finite('y', y), finite('alongX', alongX),
    finite('alongY', alongY), length('halfLength', halfLength), length('halfWidth', halfWidth)))
}

/** Everything within a radius of a line through points, with round joints and ends. */
export function thickLine(points: Vertices, radius: number, count = 16): Region {
  const e = engine()
  const numbers = flat('points', points)
  for (let k = 0; k < numbers.length; ++k) finite(`points[${k}]`, numbers[k]!)
  length('radius', radius)
  corners(count)
  return answered(e, e.call.thickLine(e.put(numbers) / 2, radius, count))
}
