// The page. Who comes first gets the digger alone, and with it the first frame early; all tools are made when they are
// wanted.
import { init } from 'localgridseg/islands'
import { Digger } from './digger.js'
import { RaceStage } from './race/stage.js'
import type { Sandbox } from './sandbox.js'

await init()
const isFirst = document.documentElement.classList.contains('first') // index.html decides it
const isNew = isFirst && location.hash === ''
const digger = isFirst ? new Digger() : null
let sandbox: Sandbox | null = null
async function openSandbox(): Promise<void> {
  sandbox = await (await import('./sandbox.js')).openSandbox(isNew)
  Object.assign(window, { sandbox: { ...sandbox.handles, race, digger } })
}
const race = new RaceStage(() => sandbox?.pause(), () => sandbox?.goOn())
Object.assign(window, { sandbox: { race, digger } }) // for tests and for the curious
if (digger === null) await openSandbox()
else await digger.open(openSandbox)
document.body.dataset.ready = 'true'
