// The page: the digger, or all tools where the address says so. All tools are made when they are wanted, and so the
// digger's first frame is early.
import { init } from 'localgridseg/islands'
import { Digger } from './digger.js'
import { RaceStage } from './race/stage.js'
import type { Sandbox } from './sandbox.js'

const isOfDigger = () => ['', '#digger', '#race'].includes(location.hash) // index.html says the same
await init()
const digger = isOfDigger() ? new Digger() : null
let sandbox: Sandbox | null = null
async function openSandbox(): Promise<void> {
  sandbox = await (await import('./sandbox.js')).openSandbox()
  Object.assign(window, { sandbox: { ...sandbox.handles, race, digger } })
}
/** From the digger; keys go to the ground then. */
async function goOn(): Promise<void> {
  await digger!.leave()
  await openSandbox()
  document.querySelector<HTMLElement>('#pane-0 canvas')!.focus({ preventScroll: true })
}
const race = new RaceStage(() => sandbox?.pause(), () => sandbox?.goOn())
Object.assign(window, { sandbox: { race, digger } }) // for tests and for the curious
addEventListener('hashchange', () => {
  if (isOfDigger()) sandbox !== null && location.hash !== '#race' && location.reload() // it is what was kept
  else if (sandbox === null) void goOn()
})
if (digger === null) await openSandbox()
else await digger.open()
document.body.dataset.ready = 'true'
