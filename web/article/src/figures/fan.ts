// The fan at a vertex: the hand turns from a segment's end until it meets the one that goes on.
import { createWorld } from 'localgridseg'
import { grid, type Seen, segmentsOf, solids } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arc, arrow, disc, path, type Point } from '../svg.js'

interface Wedge {
  /** Its cell, whose corner in the middle of the figure is the tip. */
  readonly cell: Point
  readonly ends: [Point, Point]
}

const turn = 2 * Math.PI
const near = 0.12 // radians: the hand stops this near
const length = 0.5 // of the hand: short, so that a finger does not take it for an end
const angleOf = ([x, y]: Point) => Math.atan2(y, x)

export default function fan(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -1.3, y0: -1.15, x1: 1.3, y1: 1.15 }, 'Segments around a vertex')
  const world = createWorld()
  const wedges: Wedge[] = [
    { cell: [0, 0], ends: [[0.95, 0.15], [0.3, 0.95]] },
    { cell: [-1, 0], ends: [[-0.35, 0.9], [-0.95, 0.35]] },
    { cell: [-1, -1], ends: [[-0.9, -0.3], [-0.25, -0.95]] },
  ]
  const middle = 1 // the wedge that can be taken away
  let hasMiddle = true
  let chosen = 0 // of which wedge the segment is that one starts from
  let isBack = false // from the start of a segment to its predecessor
  let hand = 0.5 // how far it has turned, in radians
  const layer = fig.layer()
  const build = () => {
    world.clear({ i0: -1, j0: -1, i1: 0, j1: 0 })
    for (const [w, { cell, ends }] of wedges.entries()) {
      if (w === middle && !hasMiddle) continue
      const ring = [[0, 0] as Point, ...ends].map(([x, y]): Point => [x - cell[0], y - cell[1]])
      world.addPolygon(...cell, ring, 1)
    }
    world.commit()
  }
  build()
  const ofMiddle: SVGGElement[] = []
  for (const [w, wedge] of wedges.entries()) {
    for (const side of [0, 1] as const) {
      const made = fig.handle({
        at: wedge.ends[side],
        label: `End ${2 * w + side + 1}`,
        step: 0.05,
        move(x, y) {
          const [i, j] = wedge.cell
          const before = wedge.ends[side]
          wedge.ends[side] = [clamp(x, i + 0.05, i + 0.95), clamp(y, j + 0.05, j + 0.95)]
          const [a, b] = wedge.ends
          if (a[0] * b[1] - a[1] * b[0] < 0.05) wedge.ends[side] = before // it would turn over, or be too thin
          else build()
          return wedge.ends[side]
        },
      })
      if (w === middle) ofMiddle.push(made.element)
    }
  }
  const handle = fig.handle({
    at: [0, 0],
    label: 'The hand that turns',
    step: 0.1,
    move(x, y) {
      const own = angleOf(outer(found()[0]))
      const way = ((Math.atan2(y, x) - own) * sense() + 2 * turn) % turn
      const end = sweep(found())
      hand = way > end + (turn - end) / 2 ? 0 : Math.min(way, end)
      return handle.at
    },
  })
  handle.element.classList.add('turner')
  fig.button('Next segment', () => {
    chosen = (chosen + (chosen + 1 === middle && !hasMiddle ? 2 : 1)) % wedges.length
    hand = 0.4
    fig.redraw()
  })
  fig.toggle('The upper left wedge', hasMiddle, (isOn) => {
    hasMiddle = isOn
    for (const element of ofMiddle) element.style.display = isOn ? '' : 'none'
    if (chosen === middle) chosen = 0
    build()
    fig.redraw()
  })
  fig.toggle('Predecessor', isBack, (isOn) => {
    isBack = isOn
    hand = 0.4
    fig.redraw()
  })
  // The segment that comes in along the chosen wedge, or goes out, and the one that the engine links to it.
  const found = (): [Seen, Seen] => {
    const segments = segmentsOf(world)
    const [x, y] = wedges[chosen].ends[isBack ? 0 : 1]
    const own = segments.find((segment) => {
      const [pivot, far] = isBack ? [segment.start, segment.end] : [segment.end, segment.start]
      return isTip(pivot) && Math.hypot(far[0] - x, far[1] - y) < 0.001
    })!
    return [own, segments.find(({ id }) => id === (isBack ? own.predecessor : own.successor))!]
  }
  const sense = () => (isBack ? -1 : 1)
  const sweep = ([own, next]: [Seen, Seen]) => ((angleOf(outer(next)) - angleOf(outer(own))) * sense() + 2 * turn) % turn

  fig.draws(() => {
    const [own, next] = found()
    const from = angleOf(outer(own))
    const end = sweep([own, next])
    hand = Math.min(hand, end)
    const isThere = end - hand < near
    if (isThere) hand = end
    const to = from + hand * sense()
    const tip: Point = [length * Math.cos(to), length * Math.sin(to)]
    handle.at = tip
    handle.element.setAttribute('transform', `translate(${tip[0]} ${-tip[1]}) scale(${fig.pixel})`)
    const parts: SVGElement[] = [...grid(-1, -1, 1, 1), ...solids(world)]
    parts.push(arc('sweep', [0, 0], 0.7 * length, from, to), path('hand', [[0, 0], tip]))
    for (const segment of segmentsOf(world)) {
      if (!isTip(segment.start) && !isTip(segment.end)) continue
      const kind = segment.id === own.id ? 'chosen' : isThere && segment.id === next.id ? 'ghost' : 'segment'
      parts.push(arrow(kind, segment.start, segment.end, 11 * fig.pixel, 0, isTip(segment.start) ? 0.75 : 0.25))
    }
    parts.push(disc('vertex', [0, 0], 4 * fig.pixel))
    if (isThere) parts.push(disc('ghostpoint', outer(next), 13 * fig.pixel)) // around the grip that is there
    layer.replaceChildren(...parts)
    const degrees = Math.round((hand * 360) / turn)
    fig.say(
      isThere
        ? `After ${degrees} degrees the hand meets a segment. It is the ${isBack ? 'predecessor' : 'successor'}: its far end is the ghost vertex.`
        : `Turned by ${degrees} degrees. The hand has met no segment yet.`,
    )
  })
}

const isTip = ([x, y]: Point) => x === 0 && y === 0

/** Its end that is not in the middle. */
const outer = ({ start, end }: Seen) => (isTip(start) ? end : start)
