// The same as `localgridseg/islands`, with the code of WebAssembly in it: nothing to fetch. `Pieces` of
// `localgridseg/pieces` run with it, too.
import { start } from './engine.js'
import { wasm } from './wasm-islands.js'

export * from './islands-api.js'

/** Loads the engine with islands, unless an engine runs already. */
export const init = (): Promise<void> =>
  start(() => WebAssembly.compile(Uint8Array.from(atob(wasm), (c) => c.charCodeAt(0))))
