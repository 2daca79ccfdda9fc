// Properties of random worlds: the outline against polygon-clipping, which unites all polygons anew; a mirror that knows
// nothing but the changes; strokes of brushes against the native command. LGS_TEST_SEED and LGS_TEST_RUNS choose others.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { before, test } from 'node:test'
import fc from 'fast-check'
import polygonClipping from 'polygon-clipping'
import { LgsError, createWorld, init } from 'localgridseg'
import { TracePlayer, dump, parseTrace } from 'localgridseg/trace'
import { lgs, skip } from './lgs.js'

before(() => init())
const settings = (runs) => ({
  numRuns: Number(process.env.LGS_TEST_RUNS ?? runs),
  ...(process.env.LGS_TEST_SEED ? { seed: Number(process.env.LGS_TEST_SEED) } : {}),
})

// Tiles on quarters of a cell meet in all kinds of ways. Coordinates are exact in polygon-clipping, too.
const tiles = [
  [0, 0, 1, 0, 1, 1, 0, 1], [0, 0, 1, 0, 1, 1], [0, 0, 1, 0, 0, 1], [1, 1, 0, 1, 0, 0], [1, 1, 0, 1, 1, 0],
  [0, 0, 1, 0, 1, 0.5, 0, 0.5], [0, 0.5, 1, 0.5, 1, 1, 0, 1], [0.25, 0, 0.75, 0, 0.75, 1, 0.25, 1],
  [0, 0, 1, 0, 1, 0.25, 0, 0.75], [0.5, 0, 1, 0.5, 0.5, 1, 0, 0.5],
]
const cell = fc.integer({ min: 0, max: 4 })
const edit = fc.record({ i: cell, j: cell, tile: fc.nat(tiles.length - 1), block: fc.integer({ min: 1, max: 3 }), clears: fc.boolean() })
const edits = fc.array(fc.array(edit, { minLength: 1, maxLength: 6 }), { minLength: 1, maxLength: 12 })

/** Makes the edits, and calls `committed` after each commit. */
function play(steps, committed) {
  const world = createWorld()
  const shapes = tiles.map((tile) => world.shape(tile))
  for (const step of steps) {
    for (const { i, j, tile, block, clears } of step) {
      if (clears) world.clear(i, j)
      try {
        world.add(i, j, shapes[tile], block)
      } catch (error) {
        if (!(error instanceof LgsError) || error.code !== 'overlap') throw error
      }
    }
    committed(world, world.commit())
  }
  world.free()
}

/** Twice the area that edges enclose. */
const area2 = (edges) => edges.reduce((sum, [x0, y0, x1, y1]) => sum + x0 * y1 - x1 * y0, 0)

const rows = (list) => Array.from({ length: list.length }, (_, k) => Array.from(list.geometry.subarray(8 * k, 8 * k + 8)))

test('the outline has the area of the union that polygon-clipping makes, and so does each of its loops', () => {
  fc.assert(fc.property(edits, (steps) => {
    play(steps, (world) => {
      const polygons = world.polygons().map(({ i, j, vertices }) => {
        const ring = []
        for (let k = 0; k < vertices.length; k += 2) ring.push([i + vertices[k], j + vertices[k + 1]])
        return [ring]
      })
      const united = polygons.length > 0 ? polygonClipping.union(...polygons) : []
      const theirs = area2(united.flat().flatMap((ring) => ring.slice(1).map((p, k) => [...ring[k], ...p])))
      assert.equal(area2(rows(world.segments())), theirs)
      const loops = world.loops({ merge: true }).map(({ vertices: v }) =>
        area2(Array.from({ length: v.length / 2 }, (_, k) => [v[2 * k], v[2 * k + 1], v[(2 * k + 2) % v.length], v[(2 * k + 3) % v.length]])))
      assert.equal(loops.reduce((sum, a) => sum + a, 0), theirs)
    })
  }), settings(60))
})

test('links are closed: each successor begins where its segment ends, and its ghosts say so', () => {
  fc.assert(fc.property(edits, (steps) => {
    play(steps, (world) => {
      const list = world.segments()
      const at = new Map(Array.from(list.id, (id, k) => [id, k]))
      const g = rows(list)
      for (let k = 0; k < list.length; ++k) {
        const next = at.get(list.successor[k]), previous = at.get(list.predecessor[k])
        assert.equal(list.predecessor[next], list.id[k])
        assert.equal(list.successor[previous], list.id[k])
        assert.deepEqual(g[next].slice(0, 4), [...g[k].slice(2, 4), ...g[k].slice(6, 8)])
        assert.deepEqual(g[previous].slice(0, 4), [...g[k].slice(4, 6), ...g[k].slice(0, 2)])
      }
    })
  }), settings(60))
})

test('a mirror that knows nothing but the changes has the outline', () => {
  fc.assert(fc.property(edits, (steps) => {
    const mirror = new Map()
    play(steps, (world, { removed, added, relinked }) => {
      const take = (list, kind) => {
        const g = rows(list)
        for (let k = 0; k < list.length; ++k) {
          assert.equal(mirror.has(list.id[k]), kind === 'relinked')
          if (kind === 'relinked') assert.notDeepEqual(mirror.get(list.id[k]).g.slice(4), g[k].slice(4))
          mirror.set(list.id[k], { g: g[k], block: list.block[k], owner: list.owner[k], cell: [list.cell[2 * k], list.cell[2 * k + 1]] })
        }
      }
      for (const id of removed) assert.ok(mirror.delete(id))
      take(added, 'added')
      take(relinked, 'relinked')
      const list = world.segments()
      assert.equal(list.length, mirror.size)
      rows(list).forEach((g, k) => assert.deepEqual(mirror.get(list.id[k]), {
        g, block: list.block[k], owner: list.owner[k], cell: [list.cell[2 * k], list.cell[2 * k + 1]],
      }))
      for (const [id, { owner, block }] of mirror) assert.deepEqual([world.hit(id).polygon, world.hit(id).block], [owner, block])
    })
  }), settings(60))
})

test('strokes of brushes: the outline is that of the native command, and CGAL finds nothing wrong', { skip }, () => {
  const number = fc.integer({ min: -64, max: 64 * 5 }).map((n) => n / 64 + 1 / 1024)
  const ring = fc.array(fc.tuple(number, number), { minLength: 3, maxLength: 7 })
  const stroke = fc.record({ kind: fc.constantFrom('carve', 'paint 1 fill', 'paint 2 replace'), rings: fc.array(ring, { minLength: 1, maxLength: 2 }) })
  const folder = mkdtempSync(join(tmpdir(), 'lgs-web-'))
  try {
    fc.assert(fc.property(fc.array(stroke, { minLength: 1, maxLength: 8 }), (strokes) => {
      const lines = strokes.flatMap(({ kind, rings }) =>
        [`${kind} ${rings.map((r) => r.map((p) => p.join(' ')).join(', ')).join(' | ')}`, 'commit'])
      const text = ['lgs-trace 2', 'add a 0 0 1 0 0 1 0 1 1 0 1', 'add b 1 0 2 0 0 1 0 0 1', ...lines, ''].join('\n')
      const trace = join(folder, 'strokes.trace'), out = join(folder, 'strokes.dump')
      writeFileSync(trace, text)
      execFileSync(lgs, ['replay', trace, '--check', '--dump', out])
      const world = createWorld()
      const player = new TracePlayer(world)
      for (const edit of parseTrace(text).edits) player.apply(edit)
      world.commit()
      assert.equal(dump(world), readFileSync(out, 'utf8'))
      world.free()
    }), settings(12))
  } finally {
    rmSync(folder, { recursive: true })
  }
})
