// A digger to begin with, in strict TypeScript: drag to dig, what you cut off falls, Z takes it back. By Vite, which needs
// no settings: npx vite vite
import { World as Physics } from 'planck'
import { GroundPicture } from 'localgridseg/draw'
import { type CellRect, init, thickLine, unitSquare, type World } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const soil = 1, bedrock = 2
const canvas = document.querySelector('canvas')!

await init()
const ground = new Ground(new Physics({ x: 0, y: -10 }), { anchors: { blocks: [bedrock] }, land }, { cellSize: 0.5 })
const picture = new GroundPicture(ground, canvas, { [soil]: '#b5835a', [bedrock]: '#57434a' }, { size: 24 })

canvas.onpointerdown = canvas.onpointermove = (event: PointerEvent) => {
  if (event.buttons !== 0) ground.dig(...picture.at(event), 0.7)
}
onkeydown = ({ key }: KeyboardEvent) => {
  if (key === 'z') ground.undo()
}
requestAnimationFrame(function frame(now: number, last = now - 16) {
  ground.window(picture.cells)
  ground.step(Math.min(0.05, (now - last) / 1000))
  picture.draw()
  document.body.dataset.rocks = String(ground.rocks().length)
  requestAnimationFrame((next) => frame(next, now))
})

/** Of each chunk of 32 x 32 cells, when one comes near. */
function land(world: World, { i0, j0 }: CellRect): void {
  if (j0 !== 0) return
  const square = world.shape(unitSquare), rows = (from: number, to: number) => ({ i0, j0: from, i1: i0 + 31, j1: to })
  for (const j of [0, 17]) world.fill(rows(j, j), square, bedrock)
  world.fill(rows(1, 3), square, soil)
  for (const x of [6, 16, 26]) {
    world.paint(thickLine([i0 + x, 8, i0 + x, 17], 0.5), soil)
    world.paint(thickLine([i0 + x - 2, 8, i0 + x + 2, 8], 1), soil)
  }
}
