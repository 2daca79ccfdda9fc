// Holes of radius 3 with 32 corners that do not meet, in full blocks. And the strongest
// neighbour at that: clipper2-wasm's difference of the cells that a hole touches.
import Clipper from 'clipper2-wasm/dist/es/clipper2z.js'
import { circle } from 'localgridseg'
import { timed } from './package-subject.mjs'
import { randomNumbers } from './scenario.mjs'

export const holes = 100
export function* hole(random) {
  for (let k = 0; k < holes; ++k) {
    const x = 8 * (k % 12) + 4 + random(65536) / 65536
    yield [x, 8 * Math.floor(k / 12) + 4 + random(65536) / 65536]
  }
}

/** A function that returns nanoseconds a hole. The package must have an engine: it makes the circles. */
export async function clipperStrokes() {
  const clipper = await Clipper()
  const path = (points) => clipper.MakePath64(BigInt64Array.from(points, (v) => BigInt(Math.round(v * 65536))))
  return () => {
    const random = randomNumbers()
    const tasks = [...hole(random)].map(([x, y]) => {
      const cells = new clipper.Paths64(), cut = new clipper.Paths64()
      for (let j = Math.floor(y - 3); j <= Math.floor(y + 3); ++j)
        for (let i = Math.floor(x - 3); i <= Math.floor(x + 3); ++i) cells.push_back(path([i, j, i + 1, j, i + 1, j + 1, i, j + 1]))
      cut.push_back(path(circle(x, y, 3, 32).rings[0]))
      return [cells, cut]
    })
    const time = timed(() => {
      for (const [cells, cut] of tasks) {
        const left = clipper.Difference64(cells, cut, clipper.FillRule.NonZero)
        for (let k = 0; k < left.size(); ++k) left.get(k).view()
        left.delete()
      }
    })
    for (const paths of tasks.flat()) paths.delete()
    return time / holes
  }
}
