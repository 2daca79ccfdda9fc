// Pixi 8: filled ground as meshes, chunk by chunk. Click to dig.
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { GroundMeshes } from 'localgridseg/draw'
import { Application, Container, Mesh, MeshGeometry, Texture } from 'pixi.js'

await init()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 31, j1: 9 }, world.shape(unitSquare), 1)
world.commit()
const ground = new GroundMeshes(world)

const scale = 20
const app = new Application()
await app.init({ width: 32 * scale, height: 16 * scale, background: '#def', preserveDrawingBuffer: true })
document.body.append(app.canvas)
const cells = app.stage.addChild(new Container({ y: 16 * scale, scale: { x: scale, y: -scale } })) // cells, y up

const meshes = new Map()
function show({ key, cells: { i0, j0 }, positions, indices }) {
  meshes.get(key)?.destroy()
  meshes.delete(key)
  if (indices.length === 0) return
  const geometry = new MeshGeometry({ positions, indices, uvs: new Float32Array(positions.length) })
  const mesh = new Mesh({ geometry, texture: Texture.WHITE, tint: 0xaa9988, position: { x: i0, y: j0 } })
  meshes.set(key, cells.addChild(mesh))
}

ground.all().forEach(show)
app.canvas.addEventListener('pointerdown', ({ offsetX, offsetY }) => {
  world.carve(circle(offsetX / scale, 16 - offsetY / scale, 1.5))
  ground.update(world.commit()).forEach(show)
})
app.ticker.addOnce(() => (document.body.dataset.ready = 'yes'))
