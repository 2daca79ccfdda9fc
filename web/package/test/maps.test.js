// The importer in WebAssembly: the same polygons as the native command makes of the project's maps.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { before, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { gzipSync } from 'node:zlib'
import { LgsError, createWorld, importMap, init } from 'localgridseg/full'
import { TracePlayer, dump, parseTrace } from 'localgridseg/trace'
import { lgs, skip } from './lgs.js'

before(() => init())
const folder = fileURLToPath(new URL('../../../examples/maps/', import.meta.url))
const files = Object.fromEntries(
  readdirSync(folder).filter((name) => /\.(tmx|tsx|tx|ldtk)$/.test(name)).map((name) => [name, readFileSync(join(folder, name))]))
const refuses = (code, f, where = {}) => assert.throws(f, (error) => {
  assert.ok(error instanceof LgsError, String(error))
  assert.equal(error.code, code, error.message)
  for (const [name, value] of Object.entries(where)) assert.deepEqual(error[name], value, name)
  return true
})

test("the project's maps: what the native command makes of them", { skip }, () => {
  const out = mkdtempSync(join(tmpdir(), 'lgs-web-'))
  try {
    for (const [name, options, argumentsOfLgs] of [
      ['landscape.tmx', { block: 'class' }, ['--block', 'class']],
      ['landscape.tmx', { tolerance: 0 }, ['--tolerance', '0']],
      ['cave.tmx', {}, []],
      ['quarry.ldtk', {}, []],
    ]) {
      const trace = join(out, 'map.trace'), native = join(out, 'map.dump')
      execFileSync(lgs, ['import', join(folder, name), '-o', trace, ...argumentsOfLgs], { stdio: 'ignore' })
      execFileSync(lgs, ['replay', trace, '--dump', native], { stdio: 'ignore' })
      const map = importMap(name, files, options)
      const world = createWorld()
      const ids = map.place(world)
      world.commit()
      assert.equal(ids.length * 4, map.placements.length)
      assert.ok(ids.length > 20, name)
      assert.equal(dump(world), readFileSync(native, 'utf8'), name)
      const player = new TracePlayer(createWorld())
      for (const edit of parseTrace(readFileSync(trace, 'utf8')).edits) player.apply(edit)
      assert.equal(player.world.stats().polygons, ids.length)
      assert.match(map.report, /polygons/)
      world.free()
    }
  } finally {
    rmSync(out, { recursive: true })
  }
})

/** A map of two by one tiles, its layer in some encoding. */
const tmx = (data) => `<?xml version="1.0"?>
<map version="1.10" orientation="orthogonal" width="2" height="1" tilewidth="16" tileheight="16" infinite="0">
 <tileset firstgid="1" name="ground" tilewidth="16" tileheight="16" tilecount="1" columns="1">
  <tile id="0" type="stone"><objectgroup><object id="1" x="0" y="8" width="16" height="8"/></objectgroup></tile>
 </tileset>
 <layer id="1" name="Ground" width="2" height="1"><data ${data}</data></layer>
</map>`

test('a map of one tile: its cell, block, tile, object and layer; also when it is packed', () => {
  const packed = gzipSync(Buffer.from([1, 0, 0, 0, 0, 0, 0, 0])).toString('base64')
  for (const data of ['encoding="csv">1,0', `encoding="base64" compression="gzip">${packed}`]) {
    const map = importMap('a.tmx', { 'a.tmx': tmx(data) }, { block: 'class', numbers: { stone: 7 } })
    assert.deepEqual(map.shapes, [Float64Array.of(0, 0, 1, 0, 1, 0.5, 0, 0.5)])
    assert.deepEqual(Array.from(map.placements), [0, -1, 0, 7])
    assert.deepEqual(map.tiles[map.tile[0]], { tileset: 'ground', id: 0, class: 'stone' })
    assert.deepEqual([map.object[0], map.layers[map.layer[0]]], [1, 'Ground'])
    assert.deepEqual(map.blocks, { stone: 7 })
  }
})

test('what is wrong with a map is said, with file and line', () => {
  refuses('bad-map', () => importMap('no.tmx', {}))
  refuses('bad-map', () => importMap('a.tmx', { 'a.tmx': tmx('encoding="csv">1') }), { line: 6 })
  refuses('bad-map', () => importMap('a.tmx', { 'a.tmx': '<map' }))
  refuses('bad-map', () => importMap('a.tmx', { 'a.tmx': new Uint8Array(0) }))
  const world = JSON.stringify({ type: 'world', patterns: [{ regexp: '(\\d)_(\\d)' }] })
  assert.throws(() => importMap('a.world', { 'a.world': world }), /can not be read in WebAssembly: list the maps/)
  refuses('bad-argument', () => importMap('a.tmx', {}, { blocks: {} }))
  refuses('bad-argument', () => importMap('a.tmx', {}, { tolerance: '1' }))
  refuses('bad-argument', () => importMap(7, {}))
})

