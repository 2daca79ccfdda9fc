// Boxes on ground that is dug away and comes back, with box2d3-wasm.
import Box2DFactory from 'box2d3-wasm'
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { Box2dTerrain } from 'localgridseg/box2d3'

await init()
const b2 = await Box2DFactory()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 29, j1: 5 }, world.shape(unitSquare), 1)
world.commit()

const worldDef = b2.b2DefaultWorldDef()
worldDef.gravity = new b2.b2Vec2(0, -10)
const physics = b2.b2CreateWorld(worldDef)
const terrain = new Box2dTerrain(b2, physics, world, { material: () => ({ friction: 0.5 }) })
const boxes = Array.from({ length: 10 }, (_, k) => {
  const def = b2.b2DefaultBodyDef()
  def.type = b2.b2BodyType.b2_dynamicBody
  def.position = new b2.b2Vec2(2 + 2.6 * k, 7)
  const box = b2.b2CreateBody(physics, def)
  b2.b2CreatePolygonShape(box, b2.b2DefaultShapeDef(), b2.b2MakeBox(0.4, 0.4))
  return box
})

const mark = world.mark()
for (let step = 0; step < 300; ++step) {
  terrain.beforeStep()
  b2.b2World_Step(physics, 1 / 60, 4)
  terrain.afterStep()
  if (step % 20 === 0) {
    world.carve(circle(2 + (step / 300) * 26, 6, 1.5))
    terrain.commit()
  }
}
console.log(`${boxes.filter((box) => b2.b2Body_GetPosition(box).y < 6).length} boxes are in a hole`)

terrain.sync(world.rollBack(mark))
console.log(`${terrain.overlaps.length} were in the ground that came back`)
for (let step = 0; step < 300; ++step) {
  terrain.beforeStep()
  b2.b2World_Step(physics, 1 / 60, 4)
  terrain.afterStep()
}
console.log(`${boxes.filter((box) => b2.b2Body_GetPosition(box).y > 6).length} of ${boxes.length} boxes are above the ground`)
