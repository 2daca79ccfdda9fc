// The same as `localgridseg`, and islands: pieces of ground that hang together. What is cut off falls.
//
//   import { init, createWorld, Islands } from 'localgridseg/islands'
//   await init()
//   const world = createWorld()
//   …                                                        // the ground
//   world.commit()
//   const islands = new Islands(world, { blocks: [bedrock] })
//   …
//   islands.update(world.commit())                           // after each commit and roll-back
//   for (const id of islands.loose()) fall(islands.take(id))
import { start } from './engine.js'
import { compile } from './load.js'
import type { InitOptions } from './types.js'

export * from './islands-api.js'

/** Loads the engine with islands, unless an engine runs already. */
export const init = (options: InitOptions = {}): Promise<void> =>
  start(() => compile(options, () => new URL('./lgs-islands.wasm', import.meta.url)))
