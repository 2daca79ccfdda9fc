// The outline as lines.
import { rect } from './check.js'
import type { CellRect, World } from './types.js'
import { placeOf } from './world.js'

/** The lines along the outline in a rectangle of cells. A vertex where the outline goes straight on is left out. */
export function linesIn(world: World, cells: CellRect): Float64Array[] {
  const { engine, address } = placeOf(world)
  const { i0, j0, i1, j1 } = rect(cells)
  const count = engine.call.lines(address, i0, j0, i1, j1)
  const numbers = engine.answer(count), lines: Float64Array[] = []
  for (let k = 0; k < count; ) {
    const end = k + 1 + 2 * numbers[k]!
    lines.push(numbers.slice(k + 1, end))
    k = end
  }
  return lines
}
