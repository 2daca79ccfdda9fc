// A digger for a phone: drag to dig. What you cut off falls, and is ground again where
// it rests. Hold Z, or put a second finger down, to go back in time.
import { World } from 'planck'
import { GroundPicture } from 'localgridseg/draw'
import { init, thickLine } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const bedrock = 2, colours = { 1: '#b08968', [bedrock]: '#5d4a3a', 3: '#d1604c' }

export async function digger(canvas, size = 24) { // pixels of a cell
  await init()
  const physics = new World({ x: 0, y: -10 }), anchors = { blocks: [bedrock] }
  const ground = new Ground(physics, { anchors, undoSteps: 2000 }, { cellSize: 0.5 })
  const picture = new GroundPicture(ground, colours), context = canvas.getContext('2d')
  const { clientWidth, clientHeight } = canvas, fingers = new Map(), keys = new Set()
  ground.edit((world) => mushrooms(world, clientWidth / size, clientHeight / size))
  ground.forgetUndo()
  canvas.onpointerdown = canvas.onpointermove = (finger) => {
    if (finger.buttons === 0) return
    const at = [finger.offsetX / size, (clientHeight - finger.offsetY) / size]
    const from = fingers.get(finger.pointerId) ?? at
    if (fingers.size < 2) ground.dig(thickLine([...from, ...at], 0.6))
    fingers.set(finger.pointerId, at)
  }
  onpointerup = onpointercancel = ({ pointerId }) => fingers.delete(pointerId)
  onkeydown = ({ key }) => keys.add(key)
  onkeyup = ({ key }) => keys.delete(key)
  requestAnimationFrame(function frame() {
    if (keys.has('z') || fingers.size > 1) ground.undo()
    else ground.step(1 / 60)
    const scale = (size * canvas.width) / clientWidth
    context.clearRect(0, 0, canvas.width, canvas.height)
    picture.draw(context, [scale, 0, 0, -scale, 0, canvas.height]) // cells, y up
    requestAnimationFrame(frame)
  })
  return ground
}

function mushrooms(world, w, h) {
  world.paint({ rings: [[0, 1, w, 1, w, h / 5, w / 2, h / 4, 0, h / 5]] }, 1)
  const walls = [[-1, 0, 0, 0, 0, 99, -1, 99], [w, 0, w + 1, 0, w + 1, 99, w, 99]]
  world.paint({ rings: [[0, 0, w, 0, w, 1, 0, 1], ...walls] }, bedrock)
  for (let x = 3; x < w - 2.4; x += 5.6) {
    const top = h * (0.58 + 0.12 * Math.sin(x))
    const cap = [-2.3, 0, 2.3, 0, 1.8, 1.1, 0.7, 1.7, -0.7, 1.7, -1.8, 1.1]
    world.paint({ rings: [cap.map((v, k) => v + (k % 2 === 0 ? x : top))] }, 3)
    world.paint(thickLine([x, 1, x, top], 0.4), 1) // its stem
  }
}
