// The same as `localgridseg`, and the importer of maps:
//
//   import { init, createWorld, importMap } from 'localgridseg/full'
//   await init()
//   const map = importMap('level.tmx', { 'level.tmx': text, 'tiles.tsx': other }, { block: 'class' })
//   const world = createWorld()
//   map.place(world)
//   world.commit()
import { start } from './engine.js'
import { compile } from './load.js'
import type { InitOptions } from './types.js'

export * from './api.js'
export { importMap } from './maps.js'

/** Loads the engine with the importer, unless an engine runs already. */
export const init = (options: InitOptions = {}): Promise<void> =>
  start(() => compile(options, () => new URL('./lgs-full.wasm', import.meta.url)))
