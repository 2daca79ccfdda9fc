// What a game waits for, besides tile edits (bench.mjs): a terrain's sync, lines drawn anew, strokes, worlds and fills. In
// microseconds of the processor, medians of rounds that take turns. It prints a table of docs/performance.md.
//
//   node work.mjs [rounds]                                                       (npm ci first; the package must be built)
import { circle, createWorld, init, unitSquare } from 'localgridseg'
import { GroundMeshes, OutlineLines } from 'localgridseg/draw'
import { PlanckTerrain } from 'localgridseg/planck'
import { EdgeShape, World as Physics } from 'planck'

const rounds = Number(process.argv[2] ?? 15)
const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]

await init()
const ramp = [0, 0, 1, 0, 1, 1]

/** A world of side x side cells, with a hole in every third of every third row; and an edit that digs one and fills it. */
function ground(side, shape = unitSquare) {
  const world = createWorld(), id = world.shape(shape)
  world.fill({ i0: 0, j0: 0, i1: side - 1, j1: side - 1 }, id, 1)
  for (let j = 1; j < side; j += 3) for (let i = 1; i < side; i += 3) world.clear(i, j)
  world.commit()
  let isDug = false
  const edit = () => {
    if (isDug) world.add((side >> 1) - ((side >> 1) % 3), side >> 1, id, 1)
    else world.clear((side >> 1) - ((side >> 1) % 3), side >> 1)
    isDug = !isDug
    return world.commit()
  }
  return { world, edit }
}

/** The times of `work` alone, each after `prepare`. Of single ones the median is taken: other programs do not show in it. */
function task(count, prepare, work) {
  return () => Array.from({ length: count }, () => {
    const given = prepare()
    const from = performance.now()
    work(given)
    return 1000 * (performance.now() - from)
  })
}

const tasks = {}

for (const [side, shape, name] of [[16, unitSquare, 'full'], [64, unitSquare, 'full'], [64, ramp, 'ramps']]) {
  const label = `${side}², ${name}`
  {
    const { world, edit } = ground(side, shape), physics = new Physics({ x: 0, y: -10 })
    const terrain = new PlanckTerrain(physics, world)
    physics.createBody({ type: 'dynamic', position: { x: -50, y: -50 } }) // so that the terrain looks for bodies
    physics.step(1 / 60)
    tasks[`PlanckTerrain.sync of a tile, ${label}`] = task(40, () => (physics.step(1 / 60), edit()), (changes) => terrain.sync(changes))
  }
  {
    // What planck itself takes: the same fixtures, by hand, on the same bodies.
    const { world, edit } = ground(side, shape), physics = new Physics({ x: 0, y: -10 })
    const bodies = new Map(), fixtures = []
    const bodyAt = (i, j) => {
      const key = (i >> 4) * 65536 + (j >> 4)
      if (!bodies.has(key)) bodies.set(key, physics.createBody())
      return bodies.get(key)
    }
    const add = (list) => {
      const { id, geometry: g, cell } = list
      for (let k = 0; k < id.length; ++k) {
        const at = 8 * k, shape = new EdgeShape({ x: g[at], y: g[at + 1] }, { x: g[at + 2], y: g[at + 3] })
        shape.setPrevVertex({ x: g[at + 4], y: g[at + 5] })
        shape.setNextVertex({ x: g[at + 6], y: g[at + 7] })
        fixtures[id[k]] = bodyAt(cell[2 * k], cell[2 * k + 1]).createFixture(shape)
      }
    }
    add(world.segments())
    physics.step(1 / 60)
    tasks[`planck alone, the same fixtures, ${label}`] = task(40, () => (physics.step(1 / 60), edit()), ({ removed, added, relinked }) => {
      for (const id of removed) fixtures[id].getBody().destroyFixture(fixtures[id])
      add(added)
      const { id, geometry: g } = relinked
      for (let k = 0; k < id.length; ++k) {
        const shape = fixtures[id[k]].getShape(), at = 8 * k
        shape.setPrevVertex({ x: g[at + 4], y: g[at + 5] })
        shape.setNextVertex({ x: g[at + 6], y: g[at + 7] })
      }
    })
  }
  {
    const { world, edit } = ground(side, shape), outline = new OutlineLines(world)
    tasks[`OutlineLines.update of a tile, ${label}`] = task(40, edit, (changes) => outline.update(changes))
  }
  if (side === 64) {
    const { world, edit } = ground(side, shape), meshes = new GroundMeshes(world)
    tasks[`GroundMeshes.update of a tile, ${label}`] = task(10, edit, (changes) => meshes.update(changes))
  }
}

for (const radius of [1, 3]) {
  const { world } = ground(64), mark = world.checkpoint(), hole = circle(30.3, 30.6, radius)
  tasks[`carve of radius ${radius} and commit`] = task(10, () => world.rollBack(mark), () => {
    world.carve(hole)
    world.commit()
  })
}
{
  const kept = Array.from({ length: 1000 }, () => createWorld())
  const make = task(100, () => {}, () => kept.push(createWorld()))
  tasks['createWorld, with 1,000 worlds kept'] = () => {
    const times = make()
    for (const world of kept.splice(1000)) world.free()
    return times
  }
}
for (const side of process.argv.includes('--large') ? [3000, 10_000] : [300, 1000])
  tasks[`fill of ${side}²`] = task(1, () => createWorld(), (world) => {
    world.fill({ i0: 0, j0: 0, i1: side - 1, j1: side - 1 }, world.shape(unitSquare), 1)
    world.free()
  })

const times = Object.fromEntries(Object.keys(tasks).map((name) => [name, []]))
for (let round = -1; round < rounds; ++round)
  for (const [name, run] of Object.entries(tasks)) {
    const all = run()
    if (round >= 0) times[name].push(...all)
  }
console.log('| work | median, µs | least, µs |\n|---|---:|---:|')
for (const [name, all] of Object.entries(times)) console.log(`| ${name} | ${median(all).toPrecision(3)} | ${Math.min(...all).toPrecision(3)} |`)
