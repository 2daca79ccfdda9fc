// What `localgridseg` and `localgridseg/inline` have in common: all but init().
export { createWorld, loadWorld } from './world.js'
export { GroundHashes } from './hashes.js'
export { circle, rectangle, thickLine } from './regions.js'
export { LgsError } from './error.js'
export type { ErrorCode, ErrorDetails } from './error.js'
export type * from './types.js'

/** The whole cell as a polygon, for World.shape(). */
export const unitSquare: readonly (readonly [number, number])[] = [[0, 0], [1, 0], [1, 1], [0, 1]]
