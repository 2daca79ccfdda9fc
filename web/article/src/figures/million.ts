// One edit in a world of a million cells: what it changes lights up, and the same edit in a small world takes as long.
import { circle, createWorld, type World } from 'localgridseg'
import { counted, grid, seen, type Seen, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { disc, path, type Point, rect, words } from '../svg.js'

const side = 1000 // cells
const width = 18 // of the part that is shown, in cells
const height = 9
const radius = 0.7 // of the brush
const repeats = 20 // of an edit whose time is taken: one alone is too short for the clock
const rounds = 5 // of these: the least counts, as other programs run, too

const inside = (x: number, y: number): Point => [clamp(x, 1, width - 1), clamp(y, 1, height - 1)]

export default function million(element: HTMLElement): void {
  const fig = new Figure(element, { x0: 0, y0: 0, x1: width, y1: height }, 'A small part of a world of a million cells')
  const layer = fig.layer(), specks = new Specks(fig.layer())
  let world: World | null = null
  let at: Point = [490, 495]
  let touched: Point[] = []
  let near: Point[] = [] // these and their neighbours
  let changed: { list: Seen[]; kind: string }[] = []
  let report = ''

  const handle = fig.handle({
    at: [width / 2, height / 2],
    label: 'Where to dig',
    step: 0.5,
    move: inside,
    drag: (x, y, isFirst) => digAt(x, y, isFirst),
    tap: (x, y) => digAt(x, y, true),
  })
  let times: [number, number] = [0, 0] // here and in a small world: where a drag began
  const dig = (isFirst: boolean) => {
    if (world === null) return
    const [x, y] = [at[0] + handle.at[0], at[1] + handle.at[1]]
    if (world.at(x, y).where !== 'outside') specks.fly(handle.at)
    const before = new Map(segmentsAround(world, x, y).map((segment) => [segment.id, segment]))
    if (isFirst) {
      const small = copyAround(world, x, y)
      times = [timeOf(world, x, y), timeOf(small, x, y)]
      small.free()
    }
    world.carve(brush(x, y))
    const { removed, added, relinked } = world.commit()
    // The dashes are above: a line of a cut polygon that stayed where it was is both.
    changed = [
      { list: seen(added), kind: 'added' },
      { list: [...removed].flatMap((id) => before.get(id) ?? []), kind: 'removed' },
      { list: seen(relinked), kind: 'relinked' },
    ]
    touched = []
    for (let j = Math.floor(y - radius); j <= Math.floor(y + radius); ++j) {
      for (let i = Math.floor(x - radius); i <= Math.floor(x + radius); ++i) {
        const [dx, dy] = [x - clamp(x, i, i + 1), y - clamp(y, j, j + 1)] // from the nearest place of the cell
        if (Math.hypot(dx, dy) < radius) touched.push([i, j])
      }
    }
    const around = touched.flatMap(([i, j]) => [-1, 0, 1].flatMap((dj) => [-1, 0, 1].map((di): Point => [i + di, j + dj])))
    near = [...new Map(around.map((cell) => [String(cell), cell])).values()]
    report =
      `The brush reached ${counted(touched.length, 'cell')}; with their neighbours, ${near.length} of a million cells. ` +
      `${counted(removed.length, 'segment')} removed, ${added.length} added, ${relinked.length} with another ghost vertex. ` +
      `To dig here and undo it: ${times[0].toFixed(2)} ms. In a world of only 100 cells: ${times[1].toFixed(2)} ms.`
    fig.redraw()
  }
  const digAt = (x: number, y: number, isFirst: boolean) => {
    const [px, py] = handle.at, to = inside(x, y)
    if (!isFirst && Math.hypot(to[0] - px, to[1] - py) < radius / 2) return
    handle.at = to
    dig(isFirst)
  }
  fig.button('Dig here', () => dig(true))
  fig.button('Elsewhere', () => {
    at = [Math.floor(Math.random() * (side - width)), Math.floor(Math.random() * (side - height))]
    touched = near = []
    changed = []
    report = `Another place: columns ${at[0]} to ${at[0] + width}, rows ${at[1]} to ${at[1] + height}.`
    fig.redraw()
  })
  fig.onDrag(digAt)
  const draw = () => {
    if (world === null) return fig.say('A million cells are being filled.')
    const cells = { i0: at[0] - 1, j0: at[1] - 1, i1: at[0] + width, j1: at[1] + height }
    const shift = ([x, y]: Point): Point => [x - at[0], y - at[1]]
    const parts: SVGElement[] = []
    for (const { i, j, vertices } of world.polygons(cells)) {
      const ring: Point[] = []
      for (let k = 0; k < vertices.length; k += 2) ring.push(shift([i + vertices[k], j + vertices[k + 1]]))
      parts.push(path('ground', ring, true))
    }
    parts.push(...grid(0, 0, width, height))
    for (const [i, j] of near) parts.push(rect('near', ...shift([i, j]), ...shift([i + 1, j + 1])))
    for (const [i, j] of touched) parts.push(rect('own', ...shift([i, j]), ...shift([i + 1, j + 1])))
    for (const { start, end } of segmentsIn(world, cells)) parts.push(path('segment far', [shift(start), shift(end)]))
    for (const { list, kind } of changed) for (const { start, end } of list) parts.push(path(kind, [shift(start), shift(end)]))
    layer.replaceChildren(...parts, ...map(at, fig.pixel))
    fig.say(report || `${world.stats().cells.toLocaleString('en')} of a million cells hold rock. Drag to dig.`)
  }
  fig.draws(draw)
  // A tenth of a second of work, which waits until somebody comes near.
  const watch = new IntersectionObserver(([entry]) => {
    if (!entry.isIntersecting) return
    watch.disconnect()
    setTimeout(() => {
      world = makeWorld()
      fig.redraw()
    }, 30)
  }, { rootMargin: '300px' })
  watch.observe(element)
}

const caves = Array.from({ length: 150 }, (_, k): Point => [(k * 379.3) % side, (k * 617.9) % side])

/** The whole world, in a corner, and where in it one is. */
function map([x, y]: Point, pixel: number): SVGElement[] {
  const size = 2.6, word = words('label mapword', [width - 0.25, height - size - 0.25 - 15 * pixel], 12 * pixel, 'the whole world'), left = width - size - 0.25, low = height - size - 0.25
  const place = (px: number, py: number): Point => [left + (size * px) / side, low + (size * py) / side], [cx, cy] = place(x + width / 2, y + height / 2)
  word.setAttribute('text-anchor', 'end')
  return [
    rect('map', left, low, left + size, low + size),
    ...caves.map((cave) => disc('hole', place(...cave), 0.018)),
    disc('here', [cx, cy], 4 * pixel),
    word,
  ]
}

// Full rock, with caves.
function makeWorld(): World {
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: side - 1, j1: side - 1 }, world.shape(square), 1)
  for (const [k, [x, y]] of caves.entries()) world.carve(circle(x, y, 3 + (k % 4), 20))
  for (const [x, y] of [[494, 499], [501, 498], [505, 502]]) world.carve(circle(x, y, 2.4, 20))
  world.commit()
  return world
}

