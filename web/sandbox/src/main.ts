// The page. Who comes first gets the digger alone, and with it the first frame early; all tools are made when they are
// wanted.
import { init } from 'localgridseg/islands'
import { Digger } from './digger.js'
import { keptGround, wasWelcomed } from './keep.js'
import { RaceStage } from './race/stage.js'
import type { Sandbox } from './sandbox.js'

await init()
// Who knows the page, or was sent to something on it, has all tools at once.
const isNew = location.hash === '' && keptGround() === null && !wasWelcomed()
const digger = isNew || location.hash === Digger.address ? new Digger() : null
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
