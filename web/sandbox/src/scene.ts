// The landscape that the page starts with, and who rolls on it.
import { createWorld, type Region, type World } from 'localgridseg'
import { GROUND, ICE, keepsEdges, ONE_WAY, STICKY } from './blocks.js'
import type { Start } from './bodies.js'
import type { Gate } from './side.js'

// The surface from left to right: x, y. Slopes are chosen so that they meet the grid in lattice points.
const surface: readonly (readonly [number, number])[] = [
  [0, 10], [4, 10], [8, 9], [11, 9], [15, 7], [17, 7], [19, 7.5], [20, 7.5], [22, 6.5], [24, 6.5], [26, 7], [27, 7],
  [35, 5], [37, 5], [38, 5.25], [40, 5.25], [41, 4], [43, 3.5], [46, 3.5], [48, 3],
]

export const width = 48
export const height = 13

export function makeLandscape(): World {
  const world = createWorld({ preserve: keepsEdges })
  const ring = [...surface, [width, 0], [0, 0]].flat().reverse() // y, x, y, x, …
  for (let k = 0; k < ring.length; k += 2) [ring[k], ring[k + 1]] = [ring[k + 1], ring[k]]
  world.paint({ rings: [ring] }, GROUND)
  world.paint(box(-1, 0, 0, 12), GROUND)
  world.paint(box(27, 0, 35, 8), ICE, 'replace')
  world.commit()
  return world
}

function box(x0: number, y0: number, x1: number, y1: number): Region {
  return { rings: [[x0, y0, x1, y0, x1, y1, x0, y1]] }
}

export const landscapeGate: Gate = { x: 1.5, y: 11, speed: 3, bottom: -4, goal: width - 1 }

/** The riders of the first second. They are on their way already. */
export function landscapeRiders(): Start[] {
  const on = (kind: Start['kind'], x: number, size: number, colour: number): Start => ({ kind, x, y: surfaceAt(x) + size + 0.02, speed: 3, size, colour })
  return [
    on('marble', 1.2, 0.4, 0), on('box', 2.6, 0.4, 1), on('car', 4.6, 0.7, 2), on('marble', 6.4, 0.3, 3), on('marble', 7.6, 0.45, 4),
    on('box', 9, 0.35, 3), on('marble', 10.2, 0.35, 1), on('marble', 12.6, 0.4, 0), on('box', 16.2, 0.45, 4), on('marble', 21, 0.3, 2),
    on('box', 28.5, 0.4, 0), on('marble', 31, 0.4, 3), on('box', 33, 0.3, 1), on('marble', 36, 0.45, 4),
  ]
}

function surfaceAt(x: number): number {
  const k = surface.findIndex(([right]) => right > x)
  const [[x0, y0], [x1, y1]] = [surface[k - 1], surface[k]]
  return y0 + ((y1 - y0) * (x - x0)) / (x1 - x0)
}