const brush = (x: number, y: number) => circle(x, y, radius, 16)

/** How long a dig and its commit take, and to take them back. In milliseconds. */
function timeOf(world: World, x: number, y: number): number {
  const mark = world.mark()
  let least = Infinity
  for (let round = 0; round < rounds; ++round) {
    const start = performance.now()
    for (let k = 0; k < repeats; ++k) {
      world.carve(brush(x, y))
      world.commit()
      world.rollBack(mark)
    }
    least = Math.min(least, performance.now() - start)
  }
  world.forget(mark)
  return least / repeats
}

/** The ten by ten cells around a point, as a world of their own. */
function copyAround(world: World, x: number, y: number): World {
  const copy = createWorld()
  const [i0, j0] = [Math.floor(x) - 5, Math.floor(y) - 5]
  for (const { i, j, vertices, block } of world.polygons({ i0, j0, i1: i0 + 9, j1: j0 + 9 })) copy.addPolygon(i, j, vertices, block)
  copy.commit()
  return copy
}

const segmentsIn = (world: World, cells: { i0: number; j0: number; i1: number; j1: number }) => seen(world.segments(cells))
const segmentsAround = (world: World, x: number, y: number) =>
  segmentsIn(world, { i0: Math.floor(x) - 4, j0: Math.floor(y) - 4, i1: Math.floor(x) + 4, j1: Math.floor(y) + 4 })

/** What flies up where one digs. */
class Specks {
  readonly #layer: SVGGElement
  #all: { x: number; y: number; vx: number; vy: number; age: number }[] = []
  #last = 0

  constructor(layer: SVGGElement) {
    this.#layer = layer
  }

  fly([x, y]: Point): void {
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return
    if (this.#all.length === 0) requestAnimationFrame((now) => this.#frame((this.#last = now)))
    for (let k = 0; k < 7; ++k) this.#all.push({ x, y, vx: 5 * (Math.random() - 0.5), vy: 2 + 3 * Math.random(), age: 0 })
  }

  #frame(now: number): void {
    const time = Math.min(0.05, (now - this.#last) / 1000)
    this.#last = now
    for (const each of this.#all) Object.assign(each, { x: each.x + time * each.vx, y: each.y + time * each.vy, vy: each.vy - 12 * time, age: each.age + time })
    this.#all = this.#all.filter(({ age }) => age < 0.7)
    this.#layer.replaceChildren(...this.#all.map(({ x, y, age }) => disc('speck', [x, y], 0.12 * (1 - age / 0.7))))
    if (this.#all.length > 0) requestAnimationFrame((next) => this.#frame(next))
  }
}
