// What all figures do with a world: read its segments as values, and draw them.
import { type SegmentId, type SegmentList, type World } from 'localgridseg'
import { arrow, disc, path, type Point } from './svg.js'

export interface Seen {
  readonly id: SegmentId
  readonly start: Point
  readonly end: Point
  readonly ghost1: Point
  readonly ghost2: Point
  readonly predecessor: SegmentId
  readonly successor: SegmentId
  readonly block: number
}

export const square: readonly Point[] = [[0, 0], [1, 0], [1, 1], [0, 1]]

export function seen(list: SegmentList): Seen[] {
  const { geometry, id, predecessor, successor, block } = list
  return Array.from({ length: list.length }, (_, k) => {
    const at = (n: number): Point => [geometry[8 * k + n], geometry[8 * k + n + 1]]
    return {
      id: id[k],
      start: at(0),
      end: at(2),
      ghost1: at(4),
      ghost2: at(6),
      predecessor: predecessor[k],
      successor: successor[k],
      block: block[k],
    }
  })
}

export const segmentsOf = (world: World): Seen[] => seen(world.segments())

/** The polygons of a world, each in world coordinates. */
export function solids(world: World, kind = 'ground'): SVGPathElement[] {
  return world.polygons().map(({ i, j, vertices }) => {
    const ring: Point[] = []
    for (let k = 0; k < vertices.length; k += 2) ring.push([i + vertices[k], j + vertices[k + 1]])
    return path(kind, ring, true)
  })
}

/** Segments as arrows, with a dot at each end. */
export function outline(segments: readonly Seen[], pixel: number, kind = 'segment'): SVGElement[] {
  return [
    ...segments.map(({ start, end }) => arrow(kind, start, end, 9 * pixel)),
    ...segments.map(({ start }) => disc('vertex', start, 3 * pixel)),
  ]
}

export function grid(x0: number, y0: number, x1: number, y1: number): SVGPathElement[] {
  const lines: SVGPathElement[] = []
  for (let x = Math.ceil(x0); x <= x1; ++x) lines.push(path('grid', [[x, y0], [x, y1]]))
  for (let y = Math.ceil(y0); y <= y1; ++y) lines.push(path('grid', [[x0, y], [x1, y]]))
  return lines
}

/** "1 segment", "2 segments" */
export function counted(n: number, noun: string): string {
  return `${n.toLocaleString('en')} ${noun}${n === 1 ? '' : 's'}`
}
