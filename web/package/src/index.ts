// LocalGridSeg: the outline of an editable grid of polygons, with ghost vertices, kept up to date edit by edit.
//
//   import { init, createWorld, unitSquare } from 'localgridseg'
//   await init()
//   const world = createWorld()
//   const square = world.shape(unitSquare)            // validated once
//   const floor = world.add(3, 4, square, 7)          // 7 is a number of yours
//   const { removed, added, relinked } = world.commit()
//   world.free()
import { start } from './engine.js'
import { compile } from './load.js'
import type { InitOptions } from './types.js'

export * from './api.js'

/** Loads the engine. Call it once before anything else; a further call waits for the first one. */
export const init = (options: InitOptions = {}): Promise<void> =>
  start(() => compile(options, () => new URL('./lgs.wasm', import.meta.url)))
