// What a game on the web waits for: physics, drawing, large worlds. It prints the table "The web" of
// docs/internals/performance.md. Nanoseconds are of the processor, medians of rounds; subjects take turns in a round.
//
//   npm run game [ROWS]        (here, after what bench.mjs wants)      ROWS: tiles, worlds, spikes, sizes
import { readFileSync } from 'node:fs'
import Clipper from 'clipper2-wasm/dist/es/clipper2z.js'
import initIShape, { FillRule, Overlay, OverlayRule } from 'ishape_wasm'
import { createWorld, init, unitSquare } from 'localgridseg'
import { OutlineLines } from 'localgridseg/draw'
import { PlanckTerrain } from 'localgridseg/planck'
import { Circle, EdgeShape, World as Physics } from 'planck'
import polygonClipping from 'polygon-clipping'
import { randomNumbers, side } from './scenario.mjs'
import { timed } from './package-subject.mjs'

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]
const units = (ns) => (Math.abs(ns) < 1e3 ? `${Math.round(ns)} ns` : Math.abs(ns) < 1e6 ? `${(ns / 1e3).toPrecision(3)} µs` : `${(ns / 1e6).toPrecision(3)} ms`)
const row = (...cells) => console.log(`| ${cells.join(' | ')} |`)

/** Of each subject, the median of its rounds. A subject is a function that returns nanoseconds. */
async function rounds(count, subjects) {
  const times = subjects.map(() => [])
  for (let round = -2; round < count; ++round)  // the first ones warm up
    for (let k = 0; k < subjects.length; ++k) {
      const time = await subjects[k](round + 2)
      if (round >= 0) times[k].push(time)
    }
  return times.map(median)
}

function fullWorld(cells) {
  const world = createWorld()
  const square = world.shape(unitSquare)
  world.fill({ i0: 0, j0: 0, i1: cells - 1, j1: cells - 1 }, square, 7)
  return { world, square, changes: world.commit() }
}

/**
 * A tile goes and comes, with a step of the physics after each edit, as a game has it: planck keeps a list of what moved,
 * which only a step empties. What planck takes by itself: as many edges made and destroyed, with the same steps; in worlds
 * of many chunks on a body that comes and goes with them, as a hole is mostly in a chunk without edges. Steps are not
 * measured.
 */
async function tiles() {
  for (const cells of [16, 64, 256]) {
    const plain = fullWorld(cells), merged = fullWorld(cells)
    const scene = ({ world, square }, merge) => {
      const physics = new Physics({ x: 0, y: -10 }), terrain = new PlanckTerrain(physics, world, { merge }), lines = new OutlineLines(world)
      const ball = physics.createBody({ type: 'dynamic', position: { x: cells / 2, y: cells + 1 } })
      ball.createFixture(new Circle(0.4), { density: 1 })
      const of = { sync: 0, draw: 0 }, random = randomNumbers()
      of.round = () => {
        of.sync = of.draw = 0
        for (let k = 0; k < times; ++k) {
          const i = 1 + random(cells - 2), j = 1 + random(cells - 2)
          for (const isDug of [true, false]) {
            isDug ? world.clear(i, j) : world.add(i, j, square, 7)
            const changes = world.commit()
            of.sync += timed(() => terrain.sync(changes))
            of.draw += timed(() => lines.update(changes))
            terrain.beforeStep()
            physics.step(1 / 60)
            terrain.afterStep()
          }
        }
        return of.sync / (2 * times)
      }
      return of
    }
    const times = 200, singly = scene(plain, false), together = scene(merged, true)
    const bare = new Physics({ x: 0, y: -10 }), first = bare.createBody(), isInside = cells > 16
    const edge = (body) => body.createFixture(new EdgeShape({ x: 0, y: 0 }, { x: 1, y: 0 }))
    for (let k = 0; k < 64; ++k) edge(first)
    const planck = () => {
      let time = 0
      for (let k = 0; k < times; ++k) {
        let made, body = first
        time += timed(() => {
          if (isInside) body = bare.createBody()
          made = [edge(body), edge(body), edge(body), edge(body)]
        })
        bare.step(1 / 60)
        time += timed(() => {
          for (const fixture of made) body.destroyFixture(fixture)
          if (isInside) bare.destroyBody(body)
        })
        bare.step(1 / 60)
      }
      return time / (2 * times)
    }
    const [inAll, own, mergedTime, drawn] = await rounds(9, [singly.round, planck, together.round, () => singly.draw / (2 * times)])
    row(`a tile and a step, world of ${cells}²: planck's sync`, units(inAll), `planck itself ${units(own)}, beyond it ${units(inAll - own)}; merged ${units(mergedTime)}`)
    row(`a tile, world of ${cells}²: lines drawn anew`, units(drawn), '')
    plain.world.free()
    merged.world.free()
  }
}

