// Ghosts, and what physics does with them: a ball on a seam, and the directions in which the floor pushes it.
import { createWorld } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, Vec2, World as Physics, WorldManifold } from 'planck'
import { counted, segmentsOf, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arrow, disc, path, type Point } from '../svg.js'

const radius = 0.55
const tiles = 4
const straight = 0.02 // radians

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
  const pushes = ([x, y]: Point): { at: Point; normal: Point }[] => {
    for (let k = 0; k < 2; ++k) {
      ball.setTransform(new Vec2(x, y), 0)
      ball.setLinearVelocity(new Vec2(0, 0))
      physics.step(1e-9)
    }
    const found: { at: Point; normal: Point }[] = []
    for (let contact = physics.getContactList(); contact !== null; contact = contact.getNext()) {
      if (!contact.isTouching() || !contact.isEnabled()) continue
      contact.getWorldManifold(manifold)
      const sign = terrain.segment(contact.getFixtureA()) === 0 ? -1 : 1
      const { x: nx, y: ny } = manifold.normal
      found.push({ at: [manifold.points[0].x, manifold.points[0].y], normal: [sign * nx, sign * ny] })
    }
    return found
  }
  const handle = fig.handle({
    at: [1.8, 1 + radius - 0.06],
    label: 'The ball',
    step: 0.05,
    move: (x, y) => [clamp(x, 0.6, tiles - 0.6), clamp(y, 1 + radius - 0.2, 2.1)],
  })
  fig.toggle('Ghost vertices', isOn, (on) => {
    isOn = on
    terrain.ghosts = on
    fig.redraw()
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
      parts.push(disc('ghostpoint', under.ghost1, 7 * fig.pixel), disc('ghostpoint', under.ghost2, 7 * fig.pixel))
    }
    parts.push(disc('ball', at, radius))
    let skewed = 0
    for (const { at: [x, y], normal } of found) {
      const angle = Math.atan2(normal[0], normal[1])
      if (Math.abs(angle) > straight) ++skewed
      const kind = Math.abs(angle) > straight ? 'push wrong' : 'push'
      parts.push(arrow(kind, [x, y], [x + normal[0] * 0.9, y + normal[1] * 0.9], 12 * fig.pixel, 0, 0.95))
    }
    layer.replaceChildren(...parts)
    const skew = skewed === 0 ? (found.length === 1 ? 'straight up' : 'all straight up') : `${skewed} of them askew, from the end of the next tile's edge`
    fig.say(found.length === 0 ? 'The ball touches nothing.' : `The floor pushes ${counted(found.length, 'time')}, ${skew}.`)
  })
}
