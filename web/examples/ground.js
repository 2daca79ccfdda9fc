// The worker of worker.js: it has the world, and hands over what each stroke changed.
import { circle, createWorld, init, unitSquare } from 'localgridseg'

await init()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 31, j1: 9 }, world.shape(unitSquare), 1)

function tell() {
  const copy = world.commit().copy()
  postMessage(copy, copy.buffers()) // handed over, not copied again
}

tell()
onmessage = ({ data: { x, y, radius } }) => {
  world.carve(circle(x, y, radius))
  tell()
}
