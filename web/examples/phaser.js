// Phaser 4: filled ground and its outline, chunk by chunk. Click to dig.
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { GroundMeshes, OutlineLines } from 'localgridseg/draw'
import Phaser from 'phaser'

await init()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 31, j1: 9 }, world.shape(unitSquare), 1)
world.commit()
const ground = new GroundMeshes(world), outline = new OutlineLines(world)

const scale = 20, height = 16 * scale
class Digging extends Phaser.Scene {
  create() {
    const layers = [new Map(), new Map()]
    /** The picture of a chunk, empty. */
    const clear = (layer, key) => {
      if (!layers[layer].has(key)) layers[layer].set(key, this.add.graphics().setDepth(layer))
      return layers[layer].get(key).clear()
    }
    const fill = ({ key, cells: { i0, j0 }, positions, indices }) => {
      const graphics = clear(0, key).fillStyle(0xaa9988)
      const corner = (k) => [(i0 + positions[2 * k]) * scale, height - (j0 + positions[2 * k + 1]) * scale]
      for (let k = 0; k < indices.length; k += 3)
        graphics.fillTriangle(...corner(indices[k]), ...corner(indices[k + 1]), ...corner(indices[k + 2]))
    }
    const draw = ({ key, lines }) => {
      const graphics = clear(1, key).lineStyle(2, 0x332211)
      for (const line of lines) {
        const points = Array.from({ length: line.length / 2 }, (_, k) =>
          new Phaser.Math.Vector2(line[2 * k] * scale, height - line[2 * k + 1] * scale))
        graphics.strokePoints(points)
      }
    }
    ground.all().forEach(fill)
    outline.all().forEach(draw)
    this.input.on('pointerdown', ({ x, y }) => {
      world.carve(circle(x / scale, (height - y) / scale, 1.5))
      const changes = world.commit()
      ground.update(changes).forEach(fill)
      outline.update(changes).forEach(draw)
    })
    document.body.dataset.ready = 'yes'
  }
}
new Phaser.Game({
  type: Phaser.WEBGL, width: 32 * scale, height, backgroundColor: '#ddeeff', scene: Digging, banner: false,
  audio: { noAudio: true }, render: { preserveDrawingBuffer: true },
})
