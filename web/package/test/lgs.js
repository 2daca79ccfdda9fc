// The native command: what LGS_COMMAND says, or what was built last.
import { existsSync } from 'node:fs'
import { fileURLToPath } from 'node:url'

const built = (preset) => fileURLToPath(new URL(`../../../build/${preset}/cli/lgs`, import.meta.url))

/** Its path; undefined if there is none. */
export const lgs = process.env.LGS_COMMAND ?? ['release', 'asan'].map(built).find(existsSync)
export const skip = lgs ? false : 'the command lgs is not built (cmake --build --preset release --target lgs_cli lgs-import)'
