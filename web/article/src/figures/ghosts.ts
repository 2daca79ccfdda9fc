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
const font = 14 // pixels
const letter = 0.6 // of its size: how wide it is

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
  let isOn = false, heading = 1 // where it rolls: right, or left

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
      heading = Math.sign(x - handle.at[0]) || heading
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
    heading = way
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
    const size = font * fig.pixel, low = -0.1, high = tiles + 0.1
    const half = (text: string) => (letter * size * text.length) / 2
    const write = (kind: string, [x, y]: Point, text: string) => parts.push(words(`label ${kind}`, [clamp(x, low + half(text), high - half(text)), y], size, text))
    const rows = [1 - 24 * fig.pixel, 1 - 46 * fig.pixel]
    for (const segment of floor) parts.push(path(segment.id === under.id ? 'chosen' : 'segment', [segment.start, segment.end]))
    const middle = (under.start[0] + under.end[0]) / 2, ghosts = isOn ? [under.ghost1, under.ghost2] : []
    if (isOn) parts.push(path('whisker', [under.start, under.ghost1]), path('whisker', [under.end, under.ghost2]))
    for (const ghost of ghosts) {
      parts.push(disc('ghostpoint', ghost, 7 * fig.pixel))
      write('ghostword', [ghost[0], ghost[1] === 1 ? rows[0] : ghost[1] + 12 * fig.pixel], 'ghost vertex') // around the corner: above it
    }
    // Beside these words where there is room, and below them otherwise.
    const isCrowded = ghosts.some(([x, y]) => y === 1 && Math.abs(clamp(x, low + half('ghost vertex'), high - half('ghost vertex')) - middle) < half('ghost vertex its edge'))
    write('edgeword', [middle, rows[isCrowded ? 1 : 0]], 'its edge')
    parts.push(disc(`ball ${isOn ? 'smooth' : 'rough'}`, at, radius))
    const front = at[0] + heading * (radius + 0.08), ahead = clamp(front + heading * 0.5, low, high)
    if (Math.abs(ahead - front) > 0.25) { // there is room
      parts.push(arrow('segment', [front, at[1]], [ahead, at[1]], 10 * fig.pixel, 0, 0.95))
      write('', [(front + ahead) / 2, at[1] + 8 * fig.pixel], 'rolls')
    }
    const askew = found.filter(({ normal: [nx, ny] }) => Math.abs(Math.atan2(nx, ny)) > straight)
    const hit = 'hits the end of the next edge', hits = 2 * half(`the ball ${hit}`) < high - low ? `the ball ${hit}` : hit
    const isBack = ([nx]: Point) => nx * heading < 0
    for (const { normal, segment } of askew) {
      const other = floor.find(({ id }) => id === segment), side = Math.sign(normal[0]), tip = clamp(at[0] + side * 1.05, low, high)
      if (other !== undefined) {
        parts.push(path('wrong', [other.start, other.end]))
        write('askew', [(other.start[0] + other.end[0]) / 2, rows[1]], isBack(normal) ? hits : 'the end of the edge behind')
      }
      parts.push(arrow('push wrong', at, [tip, at[1]], 12 * fig.pixel, 0, 0.95))
      write('askew', [at[0] + side * 1.05, at[1] + 12 * fig.pixel + (isBack(normal) ? 0 : size)], isBack(normal) ? 'pushes back' : 'pushes on')
    }
    if (found.length > 0) {
      const [x, y] = found.find((each) => !askew.includes(each))?.at ?? [at[0], 1], tip: Point = [x, y + 1.25]
      parts.push(arrow('push', [x, y], tip, 12 * fig.pixel, 0, 0.95))
      write('ghostword', [x + 9 * fig.pixel + half('pushes up'), tip[1] + 3 * fig.pixel], 'pushes up')
    }
    layer.replaceChildren(...parts)
    const ways = [...(found.length > askew.length ? ['straight up'] : []), ...askew.map(({ normal }) => (isBack(normal) ? 'back, off the end of the next edge' : 'on, off the end of the edge behind'))]
    fig.say(found.length === 0 ? 'The ball touches nothing.' : `The floor pushes ${found.length === 1 ? 'once' : 'twice'}: ${ways.join(', and ')}.`)
  })
}
