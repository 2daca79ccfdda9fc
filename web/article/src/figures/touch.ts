// Where two solids touch in a point: one walks along the outline, from segment to segment by its links.
import { createWorld } from 'localgridseg'
import { counted, grid, outline, type Seen, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { disc, path, type Point } from '../svg.js'

const columns = 7
const rows = 4
const pace = 1.6 // cells a second

export default function touch(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.2, y0: -0.2, x1: columns + 0.2, y1: rows + 0.2 }, 'Two solids, and a walker on their outline')
  const world = createWorld()
  world.fill({ i0: 1, j0: 0, i1: 2, j1: 1 }, world.shape(square), 1)
  const still = new Set(['1 0', '2 0', '1 1', '2 1'])
  let cell: Point = [3, 2]
  let placed = world.addPolygon(...cell, square, 2)
  let walker = { segment: 0, done: 0 }
  let walked: Point[] = []
  const layer = fig.layer()

  const handle = fig.handle({
    at: [3.5, 2.5],
    label: 'The second solid',
    step: 1,
    move(x, y) {
      const to: Point = [clamp(Math.floor(x), 0, columns - 1), clamp(Math.floor(y), 0, rows - 1)]
      if (still.has(`${to[0]} ${to[1]}`) || (to[0] === cell[0] && to[1] === cell[1])) return handle.at
      world.remove(placed)
      placed = world.addPolygon(...(cell = to), square, 2)
      world.commit()
      walker = { segment: 0, done: 0 }
      walked = []
      return [to[0] + 0.5, to[1] + 0.5]
    },
  })
  world.commit()
  const byId = () => new Map(segmentsOf(world).map((segment) => [segment.id, segment]))
  const where = ({ start, end }: Seen): Point => [
    start[0] + (end[0] - start[0]) * walker.done,
    start[1] + (end[1] - start[1]) * walker.done,
  ]
  const forward = (cells: number) => {
    const segments = byId()
    const on = segments.get(walker.segment) ?? first(segments)
    walker.segment = on.id
    if (walked.length === 0) walked.push(on.start)
    walker.done += cells / Math.hypot(on.end[0] - on.start[0], on.end[1] - on.start[1])
    if (walker.done < 1) return
    walked.push(on.end)
    walker = { segment: on.successor, done: 0 }
    if (walked.length > 40) walked = walked.slice(-40)
  }
  fig.runs(() => forward(pace / 60))
  fig.button('One segment on', () => {
    forward(100)
    fig.redraw()
  })
  fig.draws(() => {
    const segments = byId()
    const on = segments.get(walker.segment) ?? first(segments)
    const at = where(on)
    const loops = world.loops()
    layer.replaceChildren(
      ...grid(0, 0, columns, rows),
      ...solids(world),
      ...outline([...segments.values()], fig.pixel),
      path('walked', walked.length === 0 ? [at, at] : [...walked, at]),
      disc('walker', at, 8 * fig.pixel),
    )
    const corner = [...segments.values()].filter(({ start }) => [...segments.values()].some((other) => other.start !== start && `${other.start}` === `${start}`))
    const what = corner.length > 0 ? 'They touch in one point. The walk switches from one solid to the other:' : 'The walk follows the links:'
    fig.say(`${what} ${counted(loops.length, 'closed loop')}.`)
  })
}

// The walk begins on the solid that stands still.
function first(segments: Map<number, Seen>): Seen {
  return [...segments.values()].find(({ block }) => block === 1)!
}
