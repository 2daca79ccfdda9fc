// Why bodies trip over seams: a wheel on a floor of tiles, with ghosts and without.
import { createWorld } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, Vec2, World as Physics } from 'planck'
import { counted, solids, square } from '../ground.js'
import { clamp, Figure } from '../kit.js'
import { disc, path, type Point, words } from '../svg.js'

const cell = 0.25 // metres, as in the sandbox: marbles are small, and a seam is large for them
const speed = 3 // cells a second
const radius = 0.4
const skin = 0.005 // metres: so far from an edge planck lets a wheel rest. This one is made smaller by it
const tiles = 12
const jolt = 0.01 // metres a second: the floor is level, so who moves up by more was kicked
const height = 9 // times: how much higher than it is the path is drawn

export default function seams(element: HTMLElement): void {
  const fig = new Figure(element, { x0: 0, y0: -0.2, x1: tiles, y1: 4.2 }, 'A wheel on a floor of tiles')
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: tiles - 1, j1: 0 }, world.shape(square), 1)
  world.commit()
  const physics = new Physics({ gravity: { x: 0, y: -3 } })
  const terrain = new PlanckTerrain(physics, world, { cellSize: cell, ghosts: false, material: () => ({ friction: 0 }) })
  const wheel = physics.createBody({ type: 'dynamic', bullet: true })
  wheel.createFixture(new Circle(radius * cell - skin), { density: 1, friction: 0 })
  let trail: Point[] = []
  let kicks: Point[] = []
  let isHeld = false
  let wasUp = 0

  const put = (x: number, y: number, vx: number) => {
    wheel.setTransform(new Vec2(x * cell, y * cell), wheel.getAngle())
    wheel.setLinearVelocity(new Vec2(vx * cell, 0))
    wheel.setAwake(true)
    wasUp = 0
  }
  const begin = () => {
    trail = []
    kicks = []
    put(0.5, 1 + radius, speed)
  }
  const at = (): Point => [wheel.getPosition().x / cell, wheel.getPosition().y / cell]

  fig.toggle('Ghost vertices', false, (isOn) => {
    terrain.ghosts = isOn
    begin()
    fig.redraw()
  })
  const ground = fig.layer()
  const moving = fig.layer()
  ground.append(...solids(world, 'ground tile'))
  const handle = fig.handle({
    at: [0.5, 1.4],
    label: 'The wheel',
    step: 0.25,
    move(x, y) {
      isHeld = true
      const to: Point = [clamp(x, 0.4, tiles - 0.5), clamp(y, 1.4, 3.6)]
      put(...to, 0)
      trail = []
      kicks = []
      return to
    },
    drop() {
      isHeld = false
      put(...at(), speed)
    },
  })
  fig.runs(() => {
    if (isHeld) return
    physics.step(1 / 60, 8, 3)
    const [x, y] = at()
    const up = wheel.getLinearVelocity().y
    if (up - Math.max(0, wasUp) > jolt) kicks.push([x, y])
    wasUp = up
    trail.push([x, y])
    if (x > tiles + 0.5 || y < -1 || wheel.getLinearVelocity().x < 0.02) begin()
    handle.at = at()
  })
  begin()
  fig.draws(() => {
    const rest = 1 + radius
    const higher = ([x, y]: Point): Point => [x, 2.6 + (y - rest) * height]
    const [x, y] = at()
    const parts: SVGElement[] = [path('grid', [[0, 2.6], [tiles, 2.6]]), disc('wheel', [x, y], radius)]
    const angle = -x / radius
    parts.push(path('spoke', [[x, y], [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]]))
    if (trail.length > 1) parts.push(path('trail', trail.map(higher)))
    for (const kick of kicks) parts.push(disc('kick', higher(kick), 5 * fig.pixel))
    parts.push(words('label', [tiles / 2, 3.8], 13 * fig.pixel, `its path, ${height} times as high`))
    moving.replaceChildren(...parts)
    const now = wheel.getLinearVelocity().x / cell
    fig.say(`${counted(kicks.length, 'kick')} on this run. Speed ${now.toFixed(2)} of ${speed} cells a second.`, true)
  })
}
