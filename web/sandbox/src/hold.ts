// Where a crystal is held: the fewest points of soil between it and the rest of the land, however it was cut before.
import type { World } from 'localgridseg'

const fine = 8 // points to a cell, along each side
const widest = 4 * fine // points side by side: soil that is wider is no stem any more, but land
const farthest = 12 * fine
const apart = 1.5 // cells between two ropes
const around = 1.5 // cells from its middle, which may be dug out: there the crystal begins
const sides = [[1, 0], [-1, 0], [0, 1], [0, -1]] as const
type Point = readonly [number, number]

export interface Hold {
  /** Square cells, roughly; 0 if nothing holds it. */
  readonly width: number
  readonly places: readonly Point[]
  /** Points of the crystal, and of what is between it and the land. */
  readonly points: readonly Point[]
}

/** Goes from the crystal outward, layer by layer, until the soil gets wide; and takes the fewest points that cut the way. */
export function holdOf(world: World, [x, y]: Point, crystal: number): Hold {
  const seen = new Set<number>()
  const blockAt = ([i, j]: Point) => {
    const spot = world.at(i / fine, j / fine)
    return spot.where === 'outside' ? 0 : spot.block
  }
  const take = (points: readonly Point[], isIn: (block: number) => boolean) => points.filter((point) => !seen.has(key(point)) && isIn(blockAt(point)) && seen.add(key(point)))
  const spread = (from: readonly Point[], isIn: (block: number) => boolean) => take(from.flatMap(besides), isIn)
  const isCrystal = (block: number) => block === crystal, isSoil = (block: number) => block !== 0

  const [ci, cj] = [Math.round(x * fine), Math.round(y * fine)], near: Point[] = [], all: Point[] = []
  for (let i = -around * fine; i <= around * fine; ++i) for (let j = -around * fine; j <= around * fine; ++j) near.push([ci + i, cj + j])
  for (let layer = take(near, isCrystal); layer.length > 0; layer = spread(layer, isCrystal)) all.push(...layer)
  const first = spread(all, isSoil), soil: Point[] = [], land: Point[] = []
  let layer = first
  for (let k = 0; k < farthest && layer.length > 0; ++k) {
    const parts = partsOf(layer), thin = parts.filter((part) => part.length <= widest).flat()
    soil.push(...thin)
    land.push(...parts.filter((part) => part.length > widest).flat())
    layer = spread(thin, isSoil)
  }
  land.push(...layer)
  const least = cutBetween(first, [...soil, ...land], new Set(land.map(key)))
  const places = partsOf(least, apart * fine).map((part) => [0, 1].map((k) => part.reduce((sum, point) => sum + point[k], 0) / part.length / fine) as unknown as Point)
  return { width: least.length / fine, places, points: [...all, ...soil].map(([i, j]) => [i / fine, j / fine]) }
}

const key = ([i, j]: Point): number => i * 4096 + j
const besides = ([i, j]: Point): Point[] => sides.map(([di, dj]) => [i + di, j + dj])

/** Points that are together, each beside another one. */
function partsOf(points: readonly Point[], far = 2): Point[][] {
  const left = new Set(points), parts: Point[][] = []
  for (const begin of left) {
    const part = [begin]
    left.delete(begin)
    for (const [i, j] of part) for (const other of left) {
      if (Math.max(Math.abs(other[0] - i), Math.abs(other[1] - j)) > far) continue
      left.delete(other)
      part.push(other)
    }
    parts.push(part)
  }
  return parts
}

/**
 * The fewest points on all ways from `first` to `land`, as near to `first` as there are so few: by Menger's theorem as many
 * as there are ways that share no point. Ways are found one by one; a new one may undo parts of those before it.
 */
function cutBetween(first: readonly Point[], all: readonly Point[], land: ReadonlySet<number>): Point[] {
  const points = new Map(all.map((point) => [key(point), point])), nexts = new Map<number, number>(), befores = new Map<number, number>()
  const begin = NaN, end = Infinity // no points
  for (;;) {
    // A place is a point as one comes to it, or, with a half more, as one leaves it.
    const from = new Map<number, number>(), places: number[] = []
    const go = (place: number, by: number) => {
      if (from.has(place)) return
      from.set(place, by)
      places.push(place)
    }
    for (const point of first) go(key(point), begin)
    let last: number | null = null
    for (const place of places) {
      const at = Math.floor(place), before = befores.get(at)
      if (place === at) {
        if (before === undefined) go(at + 0.5, place)
        else if (!Number.isNaN(before)) go(before + 0.5, place) // back along a way
        continue
      }
      if (land.has(at) && nexts.get(at) !== end) {
        last = place
        break
      }
      if (before !== undefined) go(at, place)
      for (const beside of besides(points.get(at)!).map(key)) if (points.has(beside) && nexts.get(at) !== beside) go(beside, place)
    }
    if (last === null) return all.filter((point) => from.has(key(point)) && !from.has(key(point) + 0.5))
    const steps: [number, number][] = [[last, end]]
    for (let place = last; !Number.isNaN(place); place = from.get(place)!) steps.push([from.get(place)!, place])
    const isBack = ([a, b]: [number, number]) => a === Math.floor(a) && Math.floor(b) !== a
    for (const [a, b] of steps) if (isBack([a, b])) { nexts.delete(Math.floor(b)); befores.delete(a) }
    for (const [a, b] of steps) {
      if (isBack([a, b]) || Math.floor(a) === Math.floor(b)) continue
      if (!Number.isNaN(a)) nexts.set(Math.floor(a), b)
      if (b !== end) befores.set(b, Math.floor(a))
    }
  }
}
