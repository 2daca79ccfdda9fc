// Edges are cut at vertices: a wedge whose tip slides along a wall.
import { createWorld } from 'localgridseg'
import { counted, grid, outline, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { type Point, words } from '../svg.js'

const reach = 3 / 32 // cells: nearer than this the tip goes to the wall, and on the wall to its corner

export default function cuts(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.6, y0: -0.4, x1: 3.6, y1: 1.4 }, 'A wedge whose tip touches a wall')
  const world = createWorld()
  world.addPolygon(0, 0, square, 1)
  world.addPolygon(1, 0, [[0, 0.5], [1, 0.2], [1, 0.8]], 2)
  const layer = fig.layer()
  const tip = fig.handle({
    at: [1, 0.5],
    label: 'The tip of the wedge',
    step: 1 / 8,
    move(x, y) {
      const isAtWall = x < 1 + reach
      const height = clamp(y, 0, 1)
      const isAtCorner = isAtWall && Math.abs(height - Math.round(height)) < reach
      const to: Point = [isAtWall ? 1 : clamp(x, 1, 1.8), isAtCorner ? Math.round(height) : height]
      world.clear(1, 0)
      world.addPolygon(1, 0, [[to[0] - 1, to[1]], [1, 0.2], [1, 0.8]], 2)
      return to
    },
  })
  fig.draws(() => {
    world.commit()
    const segments = segmentsOf(world)
    const wall = segments.filter(({ start, end }) => start[0] === 1 && end[0] === 1).sort((a, b) => a.start[1] - b.start[1])
    layer.replaceChildren(
      ...grid(-0.6, -0.4, 3.6, 1.4),
      ...solids(world),
      ...outline(segments, fig.pixel),
      ...wall.map(({ start, end }, k) => words('mark', [1 - 15 * fig.pixel, (start[1] + end[1]) / 2 - 5 * fig.pixel], 15 * fig.pixel, `${k + 1}`)),
    )
    const where = tip.at[0] > 1 ? 'The tip is free' : tip.at[1] % 1 === 0 ? 'The tip is at a corner' : 'The tip touches the wall'
    fig.say(`${where}: the wall is ${counted(wall.length, 'piece')}.`)
  })
}
