// Shows what the algorithm knows: segments, normals, ghosts and links; and one segment in detail.
import type { CellRect, Segment, SegmentId, World } from 'localgridseg'
import { kindOf } from './blocks.js'
import { theme } from './theme.js'

const detailed = 16 // pixels per cell from which on normals, ghosts and links are drawn

/** The context's unit is a cell, y up. */
export function drawOverlay(c: CanvasRenderingContext2D, world: World, cells: CellRect, pixel: number, hasGhosts: boolean): void {
  const { geometry, length } = world.segments(cells)
  const colours = theme()
  c.strokeStyle = colours.relinked
  c.fillStyle = colours.relinked
  c.lineWidth = 1.6 * pixel
  c.beginPath()
  for (let k = 0; k < 8 * length; k += 8) {
    c.moveTo(geometry[k], geometry[k + 1])
    c.lineTo(geometry[k + 2], geometry[k + 3])
  }
  c.stroke()
  if (pixel > 1 / detailed) return
  for (let k = 0; k < 8 * length; k += 8) drawDetails(c, geometry.subarray(k, k + 8), pixel, hasGhosts ? colours.added : null, colours.ink)
}

function drawDetails(
  c: CanvasRenderingContext2D,
  g: ArrayLike<number>,
  pixel: number,
  ghostColour: string | null,
  ink: string,
): void {
  const [dx, dy] = [g[2] - g[0], g[3] - g[1]]
  const length = Math.hypot(dx, dy)
  if (length < 6 * pixel) return
  const [ux, uy] = [dx / length, dy / length]
  const [mx, my] = [g[0] + dx / 2, g[1] + dy / 2]
  const tick = 9 * pixel
  // The normal, outward, and an arrow head that says which way the segment runs.
  c.strokeStyle = ink
  c.lineWidth = 1.2 * pixel
  c.beginPath()
  c.moveTo(mx, my)
  c.lineTo(mx + uy * tick, my - ux * tick)
  c.moveTo(mx - (ux + uy * 0.7) * 4 * pixel, my - (uy - ux * 0.7) * 4 * pixel)
  c.lineTo(mx, my)
  c.lineTo(mx - (ux - uy * 0.7) * 4 * pixel, my - (uy + ux * 0.7) * 4 * pixel)
  c.stroke()
  if (ghostColour === null) return
  // A whisker towards each ghost, along the neighbour: it lies a little outside.
  c.strokeStyle = ghostColour
  c.lineWidth = 1.4 * pixel
  const out = 4 * pixel
  whisker(c, g[0] + uy * out, g[1] - ux * out, g[4] + uy * out, g[5] - ux * out, pixel)
  whisker(c, g[2] + uy * out, g[3] - ux * out, g[6] + uy * out, g[7] - ux * out, pixel)
}

function whisker(
  c: CanvasRenderingContext2D,
  x: number,
  y: number,
  ghostX: number,
  ghostY: number,
  pixel: number,
): void {
  if (Number.isNaN(ghostX)) return
  const length = Math.hypot(ghostX - x, ghostY - y)
  const part = Math.min(0.28, (14 * pixel) / length)
  const [ex, ey] = [x + (ghostX - x) * part, y + (ghostY - y) * part]
  c.beginPath()
  c.moveTo(x, y)
  c.lineTo(ex, ey)
  c.stroke()
  c.beginPath()
  c.arc(ex, ey, 1.8 * pixel, 0, 2 * Math.PI)
  c.stroke()
}

/** The segment near a point, to be shown in detail. */
export function segmentAt(world: World, x: number, y: number, radius: number): Segment | null {
  const near = world.nearest(x, y, radius)
  return near === null ? null : world.segment(near.segment)
}

/** In words. */
export function describe(segment: Segment): string {
  const place = (p: readonly [number, number] | null) => (p === null ? 'none' : `(${round(p[0])}, ${round(p[1])})`)
  const link = (id: SegmentId) => (id === 0 ? 'none' : `${id}`)
  const kind = kindOf(segment.block).name.toLowerCase()
  return [
    `Segment ${segment.id}   ${place(segment.start)} → ${place(segment.end)}`,
    `cell (${segment.i}, ${segment.j})   block ${segment.block} (${kind})   owner: polygon ${segment.polygon}`,
    `predecessor ${link(segment.predecessor)}   ghost ${place(segment.ghost1)}`,
    `successor ${link(segment.successor)}   ghost ${place(segment.ghost2)}`,
  ].join('\n')
}

function round(x: number): string {
  return String(Math.round(x * 1000) / 1000)
}

/** The segment thick, its neighbours thinner, its ghosts as rings. */
export function drawSegment(c: CanvasRenderingContext2D, world: World, segment: Segment, pixel: number): void {
  const colours = theme()
  const line = (s: Segment, width: number) => {
    c.beginPath()
    c.moveTo(...s.start)
    c.lineTo(...s.end)
    c.lineWidth = width * pixel
    c.stroke()
  }
  c.strokeStyle = colours.added
  for (const id of [segment.predecessor, segment.successor]) if (id !== 0) line(world.segment(id), 4)
  c.strokeStyle = colours.ink
  line(segment, 5)
  c.fillStyle = colours.sky
  c.strokeStyle = colours.added
  for (const ghost of [segment.ghost1, segment.ghost2]) {
    if (ghost === null) continue
    c.beginPath()
    c.arc(...ghost, 5 * pixel, 0, 2 * Math.PI)
    c.lineWidth = 2.5 * pixel
    c.fill()
    c.stroke()
  }
}
