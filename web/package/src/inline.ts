// The same as `localgridseg`, with the code of WebAssembly in it: one file, nothing to fetch.
import { start } from './engine.js'
import { wasm } from './wasm.js'

export * from './api.js'

/** Loads the engine. Call it once before anything else; a further call waits for the first one. */
export const init = (): Promise<void> =>
  start(() => WebAssembly.compile(Uint8Array.from(atob(wasm), (c) => c.charCodeAt(0))))
