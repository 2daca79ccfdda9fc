// The attack on the importer, and on worlds that are made of maps.
import { init } from 'localgridseg/full'

await init()
const { attack, doors } = await import('./attack/attack.js')

attack(doors.filter(({ name }) => /^(importMap|ImportedMap|createWorld|loadWorld|World\.(add|commit|shape))\b/.test(name)), init)
