// What the tests of Ground stand on, and how they look at it.
import assert from 'node:assert/strict'
import { World as Physics } from 'planck'
import { Ground, LgsError, unitSquare } from 'localgridseg/islands'
import { Ground as PlanckGround } from 'localgridseg/planck'

export const bedrock = 9
export const anchors = { blocks: [bedrock] }
export const square = [0, 0, 1, 0, 1, 1, 0, 1]
export const refuses = (code, call) => assert.throws(call, (error) => error instanceof LgsError && error.code === code)

export const areaOf = (polygons) => polygons.reduce((sum, { vertices: v }) => {
  for (let k = 0; k < v.length; k += 2) sum += (v[k] * v[(k + 3) % v.length] - v[k + 1] * v[(k + 2) % v.length]) / 2
  return sum
}, 0)
/** Of the ground in memory and of the rocks. */
export const matterOf = (ground) => areaOf(ground.world.polygons()) + ground.rocks().reduce((sum, { ground: { mass } }) => sum + mass.area, 0)
export const solidOf = (world, cells) => world.polygons(cells).map(({ i, j, block, vertices }) => `${i} ${j} ${block} ${vertices.join()}`).sort()

/** A floor of bedrock, a pillar, and an arm on it. */
export function pillar(ground) {
  ground.edit((world) => {
    world.fill({ i0: -10, j0: -1, i1: 20, j1: -1 }, world.shape(unitSquare), bedrock)
    world.fill({ i0: 0, j0: 0, i1: 0, j1: 3 }, world.shape(unitSquare), 1)
    world.fill({ i0: 1, j0: 3, i1: 4, j1: 3 }, world.shape(unitSquare), 2)
  })
  ground.forgetUndo()
  return ground
}
export function withPlanck(options = {}, terrain = {}) {
  const physics = new Physics({ gravity: { x: 0, y: -10 } })
  return { physics, ground: new PlanckGround(physics, { anchors, ...options }, terrain, { density: () => 2 }) }
}
export const steps = (ground, count) => { for (let k = 0; k < count; ++k) ground.step(1 / 60) }

/** Hills that go on for ever, with bedrock below. */
export const land = (world, { i0, j0, i1, j1 }) => {
  const shape = world.shape(unitSquare)
  for (let i = i0; i <= i1; ++i)
    for (let j = Math.max(j0, -40); j <= Math.min(j1, 3 + Math.floor(3 * Math.sin(i / 5))); ++j) world.add(i, j, shape, j === -40 ? bedrock : 1)
}

/** All ground and all rocks, those that are not in memory too. */
export function allOf(ground, { preserve } = {}) {
  const all = new Ground(preserve ? { preserve } : {})
  all.load(ground.save())
  const solid = solidOf(all.world), rocks = all.rocks(), matter = matterOf(all)
  // Where what fell was, while nothing has moved.
  const cells = [...solid, ...rocks.flatMap(({ ground: { polygons }, x, y }) =>
    polygons.map(({ i, j, block, vertices }) => `${x + i} ${y + j} ${block} ${vertices.join()}`))].sort()
  all.free()
  return { solid, rocks: rocks.map(({ ground: { mass }, x, y, angle }) => [mass.area, x, y, angle]), matter, cells }
}
