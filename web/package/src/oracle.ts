// The naive reference of the harness: what the outline of a trace must be, whichever engine made another one.
//
//   import { init, outline } from 'localgridseg/oracle'
//   await init()
//   console.log(outline('lgs-trace 1\nadd a 0 0 1  0 0, 1 0, 0 1\n'))
import { compile } from './load.js'
import { start } from './oracle-api.js'
import type { InitOptions } from './types.js'

export { answer, check, outline, page, type Checked } from './oracle-api.js'

/** Loads the reference. Worlds of the other modules need their own `init()`. */
export const init = (options: InitOptions = {}): Promise<void> =>
  start(() => compile(options, () => new URL('./lgs-oracle.wasm', import.meta.url)))
