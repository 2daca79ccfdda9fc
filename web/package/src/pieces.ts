// The same as `localgridseg`, and convex pieces of what is solid and of what is free: for bodies, and for paths.
//
//   import { init, createWorld, Pieces } from 'localgridseg/pieces'
//   await init()
//   const world = createWorld()
//   …                                                        // the ground
//   world.commit()
//   const pieces = new Pieces(world)
//   …
//   for (const { i, j } of pieces.update(world.commit()))    // after each commit and roll-back: these have others now
//     for (const { vertices, block } of pieces.solidPieces(i, j)) …
export * from './api.js'
export { init } from './islands.js'
export { Pieces } from './piece-view.js'
export type { Piece, PieceId, PiecesOptions, Portal, SolidPiece } from './piece-view.js'
