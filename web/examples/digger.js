// Drag to dig. What you cut off falls, and is ground again where it rests.
// A and D walk, the land has no end; Z, or a second finger, goes back in time.
import { World } from 'planck'
import { GroundPicture } from 'localgridseg/draw'
import { init, thickLine } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const bedrock = 2, colours = { 1: '#b08968', [bedrock]: '#5d4a3a', 3: '#d1604c' }
const options = { anchors: { blocks: [bedrock] }, land, undoSteps: 2000 }
const fingers = new Map(), held = {} // keys

export async function digger(canvas, size = 24) { // pixels of a cell
  await init()
  const ground = new Ground(new World({ x: 0, y: -10 }), options, { cellSize: 0.5 })
  const picture = new GroundPicture(ground, canvas, colours, { size, x: 38.2 })
  onkeydown = onkeyup = ({ key, type }) => { held[key] = type === 'keydown' }
  onpointerup = onpointercancel = ({ pointerId }) => fingers.delete(pointerId)
  canvas.onpointerdown = canvas.onpointermove = (finger) => {
    if (finger.buttons === 0) return
    const at = picture.at(finger), from = fingers.get(finger.pointerId) ?? at
    if (fingers.size < 2) ground.dig(thickLine([...from, ...at], 0.6))
    fingers.set(finger.pointerId, at)
  }
  requestAnimationFrame(function frame() {
    picture.x += (!!held.d - !!held.a) / 3
    ground.window(picture.cells) // the rest leaves memory, and comes back
    if (held.z || fingers.size > 1) ground.undo()
    else ground.step(1 / 60)
    picture.draw()
    if (canvas.isConnected) requestAnimationFrame(frame)
  })
  return ground
}

function land(world, { i0, j0 }) { // makes 32 x 32 cells, when one comes near
  if (j0 !== 0) return
  const hill = (x) => 4.5 + 1.2 * Math.sin(x / 10)
  const soil = [0, 8, 16, 24, 32].flatMap((dx) => [i0 + 32 - dx, hill(i0 + 32 - dx)])
  world.paint({ rings: [[i0, 1, i0 + 32, 1, ...soil]] }, 1)
  world.paint({ rings: [[i0, 0, i0 + 32, 0, i0 + 32, 1, i0, 1]] }, bedrock)
  for (let x = i0 + 3.2; x < i0 + 30; x += 6.2) {
    const top = 14 + 1.6 * Math.sin(x)
    const cap = [-2.3, 0, 2.3, 0, 1.8, 1.1, 0.7, 1.7, -0.7, 1.7, -1.8, 1.1]
    world.paint({ rings: [cap.map((v, k) => v + (k % 2 === 0 ? x : top))] }, 3)
    world.paint(thickLine([x, 1, x, top], 0.4), 1) // its stem
  }
}
