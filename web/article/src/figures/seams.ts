// The same ball on the same floor, without ghosts and with them. Both rolls are planck's, worked out beforehand, so that
// they can be shown slowly where the ball is kicked, and dragged to and fro.
import { createWorld } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, Vec2, World as Physics } from 'planck'
import { counted, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { arrow, disc, path, type Point, rect, words } from '../svg.js'

const cell = 0.2 // metres
const gravity = 1.62 // of the Moon
const first = 8.6 // cells a second
const radius = 0.42
const skin = 0.005 // metres: so far from an edge planck lets a ball rest. This one is made smaller by it
const isNarrow = innerWidth < 560
const tiles = isNarrow ? 9 : 13 // on a phone from nearer
const from = 1, to = tiles - 0.5 // cells
const jolt = 0.03 // metres a second: the floor is level, so who moves up by more was kicked
const large = 0.15 // such a kick is shown slowly
const step = 1 / 60
const around = 0.06 // seconds before and after a kick that are shown slowly
const pace = 0.42, slow = 0.05 // of time
const pause = 70 // frames at the end
const floors = [isNarrow ? 4.25 : 3.8, 0.95] // where the floors are drawn
const title = isNarrow ? 2 : 1.9 // above them
const font = isNarrow ? 12.5 : 14 // pixels
const thick = 0.34
const late = 0.015 // seconds after the first kick: there it begins for whoever has just come
const letter = 0.6 // of its size: how wide it is

interface Kick {
  readonly time: number
  readonly at: Point
  readonly change: Point // of the velocity, in metres a second
}
interface Roll {
  readonly points: readonly Point[]
  readonly speeds: readonly number[] // in cells a second
  readonly kicks: readonly Kick[]
}

function roll(speed: number, ghosts: boolean): Roll {
  const world = createWorld()
  world.fill({ i0: -1, j0: 0, i1: tiles, j1: 0 }, world.shape(square), 1)
  world.commit()
  const physics = new Physics({ gravity: { x: 0, y: -gravity } })
  new PlanckTerrain(physics, world, { cellSize: cell, ghosts, material: () => ({ friction: 0 }) })
  const ball = physics.createBody({ type: 'dynamic', bullet: true, position: { x: from * cell, y: (1 + radius) * cell } })
  ball.createFixture(new Circle(radius * cell - skin), { density: 1, friction: 0 })
  ball.setLinearVelocity(new Vec2(speed * cell, 0))
  const points: Point[] = [[from, radius]], speeds = [speed], kicks: Kick[] = []
  while (points.at(-1)![0] < to) {
    const { x: vx, y: vy } = ball.getLinearVelocity().clone()
    physics.step(step, 8, 3)
    const v = ball.getLinearVelocity()
    points.push([ball.getPosition().x / cell, ball.getPosition().y / cell - 1])
    speeds.push(v.x / cell)
    if (v.y - Math.max(0, vy) > jolt) kicks.push({ time: (points.length - 1) * step, at: points.at(-1)!, change: [v.x - vx, v.y - vy] })
  }
  world.free()
  return { points, speeds, kicks }
}

export default function seams(element: HTMLElement): void {
  const fig = new Figure(element, { x0: 0, y0: 0, x1: tiles, y1: floors[0] + 2.5 }, 'Two balls on floors of tiles: one stumbles, the other one glides')
  let rough = roll(first, false), smooth = roll(first, true)
  const end = () => (rough.points.length - 1) * step
  const at = ({ points }: Roll, t: number): Point => {
    const k = Math.min(points.length - 2, Math.floor(t / step)), part = Math.min(1, t / step - k), [a, b] = [points[k], points[k + 1]]
    return [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part]
  }
  const still = fig.layer(), moving = fig.layer()
  for (const y of floors) {
    still.append(rect('slab', 0, y - thick, tiles, y))
    for (let i = 1; i < tiles; ++i) still.append(path('seam', [[i, y], [i, y - thick]]))
  }
  let time = 0, waits = 0
  const ofHandle = (): Point => [at(rough, time)[0], at(rough, time)[1] + floors[0]]
  const handle = fig.handle({
    at: [from, floors[0] + radius],
    label: 'The ball without ghosts: to and fro in time',
    step: 0.1,
    move(x) {
      hold()
      const k = rough.points.findIndex(([px]) => px >= x)
      const n = k < 0 ? rough.points.length - 1 : Math.max(1, k), [a, b] = [rough.points[n - 1][0], rough.points[n][0]]
      time = clamp((n - 1 + (x - a) / (b - a)) * step, 0, end())
      return ofHandle()
    },
  })
  const { hold } = fig.runs(() => {
    if (time >= end() && ++waits < pause) return
    if (waits >= pause) time = waits = 0
    const isNear = rough.kicks.some((kick) => kick.change[1] > large && Math.abs(time - kick.time) < around)
    time = Math.min(end(), time + step * (isNear ? slow : pace))
    handle.at = ofHandle()
  })
  fig.slider('Speed', 3, 9.4, 0.2, first, (speed) => {
    rough = roll(speed, false)
    smooth = roll(speed, true)
    time = waits = 0
    handle.at = ofHandle()
    fig.redraw()
  })
  time = rough.kicks[0].time + late
  handle.at = ofHandle()
  const facts = ({ kicks, speeds }: Roll) => `${counted(kicks.filter((kick) => kick.time <= time).length, 'kick')}, ${speeds[Math.min(speeds.length - 1, Math.round(time / step))].toFixed(1)} cells/s`
  // Below a floor, as far as there is room to the sides.
  const below = (kind: string, x: number, floor: number, text: string) => {
    const size = font * fig.pixel, half = (letter * size * text.length) / 2
    return words(`label ${kind}`, [clamp(x, half, tiles - half), floor - thick - (isNarrow ? 1.1 : 1.3) * size], size, text)
  }
  fig.draws(() => {
    const parts: SVGElement[] = [], pixel = fig.pixel, rolls = [rough, smooth], hits = rough.kicks.filter((kick) => kick.time <= time)
    if (hits.length > 0) {
      const seam = Math.round(hits[0].at[0])
      parts.push(path('wrong', [[seam, floors[0]], [seam + 1, floors[0]]]), disc('kick', [seam, floors[0]], 5 * pixel))
      parts.push(below('askew', seam + 0.5, floors[0], 'the ball hits the end of the next edge'))
    }
    const place = rolls.map((each, n): Point => [at(each, time)[0], at(each, time)[1] + floors[n]])
    rolls.forEach((each, n) => {
      const kind = n === 0 ? 'rough' : 'smooth', [x, y] = place[n], floor = floors[n]
      const what = `With${n === 0 ? 'out' : ''} ghost vertices: ${facts(each)}`
      parts.push(words(`label title ${kind}`, [tiles - 0.05, floor + title], Math.min((font + 1) * pixel, (tiles - 0.1) / (letter * what.length)), what))
      parts.at(-1)!.setAttribute('text-anchor', 'end')
      const trail = each.points.slice(0, Math.floor(time / step) + 1).map(([px, py]): Point => [px, py + floor])
      parts.push(path(`way ${kind}`, [...trail, [x, y]]))
      for (const kick of each.kicks) {
        if (kick.time > time) continue
        const [kx, ky] = [kick.at[0], floor], isLarge = kick.change[1] > large
        if (isLarge) for (let k = 0; k < 5; ++k) {
          const angle = Math.PI * (0.12 + 0.19 * k)
          parts.push(path('flash', [[kx + 0.12 * Math.cos(angle), ky + 0.12 * Math.sin(angle)], [kx + 0.3 * Math.cos(angle), ky + 0.3 * Math.sin(angle)]]))
        } else parts.push(disc('kick', [kx, ky], 3.5 * pixel))
      }
      if (n === 1) {
        const under = Math.floor(x)
        parts.push(path('whisker', [[under - 1, floor], [under + 2, floor]]), path('chosen', [[under, floor], [under + 1, floor]]))
        for (const ghost of [under - 1, under + 2]) if (ghost >= 0 && ghost <= tiles) parts.push(disc('ghostpoint', [ghost, floor], 6 * pixel))
        parts.push(below('ghostword', Math.min(under + 2, tiles), floor, '○ ghost vertex: the floor goes on'))
      }
      parts.push(disc(`rider ${kind}`, [x, y], radius))
      const angle = -x / radius
      parts.push(path('spoke', [[x, y], [x + radius * 0.75 * Math.cos(angle), y + radius * 0.75 * Math.sin(angle)]]))
      const latest = each.kicks.findLast((kick) => kick.time <= time && kick.change[1] > large && time - kick.time < 3 * around)
      if (latest !== undefined) {
        const [dx, dy] = latest.change, length = Math.hypot(dx, dy)
        const tip: Point = [x + (1.1 * dx) / length, y + (1.1 * dy) / length]
        parts.push(arrow('push wrong', [x, y], tip, 13 * pixel, 0, 0.97), words('label askew', [tip[0] - 26 * pixel, tip[1] - 6 * pixel], 15 * pixel, 'kick'))
      }
    })
    moving.replaceChildren(...parts)
    fig.say(`Without: ${facts(rough)}. With: ${facts(smooth)}.`, true)
  })
}
