// A digger that plays by itself, with planck: a world without end that streams in and out, rocks that fall and become
// ground again, undo and redo, save and load, and a second world that is told over a line what looks different.
//
//     node game.js 30000 1        # frames, seed
import { Circle, World as Physics } from 'planck'
import { circle, createWorld, init, unitSquare } from 'localgridseg/islands'
import { Ground } from 'localgridseg/planck'

const [frames = 3000, seed = 1] = process.argv.slice(2).map(Number)
const earth = 1, stone = 2, bedrock = 9
await init()

/** Hills with caves on bedrock. */
function land(world, { i0, j0, i1, j1 }) {
  const square = world.shape(unitSquare)
  for (let i = i0; i <= i1; ++i) {
    const top = 20 + Math.floor(Math.abs((i & 31) - 16) / 3)
    for (let j = Math.max(j0, -1); j <= Math.min(j1, top); ++j)
      if (j < 2 || (((i * 13 + j * 7) % 23) + 23) % 23 > 2) world.add(i, j, square, j < 1 ? bedrock : (i & 7) < 2 ? stone : earth)
  }
}

const physics = new Physics({ x: 0, y: -10 })
const ground = new Ground(physics, { anchors: { blocks: [bedrock] }, land, undoSteps: 20 }, { cellSize: 0.5, merge: true })
const around = (x) => ({ i0: x - 48, j0: -16, i1: x + 48, j1: 47 })
ground.window(around(0))
const balls = Array.from({ length: 12 }, (_, k) => {
  const ball = physics.createBody({ type: 'dynamic', position: { x: 1.3 * (k - 6), y: 17 } })
  ball.createFixture(new Circle(0.2), { density: 1 })
  return ball
})

/** The other end of the line: squares come as text, and are set in a world of its own. */
const theirs = createWorld()
function receive(line) {
  const { cells, fills } = JSON.parse(line)
  theirs.clear(cells)
  for (const { block, vertices } of fills) {
    const i = Math.floor(middle(vertices, 0)), j = Math.floor(middle(vertices, 1))
    theirs.addPolygon(i, j, vertices.map((v, k) => v - (k % 2 ? j : i)), block)
  }
  theirs.commit()
}
const middle = (vertices, axis) => vertices.reduce((sum, v, k) => sum + (k % 2 === axis ? v : 0), 0) / (vertices.length / 2)
const say = (cells, fills) => receive(JSON.stringify({ cells, fills: fills.map(({ block, vertices }) => ({ block, vertices: [...vertices] })) }))
/** What only left memory looks different here alone: it is told when it comes back. */
function tell() {
  for (const { cells, fills } of ground.draw()) if (ground.world.firstUnloaded(cells) === null) say(cells, fills)
}
/** Another time: what was told before is void, and what is not in memory now will be told when it comes. */
function load(saved) {
  ground.load(saved)
  say({ i0: -(2 ** 30), j0: -(2 ** 30), i1: 2 ** 30, j1: 2 ** 30 }, [])
}

let state = seed, saved = null
const random = (n) => Math.floor(((state = (Math.imul(state, 1103515245) + 12345) >>> 0) / 2 ** 32) * n)
const times = []
for (let frame = 0; frame < frames; ++frame) {
  const x = Math.floor(160 * Math.abs((Math.floor(frame / 20) % 64) - 32) / 32), begin = performance.now()
  ground.window(around(x))
  if (frame % 6 === 0) ground.dig(x + random(40) - 20, 2 + random(26), 1 + random(4) / 2)
  if (frame % 90 === 45) ground.paint(x + random(20) - 10, 32, 2, earth)
  if (frame % 40 >= 36) frame % 40 < 38 ? ground.undo() : ground.redo()
  if (frame % 1000 === 700) saved = ground.save()
  if (frame % 1000 === 999) load(saved)
  ground.step(1 / 60)
  const isSaving = frame % 1000 === 700 || frame % 1000 === 999
  if (!isSaving) times.push(performance.now() - begin)
  tell()
}

const { terrain } = ground
const lost = balls.filter((ball) => {
  const { x, y } = terrain.point(ball.getPosition())
  return !terrain.disabled.includes(ball) && (ground.world.at(x, y).where === 'inside' || y < 0)
}).length
ground.window({ i0: -128, j0: -64, i1: 288, j1: 95 })
tell()
const all = (world) => world.polygons().map(({ i, j, block, vertices }) => `${i} ${j} ${block} ${vertices.join()}`).sort().join('\n')
const isSame = all(ground.world) === all(theirs)
times.sort((a, b) => a - b)
const at = (part) => times[Math.floor(part * (times.length - 1))].toFixed(2)
console.log(`a frame with its physics: p50 ${at(0.5)} ms, p99 ${at(0.99)} ms, worst ${at(1)} ms`)
console.log(`${frames} frames, ${ground.rocks().length} rocks in the air, ${isSame ? 'both worlds are the same' : 'the worlds differ'}, ` +
  `${lost} of ${balls.length} balls lost`)
if (!isSame || lost > 0) process.exitCode = 1
