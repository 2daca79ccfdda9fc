// Balls that dig where they hit; then the holes are filled again over them, and nobody falls through.
import { createWorld, init, unitSquare } from 'localgridseg'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, World } from 'planck'

await init()
const world = createWorld()
const square = world.shape(unitSquare)
world.fill({ i0: 0, j0: 0, i1: 29, j1: 5 }, square, 1)
world.commit()

const physics = new World({ x: 0, y: -10 })
const terrain = new PlanckTerrain(physics, world, { material: () => ({ friction: 0.5 }) })
const balls = Array.from({ length: 10 }, (_, k) => {
  const ball = physics.createBody({ type: 'dynamic', position: { x: 2 + 2.6 * k, y: 9 } })
  ball.createFixture(new Circle(0.4), { density: 1, restitution: 0.2 })
  return ball
})

// In a step nothing can be changed: note what was hit, and dig after the step.
const touched = []
physics.on('begin-contact', (contact) => {
  for (const fixture of [contact.getFixtureA(), contact.getFixtureB()]) {
    const hit = terrain.hit(fixture)
    if (hit) touched.push(hit)
  }
})

const mark = world.mark()
for (let step = 0; step < 300; ++step) {
  terrain.beforeStep()
  physics.step(1 / 60)
  terrain.afterStep()
  for (const { i, j } of touched.splice(0)) if (j > 2) world.clear(i, j)
  terrain.commit()
}
console.log(`${world.stats().cells} of 180 cells are left`)

terrain.sync(world.rollBack(mark)) // all holes are full again
console.log(`${terrain.overlaps.length} balls were in the ground that came back`)
for (let step = 0; step < 300; ++step) {
  terrain.beforeStep()
  physics.step(1 / 60)
  terrain.afterStep()
}
console.log(`${balls.filter((ball) => ball.getPosition().y > 5).length} of ${balls.length} balls are above the ground`)
