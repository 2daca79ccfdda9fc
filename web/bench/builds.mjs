// Builds of the engine beside each other in one process, round by round: edits of tiles with commit and every list read,
// and strokes of radius 3 with a commit each, beside clipper2-wasm's difference of the touched cells. Ratios are of the
// first build, medians of the rounds'.
//
//   node builds.mjs FILE.wasm FILE.wasm …       (the package must be built; without files, those for speed and for size)
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, dirname, join } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { gzipSync } from 'node:zlib'
import { init } from 'localgridseg'
import { clipperStrokes, hole, holes } from './holes.mjs'
import { Package, timed } from './package-subject.mjs'
import { randomNumbers, side } from './scenario.mjs'

const rounds = 15, dist = fileURLToPath(new URL('../package/dist', import.meta.url))
const files = process.argv.length > 2 ? process.argv.slice(2) : ['lgs-small.wasm', 'lgs.wasm'].map((name) => join(dist, name))
const folder = mkdtempSync(join(tmpdir(), 'lgs-builds-'))

/** The package once more, with an engine of its own. */
async function load(file, k) {
  cpSync(dist, join(folder, String(k)), { recursive: true })
  const { init, createWorld, circle, unitSquare } = await import(pathToFileURL(join(folder, String(k), 'index.js')))
  const bytes = readFileSync(file)
  await init({ bytes })
  const world = createWorld()
  world.fill({ i0: 0, j0: 0, i1: side - 1, j1: side - 1 }, world.shape(unitSquare), 7)
  world.commit()
  const strokes = () => {
    const mark = world.mark(), random = randomNumbers()
    const time = timed(() => {
      for (const [x, y] of hole(random)) {
        world.carve(circle(x, y, 3, 32))
        world.commit()
      }
    })
    world.rollBack(mark)
    world.forget(mark)
    return time / holes
  }
  const tasks = { 'stroke of radius 3': strokes }
  for (const kind of ['full', 'ramps']) {
    const subject = new Package(createWorld, kind)
    subject.digHoles()
    tasks[`tile, ${kind}`] = () => subject.edits(10_000)
  }
  return { name: join(basename(dirname(file)), basename(file)), bytes, tasks }
}

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]
const builds = []
try {
  for (const file of files) builds.push(await load(file, builds.length))
} finally {
  rmSync(folder, { recursive: true })
}
for (const { name, bytes } of builds) console.log(`${name}: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} with gzip`)
await init()  // for the circles of the neighbour
const neighbour = { name: 'clipper2-wasm', tasks: { 'stroke of radius 3': await clipperStrokes() } }
for (const task of Object.keys(builds[0].tasks)) {
  const subjects = [...builds, neighbour].filter(({ tasks }) => tasks[task])
  const times = subjects.map(() => [])
  for (let round = -5; round < rounds; ++round)  // the first ones warm up
    subjects.forEach(({ tasks }, k) => {
      const time = tasks[task]()
      if (round >= 0) times[k].push(time)
    })
  const shown = times.map((all, k) => `${subjects[k].name} ${(median(all) / 1e3).toPrecision(3)} µs (${median(all.map((t, n) => t / times[0][n])).toFixed(2)})`)
  console.log(`${task}: ${shown.join(', ')}`)
}
