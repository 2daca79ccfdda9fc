// The engine with a planted bug. The package has one engine for a page, so this one is in a worker.
import { createWorld, init } from 'localgridseg'
import type { Placed } from './subject.js'
import { outlineOf } from './subject.js'

const url = new URL('planted.wasm', import.meta.url)

addEventListener('message', async ({ data }: MessageEvent<readonly Placed[]>) => {
  await init({ url })
  const world = createWorld()
  const numbers = outlineOf(world, data)
  world.free()
  postMessage(numbers, { transfer: [numbers.buffer] })
})
