// The attack on everything but the importer, which is in another module of WebAssembly: attack-maps.test.js.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { init as initEngine } from 'localgridseg/islands'
import { init as initOracle } from 'localgridseg/oracle'

const init = async () => {
  await initEngine()
  await initOracle()
}
await init() // before other files load an engine without islands
const { attack, doors } = await import('./attack/attack.js')

test('the functions of the package are found', (t) => {
  t.diagnostic(`${doors.length} functions`)
  assert.ok(doors.length > 150)
})

attack(doors.filter(({ name }) => !/^(importMap|ImportedMap)\b/.test(name)), init)
