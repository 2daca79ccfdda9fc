import { createWorld, init, unitSquare } from 'localgridseg'

// Vite's workers have no await at the top level.
init().then(() => {
  const world = createWorld()
  world.addPolygon(0, 0, unitSquare, 1)
  postMessage(world.commit().added.length)
})
