// Ghosts, and what physics does with them: a ball rolls over seams, without ghosts and with them, and one sees in which
// directions the floor pushes it.
import { createWorld } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, Vec2, World as Physics, WorldManifold } from 'planck'
import { segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arrow, disc, path, type Point, words } from '../svg.js'

const radius = 0.55
const tiles = 4
const straight = 0.02 // radians
const height = 1 + radius - 0.06 // of a ball that is pressed onto the floor
const pace = 0.6 // cells a second

export default function ghosts(element: HTMLElement): void {
  const fig = new Figure(element, { x0: -0.15, y0: -0.1, x1: tiles + 0.15, y1: 2.7 }, 'A ball pressed onto the seam of two tiles')
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: tiles - 1, j1: 0 }, world.shape(square), 1)
  world.commit()
  const physics = new Physics({ gravity: { x: 0, y: 0 } })
  const terrain = new PlanckTerrain(physics, world, { ghosts: false })
  const ball = physics.createBody({ type: 'dynamic', allowSleep: false })
  ball.createFixture(new Circle(radius), { density: 1 })
  const layer = fig.layer()
  const manifold = new WorldManifold()
  let isOn = false

  // What planck finds where the ball is. The first step finds who is near. It pushes the ball out, too.
  const pushes = ([x, y]: Point): { at: Point; normal: Point; segment: number }[] => {
    for (let k = 0; k < 2; ++k) {
      ball.setTransform(new Vec2(x, y), 0)
      ball.setLinearVelocity(new Vec2(0, 0))
      physics.step(1e-9)
    }
    const found: ReturnType<typeof pushes> = []
    for (let contact = physics.getContactList(); contact !== null; contact = contact.getNext()) {
      if (!contact.isTouching() || !contact.isEnabled()) continue
      contact.getWorldManifold(manifold)
      const first = terrain.segment(contact.getFixtureA()), sign = first === 0 ? -1 : 1
      const { x: nx, y: ny } = manifold.normal
      found.push({ at: [manifold.points[0].x, manifold.points[0].y], normal: [sign * nx, sign * ny], segment: first || terrain.segment(contact.getFixtureB()) })
    }
    return found
  }
  const handle = fig.handle({
    at: [1.8, height],
    label: 'The ball',
    step: 0.05,
    move(x, y) {
      hold()
      return [clamp(x, 0.6, tiles - 0.6), clamp(y, 1 + radius - 0.2, 2.1)]
    },
  })
  const set = (on: boolean) => (isOn = terrain.ghosts = on)
  const box = fig.toggle('Ghost vertices', isOn, (on) => {
    stop()
    set(on)
    fig.redraw()
  })
  // To and fro: once without ghosts, once with them. Whoever takes hold of it stops it for a while, and the box ends it.
  let way = 1
  const { stop, hold } = fig.runs(() => {
    const x = handle.at[0] + (way * pace) / 60
    handle.at = [x, height]
    if (x > 0.7 && x < tiles - 0.7) return
    way = x < 2 ? 1 : -1
    set((box.checked = !isOn))
  })
  fig.draws(() => {
    const at = handle.at
    const found = pushes(at)
    const floor = segmentsOf(world).filter(({ start, end }) => start[1] === 1 && end[1] === 1)
    const under = floor.find(({ start, end }) => end[0] <= at[0] && at[0] <= start[0])!
    const parts: SVGElement[] = [...solids(world, 'ground tile')]
    for (const segment of floor) parts.push(arrow(segment.id === under.id ? 'chosen' : 'segment', segment.start, segment.end, 10 * fig.pixel, 0, 0.85))
    if (isOn) {
      parts.push(path('whisker', [under.start, under.ghost1]), path('whisker', [under.end, under.ghost2]))
      for (const ghost of [under.ghost1, under.ghost2])
        parts.push(disc('ghostpoint', ghost, 7 * fig.pixel), words('label ghostword', [clamp(ghost[0], 0.5, tiles - 0.5), 1 - 24 * fig.pixel], 14 * fig.pixel, 'ghost vertex'))
    }
    parts.push(words('label edgeword', [(under.start[0] + under.end[0]) / 2, 1 - 24 * fig.pixel], 14 * fig.pixel, 'its edge'))
    parts.push(disc(`ball ${isOn ? 'smooth' : 'rough'}`, at, radius))
    let skewed = 0
    for (const { at: [x, y], normal, segment } of found) {
      const angle = Math.atan2(normal[0], normal[1])
      const isAskew = Math.abs(angle) > straight, kind = isAskew ? 'push wrong' : 'push'
      if (isAskew) ++skewed
      const other = floor.find(({ id }) => id === segment)
      if (isAskew && other !== undefined) {
        const middle = (other.start[0] + other.end[0]) / 2
        parts.push(path('wrong', [other.start, other.end]), words('label askew', [clamp(middle, 0.9, tiles - 0.9), 1 - 46 * fig.pixel], 14 * fig.pixel, 'hits the end of this edge'))
      }
      const askew = found.find(({ normal: [nx] }) => Math.abs(nx) > straight), side = Math.sign(askew?.normal[0] ?? -1) * (isAskew ? 1 : -1), tip: Point = [x + normal[0] * 1.25, y + normal[1] * 1.25]
      parts.push(arrow(kind, [x, y], tip, 12 * fig.pixel, 0, 0.95))
      const word = words(`label ${isAskew ? 'askew' : 'ghostword'}`, [tip[0] + side * 9 * fig.pixel, tip[1] + (isAskew ? -3 : 3) * fig.pixel], 14 * fig.pixel, isAskew ? 'pushes back' : 'pushes up')
      word.setAttribute('text-anchor', side < 0 ? 'end' : 'start')
      parts.push(word)
    }
    layer.replaceChildren(...parts)
    const skew = skewed === 0 ? 'straight up' : `${found.length > skewed ? 'straight up, and ' : ''}back, off the end of the next edge`
    fig.say(found.length === 0 ? 'The ball touches nothing.' : `The floor pushes ${found.length === 1 ? 'once' : 'twice'}: ${skew}.`)
  })
}
