// Rounding of a brush, under a lens: where its edge crosses the rim of a cell there is mostly no point of the lattice.
import { createWorld } from 'localgridseg'
import { grid, type Seen, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { disc, path, type Point } from '../svg.js'

const units = 65536 // to a cell
const seam = 2 // the rim that the lens looks at: x = 2
const shown = 2.6 // units from the middle of the lens to its rim
const lens = { x: 5.6, y: 1.5, radius: 1.35 }

export default function rounding(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.1, y0: -0.1, x1: 7.1, y1: 3.1 }, 'A triangle carved out of rock, and a lens')
  const layer = fig.layer()
  const corners: Point[] = [[0.7, 2.3], [1.1, 0.7], [3.4, 1.23]]
  const rock = () => {
    const world = createWorld()
    world.fill({ i0: 0, j0: 0, i1: 3, j1: 2 }, world.shape(square), 1)
    world.carve({ rings: [corners] })
    world.commit()
    return world
  }
  for (const k of corners.keys()) {
    fig.handle({
      at: corners[k],
      label: `Corner ${k + 1} of the brush`,
      step: 0.05,
      // The first two stay left of the seam and the third one right of it: so two edges cross it.
      move: (x, y) => (corners[k] = [k === 2 ? clamp(x, 2.3, 3.9) : clamp(x, 0.1, 1.7), clamp(y, 0.1, 2.9)]),
    })
  }
  fig.draws(() => {
    const world = rock()
    const segments = segmentsOf(world)
    const exact = crossing(corners[1], corners[2])
    const vertex = nearest(segments, exact)
    const off = (vertex[1] - exact) * units
    const parts: SVGElement[] = [...solids(world), ...grid(0, 0, 4, 3)]
    for (const { start, end } of segments) parts.push(path('segment', [start, end]))
    parts.push(disc('ring', [seam, exact], 9 * fig.pixel), path('lensline', [[seam + 9 * fig.pixel, exact], [lens.x - lens.radius, lens.y]]))
    parts.push(...underLens(segments, vertex, exact, fig.pixel))
    layer.replaceChildren(...parts)
    world.free()
    const most = farthest(segments, corners[1], corners[2])
    fig.say(
      `The vertex that the brush made is ${Math.abs(off).toFixed(2)} units from the exact crossing. ` +
        `The edge is at most ${most.toFixed(2)} units from the exact one.`,
    )
  })
}

/** Where the edge from a to b crosses the seam, when a and b are on the lattice. */
function crossing(a: Point, b: Point): number {
  const [ax, ay, bx, by] = [...a, ...b].map((x) => Math.round(x * units))
  return (ay + ((by - ay) * (seam * units - ax)) / (bx - ax)) / units
}

/** How far, in units, the made edge from a to b is from the exact one: that is at a vertex, since between them it is straight. */
function farthest(segments: readonly Seen[], a: Point, b: Point): number {
  const [ax, ay, bx, by] = [...a, ...b].map((x) => Math.round(x * units))
  const length = Math.hypot(bx - ax, by - ay)
  const offs = segments.map(({ start: [x, y] }) => {
    const [dx, dy] = [x * units - ax, y * units - ay]
    const along = (dx * (bx - ax) + dy * (by - ay)) / length
    return along < 0 || along > length ? Infinity : Math.abs(dx * (by - ay) - dy * (bx - ax)) / length
  })
  return Math.max(...offs.filter((off) => off < 2)) // what is farther away is of another edge
}

function nearest(segments: readonly Seen[], y: number): Point {
  let best: Point = [seam, Infinity]
  for (const { start } of segments) {
    if (start[0] === seam && Math.abs(start[1] - y) < Math.abs(best[1] - y)) best = start
  }
  return best
}

// A unit of the lattice is as large here as a few millimetres. The middle is the vertex.
function underLens(segments: readonly Seen[], vertex: Point, exact: number, pixel: number): SVGElement[] {
  const scale = lens.radius / shown // cells of the stage per unit
  const at = (dx: number, dy: number): Point => [lens.x + dx * scale, lens.y + dy * scale]
  const parts: SVGElement[] = [disc('glass', [lens.x, lens.y], lens.radius)]
  for (let dx = -2; dx <= 2; ++dx) {
    for (let dy = -2; dy <= 2; ++dy) if (Math.hypot(dx, dy) < shown - 0.1) parts.push(disc('lattice', at(dx, dy), 2 * pixel))
  }
  parts.push(path('rim', [at(0, -shown), at(0, shown)]))
  const rise = (exact - vertex[1]) * units
  for (const { start, end } of segments) {
    const far = same(start, vertex) ? end : same(end, vertex) ? start : null
    if (far === null) continue
    const [dx, dy] = [far[0] - vertex[0], far[1] - vertex[1]]
    const length = Math.hypot(dx, dy)
    parts.push(path('segment', [at(0, 0), at((dx / length) * shown, (dy / length) * shown)]))
    // The exact edge runs beside it. So far away both have the same direction.
    if (dx > 0) {
      const slope = dy / dx
      const half = Math.sqrt(Math.max(0, shown * shown - rise * rise)) / Math.hypot(1, slope)
      parts.push(path('exact', [at(-half, rise - half * slope), at(half, rise + half * slope)]))
    }
  }
  parts.push(disc('ring', at(0, rise), 6 * pixel), disc('vertex', at(0, 0), 5 * pixel), disc('frame', [lens.x, lens.y], lens.radius))
  return parts
}

const same = (a: Point, b: Point) => a[0] === b[0] && a[1] === b[1]
