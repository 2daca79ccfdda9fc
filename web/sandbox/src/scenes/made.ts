// Scenes that are made here, of few strokes.
import { circle, type Region } from 'localgridseg'
import { CONVEYOR, GROUND, ICE, ONE_WAY, STICKY } from '../blocks.js'
import type { Start } from '../bodies.js'
import { type Document, newDocument } from '../documents.js'
import type { Cast } from '../game.js'

const box = (x0: number, y0: number, x1: number, y1: number): Region => ({ rings: [[x0, y0, x1, y0, x1, y1, x0, y1]] })
const marble = (x: number, y: number, speed: number, colour: number): Start => ({
  kind: 'marble',
  x,
  y,
  speed,
  size: 0.3 + 0.05 * (colour % 3),
  colour,
})

export function makePlatforms(): Document {
  const document = newDocument()
  const { world } = document
  world.paint(box(0, 0, 32, 1), GROUND)
  for (const [x, y] of [[4, 3], [11, 4.5], [18, 6], [11, 7.5], [4, 9], [22, 3.5]]) {
    world.paint({ rings: [[x, y, x + 6, y - 0.5, x + 6, y - 0.25, x, y + 0.25]] }, ONE_WAY)
  }
  world.commit()
  return document
}

export const platformsCast: Cast = {
  starts: Array.from({ length: 10 }, (_, k) => marble(4.5 + 2 * (k % 5), 11 + Math.floor(k / 5), 1, k)),
  gate: { x: 5, y: 12, speed: 1, bottom: -4 },
}

export function makeMaterials(): Document {
  const document = newDocument()
  const { world } = document
  const floors = [GROUND, ICE, GROUND, CONVEYOR, STICKY, CONVEYOR]
  floors.forEach((block, k) => world.paint(box(7 * k, 0, 7 * k + 7, 2), block))
  world.paint({ rings: [[0, 2, 6, 2, 0, 5]] }, GROUND)
  world.commit()
  return document
}

export const materialsCast: Cast = {
  starts: [0, 1, 2, 3, 4, 5, 6].map((k) => ({ ...marble(1 + 5.5 * k, 6, 2, k), kind: k % 2 === 0 ? 'box' : 'marble' })),
  gate: { x: 1.5, y: 6, speed: 2, bottom: -4 },
}

const side = 1000

/** Full rock with caves: a million cells. */
export function makeMillion(): Document {
  const document = newDocument()
  const { world } = document
  const square = world.shape([0, 0, 1, 0, 1, 1, 0, 1])
  world.fill({ i0: 0, j0: 0, i1: side - 1, j1: side - 1 }, square, GROUND)
  for (let k = 0; k < 60; ++k) world.carve(circle((k * 379.3) % side, (k * 617.9) % side, 4 + (k % 5), 20))
  for (const [x, y, radius] of [[488, 500, 7], [500, 498, 6], [512, 500, 7]]) world.carve(circle(x, y, radius, 24))
  world.commit()
  return document
}

export const millionCast: Cast = {
  starts: Array.from({ length: 9 }, (_, k) => marble(484 + 4 * k, 499, k % 2 === 0 ? 2 : -2, k)),
  gate: { x: 500, y: 499, speed: 2, bottom: -5 },
}
