// Draws the riders and the kicks of one physics world.
import type { Body, Circle, Polygon } from 'planck'
import { kindOf } from './blocks.js'
import type { Rider } from './bodies.js'
import type { Rocks } from './falling.js'
import { type Kick, remembered } from './kicks.js'
import { cell } from './scale.js'
import type { Side } from './side.js'
import { type Theme, theme, wantsCalm } from './theme.js'

const flashes = 45 // steps
const tiny = 3 // pixels

/** The context's unit is a metre, y up. */
export function drawRiders(c: CanvasRenderingContext2D, side: Side, pixel: number): void {
  const colours = theme()
  for (const rider of side.riders) drawTrail(c, rider, colours, pixel)
  for (const rider of side.riders) {
    if (!rider.bodies[0].isActive()) continue
    if (rider.start.size * cell < tiny * pixel) drawDot(c, rider, colours)
    else for (const body of rider.bodies) drawBody(c, body, rider, colours, pixel)
  }
}

/** Ground that falls, with the colours that it has as ground. */
export function drawRocks(c: CanvasRenderingContext2D, rocks: ReturnType<Rocks['of']>, pixel: number): void {
  const colours = theme()
  for (const { body, ground } of rocks) {
    const { x, y } = body.getPosition()
    c.save()
    c.translate(x, y)
    c.rotate(body.getAngle())
    c.scale(cell, cell)
    c.lineWidth = pixel / cell // so that no seams are seen between polygons
    for (const { i, j, block, vertices } of ground.polygons) {
      c.beginPath()
      for (let k = 0; k < vertices.length; k += 2) c.lineTo(i + vertices[k], j + vertices[k + 1])
      c.closePath()
      c.fillStyle = c.strokeStyle = colours.special[kindOf(block).block] ?? colours.ground
      c.fill()
      c.stroke()
    }
    c.restore()
  }
}

// From far away a rider is a square of its colour.
function drawDot(c: CanvasRenderingContext2D, { bodies, start }: Rider, colours: Theme): void {
  const { x, y } = bodies[0].getPosition()
  const half = start.size * cell
  c.fillStyle = colours.riders[start.colour % colours.riders.length]
  c.fillRect(x - half, y - half, 2 * half, 2 * half)
}

// The path of the last second. Over good ground it is a smooth line.
function drawTrail(c: CanvasRenderingContext2D, { start, trail }: Rider, colours: Theme, pixel: number): void {
  const parts = 4
  if (trail.length === 0) return
  c.strokeStyle = colours.riders[start.colour % colours.riders.length]
  c.lineWidth = 2 * pixel
  for (let part = 0; part < parts; ++part) {
    const first = 2 * Math.floor((trail.length / 2 / parts) * part)
    const last = Math.min(trail.length - 2, 2 * Math.floor((trail.length / 2 / parts) * (part + 1)))
    c.globalAlpha = (part + 1) / parts / 1.6
    c.beginPath()
    for (let k = first; k <= last; k += 2) c.lineTo(trail[k], trail[k + 1])
    c.stroke()
  }
  c.globalAlpha = 1
}

function drawBody(c: CanvasRenderingContext2D, body: Body, rider: Rider, colours: Theme, pixel: number): void {
  const { x, y } = body.getPosition()
  const shape = body.getFixtureList()!.getShape()
  c.save()
  c.translate(x, y)
  c.rotate(body.getAngle())
  const isWheel = rider.start.kind === 'car' && body !== rider.bodies[0]
  c.fillStyle = isWheel ? colours.ink : colours.riders[rider.start.colour % colours.riders.length]
  c.strokeStyle = colours.sky
  c.lineWidth = 1.5 * pixel
  c.beginPath()
  if (shape.getType() === 'circle') drawDisc(c, (shape as Circle).getRadius(), pixel)
  else drawPolygon(c, (shape as Polygon).m_vertices, pixel)
  c.restore()
}

// A disc with a bar across: so one sees it turn.
function drawDisc(c: CanvasRenderingContext2D, radius: number, pixel: number): void {
  c.arc(0, 0, radius, 0, 2 * Math.PI)
  c.fill()
  if (radius < 3 * pixel) return
  c.beginPath()
  c.moveTo(-0.62 * radius, 0)
  c.lineTo(0.62 * radius, 0)
  c.moveTo(0, 0)
  c.lineTo(0, 0.62 * radius)
  c.lineCap = 'round'
  c.lineWidth = Math.max(pixel, 0.16 * radius)
  c.stroke()
}

function drawPolygon(c: CanvasRenderingContext2D, vertices: readonly { x: number; y: number }[], pixel: number): void {
  c.moveTo(vertices[0].x, vertices[0].y)
  for (const { x, y } of vertices.slice(1)) c.lineTo(x, y)
  c.closePath()
  c.fill()
  if (vertices.length !== 4 || vertices[0].x < 4 * pixel) return
  const half = vertices[0].x * 0.55
  c.strokeRect(-half, -half, 2 * half, 2 * half)
}

/**
 * A ring that opens and fades where a kick happened; without motion, a dot that goes. What stays for a while is a
 * stroke, as long as the kick was hard.
 */
export function drawKicks(c: CanvasRenderingContext2D, side: Side, pixel: number): void {
  c.strokeStyle = c.fillStyle = theme().kick
  for (const kick of side.kicks.recent) {
    const steps = side.kicks.step - kick.step
    drawMark(c, kick, 1 - steps / remembered, pixel)
    if (steps < flashes) drawFlash(c, kick, steps / flashes, pixel)
  }
  c.globalAlpha = 1
}

function drawMark(c: CanvasRenderingContext2D, kick: Kick, strength: number, pixel: number): void {
  c.globalAlpha = 0.75 * Math.min(1, 2 * strength)
  c.lineWidth = 2 * pixel
  c.beginPath()
  c.moveTo(kick.x, kick.y)
  c.lineTo(kick.x, kick.y + Math.min(60, 4 + 34 * kick.strength) * pixel)
  c.stroke()
}

function drawFlash(c: CanvasRenderingContext2D, kick: Kick, age: number, pixel: number): void {
  const calm = wantsCalm()
  c.globalAlpha = calm ? 0.9 : 1 - age
  c.beginPath()
  c.arc(kick.x, kick.y, (calm ? 5 : 3.5) * pixel, 0, 2 * Math.PI)
  c.fill()
  if (calm) return
  c.lineWidth = (3.5 * (1 - age) + 0.5) * pixel
  c.beginPath()
  c.arc(kick.x, kick.y, (4 + 18 * Math.sqrt(age)) * pixel, 0, 2 * Math.PI)
  c.stroke()
}
