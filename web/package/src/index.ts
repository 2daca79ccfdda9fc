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
import type { InitOptions } from './types.js'

export * from './api.js'

async function compile({ url, bytes, module }: InitOptions): Promise<WebAssembly.Module> {
  if (module) return module
  if (bytes) return WebAssembly.compile(bytes)
  const from = url === undefined ? new URL('./lgs.wasm', import.meta.url) : url
  if (String(from).startsWith('file:')) {  // Node, whose fetch() takes no files
    const files = 'node:fs/promises'
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files)
    return WebAssembly.compile(await readFile(new URL(from)))
  }
  const response = await fetch(from)
  if (!response.ok) throw new Error(`${response.url || from}: ${response.status} ${response.statusText}`)
  return WebAssembly.compile(await response.arrayBuffer())  // whatever type the server says that it has
}

/** Loads the engine. Call it once before anything else; a further call waits for the first one. */
export const init = (options: InitOptions = {}): Promise<void> => start(() => compile(options))
