// A plain canvas: click to dig. Only the chunks that changed are drawn anew.
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { GroundMeshes, OutlineLines } from 'localgridseg/draw'

await init()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 31, j1: 9 }, world.shape(unitSquare), 1)
world.commit()
const ground = new GroundMeshes(world), outline = new OutlineLines(world)

const scale = 20
const canvas = Object.assign(document.createElement('canvas'), { width: 32 * scale, height: 16 * scale })
document.body.append(canvas)
const context = canvas.getContext('2d')
context.setTransform(scale, 0, 0, -scale, 0, canvas.height) // cells, y up
context.lineWidth = 2 / scale

function fill({ cells, positions, indices }) {
  context.clearRect(cells.i0, cells.j0, cells.i1 + 1 - cells.i0, cells.j1 + 1 - cells.j0)
  context.fillStyle = context.strokeStyle = '#a98'
  context.beginPath()
  for (let k = 0; k < indices.length; k += 3) {
    for (let corner = 0; corner < 3; ++corner) {
      const at = 2 * indices[k + corner], x = cells.i0 + positions[at], y = cells.j0 + positions[at + 1]
      corner === 0 ? context.moveTo(x, y) : context.lineTo(x, y)
    }
    context.closePath()
  }
  context.fill()
  context.stroke() // no gaps between triangles
}

function draw({ lines }) {
  context.strokeStyle = '#321'
  for (const line of lines) {
    context.beginPath()
    for (let k = 0; k < line.length; k += 2) context.lineTo(line[k], line[k + 1])
    context.stroke()
  }
}

ground.all().forEach(fill)
outline.all().forEach(draw)
canvas.addEventListener('pointerdown', ({ offsetX, offsetY }) => {
  world.carve(circle(offsetX / scale, (canvas.height - offsetY) / scale, 1.5))
  const changes = world.commit()
  ground.update(changes).forEach(fill)
  outline.update(changes).forEach(draw)
})
document.body.dataset.ready = 'yes'
