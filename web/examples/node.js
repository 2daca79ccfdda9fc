// Save and load, and what a commit says.
import { circle, createWorld, init, loadWorld, unitSquare } from 'localgridseg'

await init()
const world = createWorld()
world.fill({ i0: 0, j0: 0, i1: 19, j1: 4 }, world.shape(unitSquare), 1)
world.commit()
const text = world.saveText() // for a file, a database, localStorage

const loaded = loadWorld(text)
const { removed, changed } = loaded.carve(circle(10, 5, 2))
console.log(`${removed.length} cells are empty, ${changed.length} are cut`)
for (const { start, end, block } of loaded.commit().added) console.log(`block ${block}: ${start.join(' ')} to ${end.join(' ')}`)
world.free()
loaded.free()
