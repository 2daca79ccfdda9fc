// The ways to start: the file beside the module, a URL, bytes, a module, and the package with everything in it.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'

const wasm = fileURLToPath(import.meta.resolve('localgridseg/lgs.wasm'))
/** Runs a module in a Node of its own, since each process starts once. Whatever it prints is an error. */
const run = (text, ...options) =>
  execFileSync(process.execPath, [...options, '--input-type=module', '-e', text],
    { cwd: fileURLToPath(new URL('.', import.meta.url)), encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })
const game = `
  const before = Object.keys(globalThis).length
  const world = createWorld()
  world.add(0, 0, world.shape(unitSquare), 1)
  if (world.commit().added.length !== 4) throw new Error('no outline')
  world.free()
  if (Object.keys(globalThis).length !== before) throw new Error('a global')`
const imports = `import { init, createWorld, unitSquare, loadWorld, LgsError } from 'localgridseg'; import { readFile } from 'node:fs/promises';`

test('init() finds lgs.wasm, says nothing, and leaves no global', () => {
  assert.equal(run(`${imports} await init(); await init(); ${game}`), '')
})
test('init({ bytes }), init({ module }), init({ url })', () => {
  const file = JSON.stringify(wasm)
  assert.equal(run(`${imports} await init({ bytes: await readFile(${file}) }); ${game}`), '')
  assert.equal(run(`${imports} await init({ module: await WebAssembly.compile(await readFile(${file})) }); ${game}`), '')
  assert.equal(run(`${imports} import { pathToFileURL } from 'node:url'; await init({ url: pathToFileURL(${file}) }); ${game}`), '')
})
test('init({ url }) by HTTP, whatever type the server says', async () => {
  const server = createServer((request, response) => {
    if (request.url === '/lgs.wasm') response.setHeader('content-type', 'text/plain').end(readFileSync(wasm))
    else if (request.url === '/page') response.setHeader('content-type', 'text/html').end('<!doctype html>')
    else response.writeHead(404).end()
  }).listen(0)
  await new Promise((done) => server.once('listening', done))
  const base = `http://localhost:${server.address().port}`
  const { init, createWorld } = await import('localgridseg')
  await assert.rejects(init({ url: `${base}/nothing` }), ({ code, message }) => {
    assert.equal(code, 'not-ready')
    return /nothing: 404 Not Found.*optimizeDeps.*init\(\{ url \}\).*localgridseg\/inline/.test(message)
  })
  await assert.rejects(init({ url: `${base}/page` }), /page: it is no code of WebAssembly.*optimizeDeps/)
  await assert.rejects(init({ uri: base }), /options has no 'uri', but url, bytes, module/)
  await init({ url: `${base}/lgs.wasm` })
  createWorld().free()
  server.close()
})
test('inline: nothing to find', () => {
  assert.equal(run(`import { init, createWorld, unitSquare } from 'localgridseg/inline'; await init(); ${game}`), '')
  assert.equal(run(`import { init, createWorld, unitSquare, Islands } from 'localgridseg/inline-islands'; import { Pieces } from 'localgridseg/pieces'
    await init(); ${game}
    const other = createWorld()
    other.add(0, 0, other.shape(unitSquare), 1)
    other.commit()
    if (new Islands(other).all().length !== 1 || new Pieces(other).solidPieces(0, 0).length !== 1) throw new Error('no islands')`), '')
})
test('small: the code that is compiled for size', () => {
  assert.equal(run(`import { init, createWorld, unitSquare } from 'localgridseg/small'; await init(); ${game}`), '')
})
test('a console shows names, and what lists hold', () => {
  const text = run(`${imports} await init()
    const world = createWorld(), square = world.shape(unitSquare)
    world.add(0, 0, square, 1)
    const changes = world.commit()
    console.log(changes, world)
    world.commit()
    console.log(changes, changes.added)
    world.free()
    console.log(world)`)
  assert.match(text, /^Changes \{\s+removed: Uint32Array\(0\) \[\],\s+added: SegmentList \{\s+length: 4,\s+id: Uint32Array\(4\) \[ 1, 2, 3, 4 \]/)
  assert.match(text, /World \{\s+polygons: 1,/)
  assert.match(text, /Changes \{ stale: true, before: 0, after: 1 \} SegmentList \{ stale: true \}\s+World \{ freed: true \}/)
})
test('without init() a call says what to do', () => {
  assert.equal(run(`${imports} try { createWorld(); throw 1 } catch (e) { if (e.code !== 'not-ready') throw e }`), '')
})
test('when memory runs out, every world says so, and init() starts the engine again', () => {
  assert.equal(run(`${imports}
    // The same module with at most 4 MiB: section 5 of the binary says how many pages of 64 KiB there are.
    const whole = await readFile(${JSON.stringify(wasm)})
    let at = 8  // behind the magic word and the version: sections, each with its number and its length
    const number = () => { let n = 0, k = 0; do n += (whole[at] & 127) * 2 ** (7 * k++); while (whole[at++] > 127); return n }
    while (whole[at] !== 5) { at++; const length = number(); at += length }
    if (!whole.subarray(at + 1, at + 4).equals(Buffer.from([3, 1, 0])))  // length, one memory, no maximum
      throw new Error('no memory section as it was expected')
    const small = Buffer.concat([whole.subarray(0, at), Buffer.from([5, 4, 1, 1, whole[at + 4], 64]), whole.subarray(at + 5)])
    await init({ bytes: small })
    const code = (f) => { try { f(); return 'fine' } catch (e) { return e instanceof LgsError ? e.code : String(e) } }
    const first = createWorld(), other = createWorld()
    const shape = first.shape([0, 0, 1, 0, 0, 1])
    const full = () => { first.fill({ i0: 0, j0: 0, i1: 999, j1: 999 }, shape, 1); first.commit() }
    if (code(full) !== 'out-of-memory') throw new Error(code(full))
    for (const f of [full, () => other.stats(), () => createWorld()])
      if (code(f) !== 'out-of-memory') throw new Error('it goes on: ' + code(f))
    first.free()
    await init()
    if (code(() => other.stats()) !== 'out-of-memory') throw new Error('an old world lives')
    ${game}`), '')
})
test('after a start that failed, init() may be tried again', () => {
  assert.equal(run(`${imports}
    const nothing = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0])
    for (const options of [{ bytes: nothing }, { bytes: new Uint8Array(3) }, { module: 7 }])
      if (await init(options).then(() => 'fine', () => 'refused') !== 'refused') throw new Error('started')
    await init()
    ${game}`), '')
})
test('no instance is made at once: browsers of before 2023 allow that only for 4 kB', () => {
  assert.equal(run(`${imports} WebAssembly.Instance = class { constructor() { throw new RangeError('too large') } }
    await init(); ${game}`), '')
})
test('memory above 2 GiB, where addresses are negative numbers', () => {
  assert.equal(run(`${imports}
    const { instantiate } = WebAssembly
    let memory, address
    WebAssembly.instantiate = async (...all) => {
      const { exports } = await instantiate(...all)
      memory = exports.memory
      return { exports: { ...exports, commit: (world) => (address = exports.commit(world)) } }
    }
    await init()
    const world = createWorld()
    memory.grow(2 ** 15)  // the allocator has begun, and goes on behind what it does not know
    const triangle = world.shape([0.25, 0.25, 0.75, 0.25, 0.5, 0.75])
    world.fill({ i0: 0, j0: 0, i1: 299, j1: 99 }, triangle, 1)
    const { added } = world.commit()
    if (address >= 0) throw new Error('the memory is not so full')
    try { world.shape(new Float64Array(3e5)); throw 1 } catch (e) { if (e.code !== 'capacity') throw e }
    try { world.add(0, 0, triangle, 1); throw 1 } catch (e) { if (e.code !== 'overlap') throw e }
    const [x, y] = added.geometry.subarray(8 * 89_999)
    const { start } = world.segment(added.id[89_999])
    if (x !== start[0] || y !== start[1]) throw new Error('other geometry')
    if (world.polygons().length !== 30_000 || world.loops().length !== 30_000) throw new Error('wrong')
    if (loadWorld(world.save()).stats().segments !== 90_000) throw new Error('wrong')`), '')
})
test('memory grows in great steps, as each of them takes a millisecond', () => {
  assert.equal(run(`${imports}
    const { instantiate } = WebAssembly
    let memory
    WebAssembly.instantiate = async (...all) => {
      const { exports } = await instantiate(...all)
      memory = exports.memory
      return { exports }
    }
    await init()
    const lengths = new Set(), worlds = []
    for (let k = 0; k < 4000; ++k) {
      worlds.push(createWorld())
      lengths.add(memory.buffer.byteLength)
    }
    if (memory.buffer.byteLength < 2e7) throw new Error('the worlds are too small for this test')
    if (lengths.size > 60) throw new Error(lengths.size + ' steps')`), '')
})
test('the names are there when a server renders, without a window, and nothing starts by itself', () => {
  assert.equal(run(`import * as all from 'localgridseg'; import * as draw from 'localgridseg/draw'; import * as trace from 'localgridseg/trace'; if (typeof window !== 'undefined') throw 1`), '')
})
