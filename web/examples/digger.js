// Drag to dig. What you cut off falls, and is ground again where it rests.
// A and D, or the arrow keys, walk, the land has no end; Z, or a second finger, goes back in time.
import { World } from 'planck'
import { GroundPicture } from 'localgridseg/draw'
import { init, thickLine, unitSquare } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const bedrock = 2
export const colours = { 1: '#b5835a', [bedrock]: '#57434a', 3: '#3fb8ac', 4: '#d95d4a', 5: '#f0b63c' }
const options = { anchors: { blocks: [bedrock] }, land, undoSteps: 2000 }
const fingers = new Map()
const walk = { a: -1, ArrowLeft: -1, d: 1, ArrowRight: 1 }
let held = '' // a key

export async function digger(canvas, size = 24) { // pixels of a cell
  await init()
  const ground = new Ground(new World({ x: 0, y: -10 }), options, { cellSize: 0.5 })
  const picture = new GroundPicture(ground, canvas, colours, { size, x: 38.2 })
  onkeydown = onkeyup = onblur = ({ type, key }) => { held = type === 'keydown' ? key : '' }
  onpointerup = onpointercancel = ({ pointerId }) => fingers.delete(pointerId)
  canvas.onpointerdown = canvas.onpointermove = (finger) => {
    if (finger.buttons === 0) return
    const at = picture.at(finger), from = fingers.get(finger.pointerId) ?? at
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

function land(world, { i0, j0 }) { // 32 x 32 cells, when one comes near
  if (j0 !== 0) return
  const square = world.shape(unitSquare)
  const rows = (j0, j1, block) => world.fill({ i0, j0, i1: i0 + 31, j1 }, square, block)
  const paint = (ring, block, mode) => world.paint({ rings: [ring] }, block, mode)
  const put = (ring, x, y, block) =>
    paint(ring.map((v, n) => v + (n % 2 ? y : x)), block, 'replace')
  const i1 = i0 + 32, xs = [0, 8, 16, 24, 32].map((dx) => i0 + dx)
  const floor = xs.map((x) => [x, 4.5 + 1.2 * Math.sin(x / 10)]).reverse()
  const roof = xs.map((x) => [x, 19 + 1.4 * Math.sin(x / 7)])
  for (const j of [0, 31]) rows(j, j, bedrock)
  rows(1, 2, 1)
  rows(21, 30, 1)
  paint([i0, 3, i1, 3, ...floor.flat()], 1)
  paint([...roof.flat(), i1, 21, i0, 21], 1)
  for (let k = 0, x = i0 + 3.2; k < 5; ++k, x += 6.2) {
    const stands = k % 2, y = (stands ? 11.5 : 12) + 1.6 * Math.sin(x)
    world.paint(thickLine(stands ? [x, 3, x, y] : [x, y + 2, x, 21], 0.4), 1)
    put(stands ? cap : crystal, x, y, 3 + stands)
    for (const [dx, y] of [[2, 2.2], [-1.5, 23], [1.2, 27]])
      put(gem, x + dx + Math.sin(5 * x), y + 0.3 * y / 9 * Math.cos(3 * x), 5)
  }
}
const cap = [-2.3, 0, 2.3, 0, 1.8, 1.1, 0.7, 1.7, -0.7, 1.7, -1.8, 1.1]
const crystal = [-1.9, 1.2, -0.7, -0.9, 0.3, -1.1, 1.9, 1.6, 1, 2.8, -1.1, 2.8]
const gem = [-0.5, 0, 0, -0.7, 0.5, 0, 0, 0.7]