test('files are found by the path that the map names, or by their name alone', () => {
  const whole = readFileSync(join(folder, 'landscape.tmx'))
  const set = readFileSync(join(folder, 'landscape.tsx'))
  const counts = [
    importMap('maps/landscape.tmx', { 'maps/landscape.tmx': whole, 'maps/landscape.tsx': set }),
    importMap('landscape.tmx', { 'landscape.tmx': whole, 'other/landscape.tsx': set }),
  ].map((map) => map.placements.length)
  assert.equal(counts[0], counts[1])
})

/** Tiles with a shape, with a property and with nothing; a hidden layer; a crate, and a one-way polyline. */
const rich = `<?xml version="1.0"?>
<map version="1.10" orientation="orthogonal" width="4" height="1" tilewidth="16" tileheight="16" infinite="0">
 <tileset firstgid="1" name="set" tilewidth="16" tileheight="16" tilecount="3" columns="3">
  <tile id="0" type="stone"><objectgroup><object id="1" x="0" y="0" width="16" height="16"/></objectgroup></tile>
  <tile id="1" type="grass"><properties><property name="hard" type="bool" value="true"/></properties></tile>
 </tileset>
 <layer id="1" name="Near" width="4" height="1"><data encoding="csv">1,2,3,0</data></layer>
 <layer id="2" name="Far" width="4" height="1" visible="0"><data encoding="csv">0,0,0,1</data></layer>
 <objectgroup id="3" name="Boxes">
  <object id="9" name="Big" type="crate" x="0" y="-16" width="16" height="16"/>
  <object id="10" name="one-way" x="16" y="-32"><polyline points="0,0 16,0"/></object>
 </objectgroup>
</map>`

test('every option that chooses, and every one that gives blocks', () => {
  for (const [options, expected] of [
    [{ objects: [] }, '0,-1,1 3,-1,1'],
    [{ objects: [], visible: true }, '0,-1,1'],
    [{ objects: [], layers: ['Near'] }, '0,-1,1'],
    [{ solid: true }, '0,-1,1 1,-1,1 2,-1,1 3,-1,1'],
    [{ solid: true, not: ['stone'] }, '1,-1,1 2,-1,1'],
    [{ solidIf: ['hard'] }, '0,-1,1 1,-1,1 3,-1,1'],
    [{ tiles: 'lgs-tiles 1\n2 full' }, '0,-1,1 2,-1,1 3,-1,1'],
    [{ objects: ['crate'] }, '0,-1,1 3,-1,1 0,0,1'],
    [{ objects: ['Boxes'], polylineThickness: 4 }, '0,-1,1 3,-1,1 0,0,1 1,1,1'],
    [{ objects: ['Boxes'], block: 'class', numbers: { stone: 7, crate: 8 } }, '0,-1,7 3,-1,7 0,0,8'],
    [{ objects: ['Boxes'], block: 'layer', numbers: { Near: 4, Far: 5, Boxes: 6 } }, '0,-1,4 3,-1,5 0,0,6'],
    [{ objects: ['Boxes'], block: 'name', numbers: { stone: 7, Big: 9 } }, '0,-1,7 3,-1,7 0,0,9'],
  ]) {
    const { placements } = importMap('a.tmx', { 'a.tmx': rich }, options)
    const told = Array.from({ length: placements.length / 4 }, (_, k) => [0, 1, 3].map((n) => placements[4 * k + n]).join())
    assert.equal(told.join(' '), expected, JSON.stringify(options))
  }
  refuses('bad-map', () => importMap('a.tmx', { 'a.tmx': rich }, { tiles: '2 full' }), { line: null })
})

test('a map of a world that is not there is left out, and an error with allMaps', () => {
  const files = { 'a.tmx': rich, 'w.world': JSON.stringify({ type: 'world', maps: [
    { fileName: 'a.tmx', x: 0, y: 0 }, { fileName: 'b.tmx', x: 64, y: 0 }] }) }
  assert.match(importMap('w.world', files).report, /left out: .*b\.tmx/)
  assert.throws(() => importMap('w.world', files, { allMaps: true }), /b\.tmx/)
})
