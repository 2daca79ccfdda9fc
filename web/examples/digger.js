// Drag to dig. What you cut off falls, and becomes ground again where it comes to rest.
// A and D, or the arrow keys, walk; the land never ends. Z, or a second finger, rewinds.
import { World } from 'planck'
import { GroundPicture } from 'localgridseg/draw'
import { init, thickLine, unitSquare } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const bedrock = 2, top = 23 // its upper row
export const colours = { 1: '#b5835a', [bedrock]: '#57434a', 3: '#3fb8ac', 4: '#d95d4a', 5: '#f0b63c', 6: '#8f8894' }
const options = { anchors: { blocks: [bedrock] }, land, undoSteps: 2000 }
const terrain = { cellSize: 0.5, material: (block) => ({ restitution: block === 4 ? 0.85 : 0 }) } // mushrooms
const fingers = new Map()
const walk = { a: -1, ArrowLeft: -1, d: 1, ArrowRight: 1 }
const inSoil = ([x, y]) => [x, Math.max(1.7, Math.min(top - 0.7, y))] // so that bedrock stays
let held = '' // a key

export async function digger(canvas, size = 24) { // pixels of a cell
  await init()
  const ground = new Ground(new World({ x: 0, y: -10 }), options, terrain)
  const picture = new GroundPicture(ground, canvas, colours, { size, x: 2 })
  onkeydown = onkeyup = onblur = ({ type, key }) => { held = type === 'keydown' ? key : '' }
  onpointerup = onpointercancel = ({ pointerId }) => fingers.delete(pointerId)
  canvas.onpointerdown = canvas.onpointermove = (finger) => {
    if (finger.buttons === 0) return
    const at = inSoil(picture.at(finger)), from = fingers.get(finger.pointerId) ?? at
    if (fingers.size < 2) ground.dig(thickLine([...from, ...at], 0.6))
    fingers.set(finger.pointerId, at)
  }
  requestAnimationFrame(function frame(now, last = now - 16) {
    const time = Math.min(0.05, (now - last) / 1000) // seconds
    picture.x += 20 * time * (walk[held] ?? 0)
    ground.window(picture.cells) // the rest leaves memory, and comes back
    held === 'z' || fingers.size > 1 ? ground.undo() : ground.step(time)
    picture.draw()
    if (canvas.isConnected) requestAnimationFrame((next) => frame(next, now))
  })
  return { ground, picture }
}

export function land(world, { i0, j0 }) { // 32 x 32 cells, when one comes near; two of them are a cavern
  if (j0 !== 0) return
  const square = world.shape(unitSquare), number = i0 / 32
  const rows = (j0, j1, block) => world.fill({ i0, j0, i1: i0 + 31, j1 }, square, block)
  const paint = (ring, block, mode) => world.paint({ rings: [ring] }, block, mode)
  const put = (ring, x, y, block) => paint(ring.map((v, n) => v + (n % 2 ? y : i0 + x)), block, 'replace')
  const xs = [0, 8, 16, 24, 32].map((dx) => i0 + dx)
  const floor = xs.map((x) => [x, 4.5 + 1.2 * Math.sin(x / 10)]).reverse()
  const roof = xs.map((x) => [x, 18 + 1.2 * Math.sin(x / 7)])
  for (const j of [0, top]) rows(j, j, bedrock)
  rows(1, 2, 1)
  rows(20, top - 1, 1)
  paint([i0, 3, i0 + 32, 3, ...floor.flat()], 1)
  paint([...roof.flat(), i0 + 32, 20, i0, 20], 1)
  const side = number % 2 ? 32 : 0, inward = side ? -1 : 1 // a wall between two caverns
  put([side, 3, side + 3 * inward, 3, side + 1.6 * inward, 11, side + 3.4 * inward, 20, side, 20], 0, 0, 1)
  for (const [what, x, y, thick] of things[((number % things.length) + things.length) % things.length]) {
    for (const [dx, y] of [[2.4, 2.4], [-2, 20.6]]) put(gem, x + dx, y + 0.4 * Math.sin(5 * x), 5)
    const stem = (...points) => world.paint(thickLine(points.map((v, n) => v + (n % 2 ? 0 : i0)), thick), 1)
    what(stem, put, x, y)
  }
}
const hanging = (stem, put, x, y) => { stem(x, y + 2, x, 20); put(crystal, x, y, 3) }
const roped = (stem, put, x, y) => { stem(x - 5, 20, x, y + 2, x + 5, 20); put(crystal, x, y, 3) }
const standing = (stem, put, x, y) => { stem(x, 3, x, y); put(spire, x, y, 3) }
const buried = (stem, put, x, y) => put(crystal, x, y, 3)
const mushroom = (stem, put, x, y) => { stem(x, 3, x, y); put(cap, x, y, 4) }
const boulder = (stem, put, x, y) => { stem(x, y, x, 20); put(stone, x, y, 6) }
const things = [ // of each chunk in turn: what it is, x, y, and half the thickness of its stem
  [[hanging, 7, 12, 0.4], [mushroom, 15, 8, 0.5], [hanging, 14, 13.5, 0.4], [roped, 26, 10.5, 0.4]],
  [[mushroom, 3, 10, 0.5], [hanging, 9, 6.6, 0.3], [boulder, 18.5, 13, 0.4], [standing, 18.9, 5.8, 1]],
  [[boulder, 8, 13, 0.4], [standing, 8.4, 5.8, 1], [mushroom, 15.5, 10, 0.4], [buried, 23, 2.2], [hanging, 27, 9, 0.3]],
  [[standing, 6, 11, 0.5], [boulder, 14, 12.5, 0.4], [buried, 14.3, 2.6], [mushroom, 21, 9, 0.4], [mushroom, 26, 11, 0.5]],
  [[roped, 10, 10, 0.5], [boulder, 19, 12, 0.5], [standing, 19.3, 6, 1.3], [standing, 26.5, 12, 0.4]],
  [[mushroom, 5, 9, 0.4], [roped, 14, 8, 0.4], [boulder, 22, 13, 0.4], [mushroom, 22.5, 8, 0.4], [buried, 27, 19]]]
const cap = [-2.3, 0, 2.3, 0, 1.8, 1.1, 0.7, 1.7, -0.7, 1.7, -1.8, 1.1]
const crystal = [-1.9, 1.2, -0.7, -0.9, 0.3, -1.1, 1.9, 1.6, 1, 2.8, -1.1, 2.8]
const spire = [-1.6, 0, 1.2, 0, 1.9, 1.3, 0.4, 3.4, -0.5, 3.1, -1.9, 1.6]
export const stone = [-1.4, -2, 1, -2.2, 2.3, -0.6, 1.9, 1.4, 0.3, 2.3, -1.7, 1.8, -2.4, -0.2]
const gem = [-0.5, 0, 0, -0.7, 0.5, 0, 0, 0.7]
