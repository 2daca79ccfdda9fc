// The attack on everything but the importer, which is in another module of WebAssembly: attack-maps.test.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { init } from '../dist/islands.js'

await init() // before other files load an engine without islands
const { attack, doors, others } = await import('./attack/attack.js')

test('all functions of the package are attacked, but init() and the constructor of errors', (t) => {
  t.diagnostic(`${doors.length} functions`)
  assert.deepEqual(others.filter((row) => !/^JavaScript \| (\w+\/init|LgsError\.constructor)\(/.test(row)), [])
})

attack(doors.filter(({ name }) => !/^(importMap|ImportedMap)\b/.test(name)), init)
