// The engine with a planted bug. The package has one engine for a page, so this one is in a worker.
import { createWorld, init } from 'localgridseg'
import { outlineOf, type Placed } from './subject.js'

const url = new URL('planted.wasm', import.meta.url)

addEventListener('message', async ({ data }: MessageEvent<readonly Placed[]>) => {
  await init({ url }) // again, after the bug has stopped it
  postMessage(outline(data))
})

/** Empty if the bug stops the engine: that is a difference, too. */
function outline(placed: readonly Placed[]): Float64Array {
  try {
    const world = createWorld()
    const numbers = outlineOf(world, placed)
    world.free()
    return numbers
  } catch {
    return new Float64Array()
  }
}
