// The cell and its 3x3: what lies farther away changes nothing in it.
import { createWorld } from 'localgridseg'
import { counted, grid, outline, type Seen, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arrow, disc, path, type Point, rect } from '../svg.js'

const columns = 9
const rows = 6
const shapes: readonly (readonly Point[])[] = [
  square,
  square,
  [[0, 0], [1, 0], [1, 1]],
  [[0, 0], [1, 0], [0, 1]],
  [[0, 0], [1, 0], [1, 0.5], [0, 0.5]],
]

export default function cells(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.2, y0: -0.2, x1: columns + 0.2, y1: rows + 0.2 }, 'A cell and the eight around it')
  const world = createWorld()
  let seed = 7
  const random = (n: number) => {
    seed = (seed * 1103515245 + 12345) % 2147483648
    return Math.floor((seed / 2147483648) * n)
  }
  let cell: Point = [4, 2]
  let same = 0 // how many shuffles in a row have left the cell as it was
  let changed = '' // what the last shuffle has changed
  const layer = fig.layer()
  const isNear = (i: number, j: number) => Math.abs(i - cell[0]) < 2 && Math.abs(j - cell[1]) < 2
  const fill = (where: (i: number, j: number) => boolean) => {
    for (let j = 0; j < rows; ++j) {
      for (let i = 0; i < columns; ++i) {
        if (!where(i, j)) continue
        world.clear(i, j)
        if (random(10) < 6) world.addPolygon(i, j, shapes[random(shapes.length)], 1)
      }
    }
    world.commit()
  }
  fill(() => true)
  world.clear(...cell)
  world.addPolygon(...cell, shapes[2], 1)
  world.commit()
  const own = () => segmentsOf(world).filter(({ start, end }) => isIn(start, end, cell))

  fig.handle({
    at: [4.5, 2.5],
    label: 'The cell that is looked at',
    step: 1,
    move(x, y) {
      cell = [clamp(Math.floor(x), 1, columns - 2), clamp(Math.floor(y), 1, rows - 2)]
      same = 0
      changed = ''
      return [cell[0] + 0.5, cell[1] + 0.5]
    },
  })
  const shuffle = (where: (i: number, j: number) => boolean) => {
    const before = own()
    fill(where)
    const after = own()
    const isSame = keys(after, withGhosts) === keys(before, withGhosts)
    same = isSame ? same + 1 : 0
    changed = isSame ? '' : keys(after, withoutGhosts) === keys(before, withoutGhosts) ? ' Its ghost vertices have changed.' : ' Its segments have changed.'
    fig.redraw()
  }
  fig.button('Shuffle the outside', () => shuffle((i, j) => !isNear(i, j)))
  fig.button('Shuffle the neighbours', () => shuffle((i, j) => isNear(i, j) && !(i === cell[0] && j === cell[1])))
  fig.draws(() => {
    const mine = own()
    const parts: SVGElement[] = [...grid(0, 0, columns, rows), ...solids(world), ...outline(segmentsOf(world), fig.pixel, 'segment far')]
    parts.push(rect('near', cell[0] - 1, cell[1] - 1, cell[0] + 2, cell[1] + 2), rect('own', ...cell, cell[0] + 1, cell[1] + 1))
    for (const { start, end, ghost1, ghost2 } of mine) parts.push(path('whisker', [start, ghost1]), path('whisker', [end, ghost2]))
    for (const { start, end } of mine) parts.push(arrow('chosen', start, end, 11 * fig.pixel))
    for (const { ghost1, ghost2 } of mine) parts.push(...[ghost1, ghost2].map((ghost) => disc('ghostpoint', ghost, 5 * fig.pixel)))
    layer.replaceChildren(...parts)
    const kept = same === 0 ? changed : ` Shuffled ${same === 1 ? 'once' : `${same} times`}: nothing in it has changed.`
    fig.say(`The cell has ${mine.length === 0 ? 'no segment' : `${counted(mine.length, 'segment')}, with their ghost vertices`}.${kept}`)
  })
}

const withoutGhosts = ({ start, end }: Seen) => `${start} ${end}`
const withGhosts = ({ start, end, ghost1, ghost2 }: Seen) => `${start} ${end} ${ghost1} ${ghost2}`
const keys = (segments: readonly Seen[], key: (segment: Seen) => string) => segments.map(key).sort().join()

// A segment of the cell has it on the left: its middle, a little to the left, lies in the cell.
function isIn(start: Point, end: Point, [i, j]: Point): boolean {
  const [x, y] = [(start[0] + end[0]) / 2 - (end[1] - start[1]) / 64, (start[1] + end[1]) / 2 + (end[0] - start[0]) / 64]
  return Math.floor(x) === i && Math.floor(y) === j
}
