// The landscape that the page starts with, and who rolls on it.
import { createWorld, type Region, type World } from 'localgridseg'
import { GROUND, ICE, keepsEdges } from './blocks.js'
import type { Start } from './bodies.js'
import type { Gate } from './side.js'

// The surface from left to right: x, y. Slopes are chosen so that they meet the grid in lattice points.
export const surface: readonly (readonly [number, number])[] = [
  [0, 10], [3, 10], [7, 8], [9, 8], [11, 7], [22, 7], [26, 6], [38, 6], [40, 5], [48, 5],
]

export const width = 48
export const height = 14

export function makeLandscape(): World {
  const world = createWorld({ preserve: keepsEdges })
  const ring = [...surface, [width, 0], [0, 0]].flat().reverse() // y, x, y, x, …
  for (let k = 0; k < ring.length; k += 2) [ring[k], ring[k + 1]] = [ring[k + 1], ring[k]]
  world.paint({ rings: [ring] }, GROUND)
  world.paint(box(-1, 0, 0, 13), GROUND)
  world.paint(box(24, 0, 31, 8), ICE, 'replace')
  world.commit()
  return world
}

function box(x0: number, y0: number, x1: number, y1: number): Region {
  return { rings: [[x0, y0, x1, y0, x1, y1, x0, y1]] }
}

export const landscapeGate: Gate = { x: 1.5, y: 11, speed: 3, bottom: -4 }

/** The riders of the first second. They are on their way already. */
export function landscapeRiders(): Start[] {
  const on = (kind: Start['kind'], x: number, size: number, colour: number): Start => ({ kind, x, y: surfaceAt(x) + size + 0.02, speed: 3, size, colour })
  return [
    on('marble', 1.2, 0.4, 0), on('box', 2.4, 0.4, 1), on('car', 5, 0.7, 2), on('box', 7.6, 0.35, 3), on('marble', 8.6, 0.3, 4),
    on('marble', 11.6, 0.45, 1), on('box', 15, 0.45, 0), on('marble', 16.6, 0.35, 3), on('marble', 19.4, 0.4, 4),
    on('marble', 22, 0.3, 2), on('box', 25, 0.4, 1), on('box', 28, 0.35, 4), on('marble', 30, 0.45, 0), on('box', 36, 0.4, 3),
    on('marble', 40, 0.4, 1),
  ]
}

function surfaceAt(x: number): number {
  const k = surface.findIndex(([right]) => right > x)
  const [[x0, y0], [x1, y1]] = [surface[k - 1], surface[k]]
  return y0 + ((y1 - y0) * (x - x0)) / (x1 - x0)
}
