// The landscape that the page starts with, and who rolls on it.
import { circle, type Region } from 'localgridseg'
import { GROUND, ICE } from '../blocks.js'
import type { Start } from '../bodies.js'
import { type Document, newDocument } from '../documents.js'
import type { Gate } from '../side.js'

// The surface from left to right: x, y. Slopes are chosen so that they meet the grid in lattice points.
const surface: readonly (readonly [number, number])[] = [
  [0, 8],
  [3, 8],
  [7, 6],
  [9, 6],
  [11, 5],
  [22, 5],
  [26, 4],
  [38, 4],
  [40, 3],
  [48, 3],
]

export const width = 48
/** What is seen of it at first: left, bottom, right, top. */
export const landscapeView = [-14, 0.4, width, 14.4] as const
/** What a narrow screen has in its middle: a rock that hangs on the left, and the slope with its bodies on the right. */
export const landscapeMiddle = 1.5

// On the left is a cave, where rocks hang from the roof: who digs at their necks sees them fall.
const roof = 11.25
const cave: readonly (readonly [number, number, number, number])[] = [[-14, 0, -13, 12.5], [-13, 0, -1, 2], [-13, roof, 0, 12.5], [-1, 0, 0, roof]]
/** What hangs: x and y of the middle, and the radius. */
export const rocks: readonly (readonly [number, number, number])[] = [[-4, 8.7, 1.4], [-8, 8.4, 1.7], [-11.3, 9.1, 1]]
/** Where a rock hangs, so that who digs there cuts it off. */
export const neckOf = ([x, y, radius]: readonly [number, number, number]): [number, number] => [x, (y + radius + roof) / 2]

export function makeLandscape(): Document {
  const document = newDocument()
  const { world } = document
  world.paint(below(0, width, 9), GROUND)
  world.paint(below(28, 35, 1), ICE, 'replace')
  for (const [x0, y0, x1, y1] of cave) world.paint({ rings: [[x0, y0, x1, y0, x1, y1, x0, y1]] }, GROUND)
  for (const [x, y, radius] of rocks) {
    world.paint(circle(x, y, radius, 16), GROUND)
    world.paint({ rings: [[x - 0.25, y, x + 0.25, y, x + 0.4, roof, x - 0.4, roof]] }, GROUND)
  }
  world.commit()
  return document
}

// The ground between two columns, down to a depth below the surface or to the bottom.
function below(x0: number, x1: number, depth: number): Region {
  const top = [x0, ...surface.map(([x]) => x).filter((x) => x0 < x && x < x1), x1].map(
    (x) => [x, surfaceAt(x)] as const,
  )
  const bottom = top.map(([x, y]) => [x, Math.max(0, y - depth)] as const).reverse()
  return { rings: [[...top, ...bottom]] }
}

export const landscapeGate: Gate = { x: 1.5, y: 9, speed: 3, bottom: -4 }

/** The riders of the first second. They are on their way already. */
export function landscapeRiders(): Start[] {
  const on = (kind: Start['kind'], x: number, size: number, colour: number): Start => ({
    kind,
    x,
    y: surfaceAt(x) + size + 0.02,
    speed: 3,
    size,
    colour,
  })
  return [
    on('marble', 1.2, 0.4, 0),
    on('box', 2.4, 0.4, 1),
    on('car', 5, 0.7, 2),
    on('box', 7.6, 0.35, 3),
    on('marble', 8.6, 0.3, 4),
    on('marble', 11.6, 0.45, 1),
    on('box', 15, 0.45, 0),
    on('marble', 16.6, 0.35, 3),
    on('marble', 19.4, 0.4, 4),
    on('marble', 22, 0.3, 2),
    on('box', 25, 0.4, 1),
    on('box', 28, 0.35, 4),
    on('marble', 30, 0.45, 0),
    on('box', 36, 0.4, 3),
    on('marble', 40, 0.4, 1),
  ]
}

function surfaceAt(x: number): number {
  const k = surface.findIndex(([right]) => right >= x && right > 0)
  const [[x0, y0], [x1, y1]] = [surface[k - 1], surface[k]]
  return y0 + ((y1 - y0) * (x - x0)) / (x1 - x0)
}
