// Opposite edges cancel: a tile is dragged onto its neighbours.
import { createWorld, type PolygonId, type World } from 'localgridseg'
import { counted, grid, outline, type Seen, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arrow, path, type Point } from '../svg.js'

const columns = 7
const rows = 4
const fixed: readonly Point[] = [[2, 0], [3, 0], [4, 0], [2, 1]]
const half: readonly Point[] = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
const moves = 2 // the block of the tile that moves

export default function cancel(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.2, y0: -0.2, x1: columns + 0.2, y1: rows + 0.2 }, 'Tiles, one of which moves')
  // The second world preserves everything: it shows the edges before they cancel.
  const worlds = [createWorld(), createWorld({ preserve: () => true })]
  for (const world of worlds) for (const [i, j] of fixed) world.addPolygon(i, j, square, 1)
  let shape = square
  let cell: Point = [5, 2]
  let loose: Point | null = null // where the tile is while it is dragged
  const add = (world: World): PolygonId => world.addPolygon(...cell, shape, moves)
  let placed = worlds.map(add)
  const layer = fig.layer()

  const place = (to: Point) => {
    worlds.forEach((world, k) => world.remove(placed[k]))
    cell = to
    placed = worlds.map(add)
  }
  const handle = fig.handle({
    at: [5.5, 2.5],
    label: 'The tile that moves',
    step: 1,
    move(x, y) {
      loose = [clamp(x, 0.5, columns - 0.5), clamp(y, 0.5, rows - 0.5)]
      const to: Point = [Math.floor(loose[0]), Math.floor(loose[1])]
      if (!fixed.some(([i, j]) => i === to[0] && j === to[1])) place(to)
      return loose
    },
    drop() {
      loose = null
      handle.at = [cell[0] + 0.5, cell[1] + 0.5]
    },
  })
  fig.toggle('Half a tile', false, (isOn) => {
    shape = isOn ? half : square
    place(cell)
    fig.redraw()
  })
  fig.draws(() => {
    for (const each of worlds) each.commit()
    const left = segmentsOf(worlds[0])
    const keys = new Set(left.map(keyOf))
    const gone = segmentsOf(worlds[1]).filter((segment) => !keys.has(keyOf(segment)))
    const parts: SVGElement[] = [...grid(0, 0, columns, rows), ...solids(worlds[0]), ...outline(left, fig.pixel)]
    for (const { start, end } of gone) parts.push(arrow('gone', start, end, 8 * fig.pixel, -5 * fig.pixel))
    if (loose !== null) {
      const [x, y] = [loose[0] - 0.5, loose[1] - 0.5]
      parts.push(path('lifted', shape.map(([sx, sy]): Point => [x + sx, y + sy]), true))
    }
    layer.replaceChildren(...parts)
    fig.say(`${counted(gone.length / 2, 'pair')} of opposite edges cancelled. ${counted(left.length, 'segment')} left.`)
  })
}

const keyOf = ({ start, end }: Seen) => `${start} ${end}`