async function worlds() {
  const kept = Array.from({ length: 1000 }, () => createWorld())
  const [made] = await rounds(7, [() => {
    const more = []
    const time = timed(() => { for (let k = 0; k < 200; ++k) more.push(createWorld()) }) / 200
    kept.push(...more)  // all are kept: no memory is used again
    return time
  }])
  row('createWorld with 1,000 and more kept', units(made), '')
  for (const world of kept) world.free()
}

/** 10,000 vertices on two circles in turn. */
function spikes(radius, depth) {
  const ring = new Float64Array(20000)
  for (let k = 0; k < 10000; ++k) {
    const r = radius * (k % 2 === 0 ? 1 : 1 - depth), angle = (2 * Math.PI * k) / 10000
    ring.set([50 + r * Math.cos(angle), 50 + r * Math.sin(angle)], 2 * k)
  }
  return { rings: [ring] }
}

async function spiky() {
  const { world } = fullWorld(side)
  for (const [radius, depth] of [[2, 0.02], [10, 0.02], [30, 0.02], [10, 0.2], [10, 0.9]]) {
    let what = ''
    const carved = () => {
      const mark = world.mark(), region = spikes(radius, depth)
      const time = timed(() => {
        try {
          world.carve(region)
          world.commit()
        } catch (error) {
          what = `refused: ${error.code}`
        }
      })
      world.rollBack(mark)
      world.forget(mark)
      return time
    }
    const [time] = await rounds(3, [carved])
    row(`10,000 vertices, spikes of ${100 * depth} % over ${2 * radius}² cells`, units(time), what)
  }
}

/** All squares of a world, united. Each library takes them in its own types, made beforehand. */
async function sizes() {
  const clipper = await Clipper()
  await initIShape({ module_or_path: readFileSync(new URL('node_modules/ishape_wasm/ishape_wasm_bg.wasm', import.meta.url)) })
  for (const cells of [100, 300, 1000]) {
    const rings = []
    for (let j = 0; j < cells; ++j) for (let i = 0; i < cells; ++i) rings.push([[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]])
    const ours = () => {
      const world = createWorld(), square = world.shape(unitSquare), entries = new Int32Array(4 * rings.length)
      rings.forEach(([[i, j]], k) => entries.set([i, j, square, 7], 4 * k))
      const time = timed(() => {
        world.addMany(entries)
        world.commit()
        world.loops({ merge: true })
      })
      world.free()
      return time
    }
    const clipper2 = () => {
      const paths = new clipper.Paths64()
      for (const ring of rings) paths.push_back(clipper.MakePath64(BigInt64Array.from(ring.flat(), BigInt)))
      const time = timed(() => clipper.UnionSelf64(paths, clipper.FillRule.NonZero).delete())
      paths.delete()
      return time
    }
    const ishape = () => {
      const shapes = rings.map((ring) => [ring])
      return timed(() => {
        const overlay = Overlay.new_with_subj_and_clip(shapes, [])
        overlay.overlay(OverlayRule.Subject, FillRule.NonZero)  // it frees itself
      })
    }
    const clipping = () => timed(() => polygonClipping.union(...rings.map((ring) => [ring])))
    const names = ['localgridseg', 'clipper2-wasm', 'ishape_wasm (iOverlay)', ...(cells === 100 ? ['polygon-clipping'] : [])]
    const times = await rounds(cells === 1000 ? 1 : 3, [ours, clipper2, ishape, ...(cells === 100 ? [clipping] : [])])
    row(`${cells}² squares united`, names.map((name, k) => `${name} ${units(times[k])}`).join(', '), '')
  }
}

await init()
const all = { tiles, worlds, spikes: spiky, sizes }
const chosen = process.argv.slice(2)
row('work', 'now', 'beside it')
row('---', '---', '---')
for (const [name, run] of Object.entries(all)) if (chosen.length === 0 || chosen.includes(name)) await run()
