// What `localgridseg/islands` and `localgridseg/inline-islands` have in common: all but init().
export * from './api.js'
export { convexParts, massOf } from './ground-body.js'
export { Ground } from './ground.js'
export { beyond, Islands } from './island-view.js'
export type { GroundDrawing, GroundOptions, Motion, Rock, Shelf } from './ground-types.js'
export type * from './island-types.js'
