// How one knows that it is right: the reference beside the engine. With a planted bug a random world soon fails, and is
// made small before the reader's eyes.
import { createWorld, type Polygon } from 'localgridseg'
import { counted, grid, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { type Edge, edges, loadReference, type Reference } from '../reference.js'
import { type Placed, plantedEngine, soundEngine, type Subject } from '../subject.js'
import { arrow, disc, path, type Point, words } from '../svg.js'

const columns = 5
const rows = 4
const gap = 1 // between the two pictures
const pause = 350 // milliseconds between two steps that one is to see
const most = 200 // worlds
const shapes: readonly (readonly Point[])[] = [
  square,
  [[0, 0], [1, 0], [1, 0.5], [0, 0.5]],
  [[0, 0], [1, 0], [1, 1]],
  [[0, 0.5], [1, 0.5], [1, 1], [0, 1]],
  [[0.5, 0], [1, 0], [1, 1], [0.5, 1]],
]

export default async function proof(element: HTMLElement): Promise<void> {
  const width = 2 * columns + gap
  const fig = new Figure(element, { x0: -0.2, y0: -0.4, x1: width + 0.2, y1: rows + 0.9 }, 'The reference and the engine, side by side')
  const layer = fig.layer()
  const reference: Reference = await loadReference()
  const planted = plantedEngine()
  let subject: Subject = soundEngine
  let placed = randomWorld(1)
  let wanted: Edge[] = []
  let got: Edge[] = []
  let report = ''
  let run = 0 // of the test that is under way; a new one ends the old one
  let last = '' // the cell that was changed last

  // Edges with the same ends can have other ghosts: then it is the links that differ.
  const difference = (): string => {
    if (got.length === 0) return 'The engine stops.'
    const bad = wanted.filter(({ key }) => !got.some((edge) => edge.key === key))
    const isSameLine = wanted.length === got.length && bad.every((edge) => twin(edge, got) !== undefined)
    return isSameLine
      ? `The same segments, but ${bad.length} ${bad.length === 1 ? 'has' : 'have'} another ghost vertex.`
      : `${counted(bad.length, 'segment')} of the reference ${bad.length === 1 ? 'is' : 'are'} missing or wrong.`
  }
  const check = async (): Promise<boolean> => {
    wanted = reference(polygonsOf(placed))
    got = edges(await subject(placed))
    const keys = new Set(got.map(({ key }) => key))
    return got.length === wanted.length && wanted.every(({ key }) => keys.has(key))
  }
  const show = async () => {
    const isSame = await check()
    const next = subject === planted ? ' Now test it.' : ''
    report = isSame ? `The same: ${counted(got.length, 'segment')}, with all their ghost vertices.${next}` : `They differ. ${difference()}`
    fig.redraw()
  }
  fig.handle({
    at: [1.5, 1.5],
    label: 'The tile that changes',
    step: 1,
    move(x, y) {
      const [i, j] = [clamp(Math.floor(x), 0, columns - 1), clamp(Math.floor(y), 0, rows - 1)]
      if (last !== `${i} ${j}`) {
        ++run
        last = `${i} ${j}`
        const old = placed.find((each) => each.i === i && each.j === j)
        const next = old === undefined ? 0 : shapes.indexOf(old.ring) + 1
        placed = placed.filter((each) => each !== old)
        if (next < shapes.length) placed.push({ i, j, ring: shapes[next] })
        void show()
      }
      return [i + 0.5, j + 0.5]
    },
  })
  fig.toggle('Plant a bug', false, (isOn) => {
    ++run
    subject = isOn ? planted : soundEngine
    void show()
  })
  fig.button('Test it', () => void test())

  const test = async () => {
    const mine = ++run
    for (let seed = 1; seed <= most; ++seed) {
      placed = randomWorld(seed)
      const isSame = await check()
      if (run !== mine) return
      report = `World ${seed} of ${most}: ${isSame ? 'the same' : 'they differ'}.`
      fig.redraw()
      if (!isSame) return shrink(mine, seed)
      if (seed < 8) await wait(pause / 3)
    }
    report = `${most} random worlds, and the engine agreed with the reference in each.`
    fig.redraw()
  }
  // Takes one polygon after the other away, and keeps what still fails.
  const shrink = async (mine: number, seed: number) => {
    const before = placed.length
    for (let k = placed.length - 1; k >= 0; --k) {
      await wait(pause)
      if (run !== mine) return
      const all = placed
      placed = all.filter((_, n) => n !== k)
      if (await check()) {
        placed = all
        await check()
      }
      report = `World ${seed} fails. Made smaller: ${before} polygons are ${placed.length} now.`
      fig.redraw()
    }
    report = `World ${seed} failed. Of its ${before} polygons these ${placed.length} are enough. ${difference()}`
    fig.redraw()
  }

  fig.draws(() => {
    const right = columns + gap
    layer.replaceChildren(...picture(0, 'The reference', 'expected', wanted, got), ...picture(right, 'The engine', 'wrong', got, wanted))
    fig.say(report)
  })
  await show()

  function picture(shift: number, title: string, odd: string, own: readonly Edge[], other: readonly Edge[]): SVGElement[] {
    const move = ([x, y]: Point): Point => [x + shift, y]
    const keys = new Set(other.map(({ key }) => key))
    const parts: SVGElement[] = grid(0, 0, columns, rows).map((line) => {
      line.setAttribute('transform', `translate(${shift} 0)`)
      return line
    })
    for (const { i, j, ring } of placed) parts.push(path('ground', ring.map(([x, y]) => move([i + x, j + y])), true))
    const links: SVGElement[] = []
    for (const edge of own) {
      const { start, end, ghost1, ghost2 } = edge
      const same = keys.has(edge.key) ? edge : twin(edge, other)
      parts.push(arrow(same === undefined ? odd : 'segment', move(start), move(end), 8 * fig.pixel))
      parts.push(disc('vertex', move(start), 2 * fig.pixel))
      if (same === undefined) continue
      if (!isAt(same.ghost1, ghost1)) links.push(link(odd, move(ghost1), move(start), move(end)), disc(`ghostpoint ${odd}`, move(ghost1), 5 * fig.pixel))
      if (!isAt(same.ghost2, ghost2)) links.push(link(odd, move(start), move(end), move(ghost2)), disc(`ghostpoint ${odd}`, move(ghost2), 5 * fig.pixel))
    }
    parts.push(...links)
    parts.push(words('label', [shift + columns / 2, rows + 0.35], 14 * fig.pixel, title))
    return parts
  }
}

const isAt = (a: Point, b: Point) => a[0] === b[0] && a[1] === b[1]
const twin = (edge: Edge, other: readonly Edge[]) => other.find(({ start, end }) => isAt(start, edge.start) && isAt(end, edge.end))

/** Around the corner at b, from a segment to its neighbour: the free wedge or the solid is on its inner side. */
function link(kind: string, a: Point, b: Point, c: Point): SVGPathElement {
  const half = (to: Point): Point => [(b[0] + to[0]) / 2, (b[1] + to[1]) / 2]
  const [from, to] = [half(a), half(c)]
  const points = Array.from({ length: 13 }, (_, k): Point => {
    const t = k / 12
    const on = (n: 0 | 1) => (1 - t) ** 2 * from[n] + 2 * t * (1 - t) * b[n] + t * t * to[n]
    return [on(0), on(1)]
  })
  return path(kind, points)
}

// The reference takes what a world of the package holds: so it sees the polygons as they are on the lattice.
function polygonsOf(placed: readonly Placed[]): Polygon[] {
  const world = createWorld()
  for (const { i, j, ring } of placed) world.addPolygon(i, j, ring, 1)
  const polygons = world.polygons()
  world.free()
  return polygons
}

function randomWorld(seed: number): Placed[] {
  let state = seed * 7919
  const random = (n: number) => {
    state = (state * 1103515245 + 12345) % 2147483648
    return Math.floor((state / 2147483648) * n)
  }
  const placed: Placed[] = []
  for (let j = 0; j < rows; ++j) {
    for (let i = 0; i < columns; ++i) {
      if (random(10) < 6) placed.push({ i, j, ring: shapes[random(10) < 8 ? 0 : random(shapes.length)] })
    }
  }
  return placed
}

function wait(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds))
}
