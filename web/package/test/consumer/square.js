import { createWorld, unitSquare } from 'localgridseg'

export function segmentsOfASquare() {
  const world = createWorld()
  world.add(0, 0, world.shape(unitSquare), 1)
  const { length } = world.commit().added
  world.free()
  return length
}
