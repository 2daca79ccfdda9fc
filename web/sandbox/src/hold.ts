// Where a crystal is held: the thinnest place of the soil between it and the rest of the land.
import type { World } from 'localgridseg'

const fine = 8 // points to a cell, along each side
const widest = 4 * fine // points: soil that is wider is no stem any more
const farthest = 12 * fine
const apart = 1.5 // cells between two ropes
type Point = readonly [number, number]

export interface Hold {
  /** Square cells, roughly; 0 if nothing holds it. */
  readonly width: number
  readonly places: readonly Point[]
}

/** Goes from the crystal outward, layer by layer, until the soil gets wide; and takes the smallest layer. */
export function holdOf(world: World, [x, y]: Point, crystal: number): Hold {
  const seen = new Set<number>(), key = (i: number, j: number) => i * 4096 + j
  const blockAt = (i: number, j: number) => {
    const spot = world.at(i / fine, j / fine)
    return spot.where === 'outside' ? 0 : spot.block
  }
  const spread = (from: readonly Point[], isIn: (block: number) => boolean) => from.flatMap(([i, j]) => [[1, 0], [-1, 0], [0, 1], [0, -1]].flatMap(([di, dj]): Point[] => {
    const k = key(i + di, j + dj)
    if (seen.has(k) || !isIn(blockAt(i + di, j + dj))) return []
    seen.add(k)
    return [[i + di, j + dj]]
  }))
  const all: Point[] = []
  for (let layer: Point[] = [[Math.round(x * fine), Math.round(y * fine)]]; layer.length > 0; layer = spread(layer, (block) => block === crystal)) all.push(...layer)
  let least: readonly Point[] = all
  for (let k = 0, layer = spread(all, (block) => block !== 0); k < farthest; ++k, layer = spread(layer, (block) => block !== 0)) {
    if (layer.length < least.length) least = layer
    if (layer.length === 0 || layer.length > widest) break
  }
  const sums: [number, number, number][] = []
  for (const [i, j] of least) {
    const near = sums.find(([sx, sy, n]) => Math.hypot(sx / n - i, sy / n - j) < apart * fine)
    if (near === undefined) sums.push([i, j, 1])
    else [near[0], near[1], near[2]] = [near[0] + i, near[1] + j, near[2] + 1]
  }
  return { width: least.length / fine, places: sums.map(([sx, sy, n]) => [sx / n / fine, sy / n / fine]) }
}
