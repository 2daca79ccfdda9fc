// What of the engine is for islands and pieces. web/wasm/islands.cpp and pieces.cpp are the other side.
import type { Engine } from './engine.js'
import { LgsError } from './error.js'

/** Addresses are numbers. Only lgs-islands.wasm has these. */
export interface IslandCalls {
  islands(world: number, numbers: number, isOpen: number): number
  freeIslands(islands: number): void
  updateIslands(islands: number, world: number): number
  areIslandsOfNow(islands: number, world: number): number
  islandChanges(islands: number, list: number): number
  looseIslands(islands: number): number
  allIslands(islands: number): number
  island(islands: number, id: number): number
  islandOf(islands: number, world: number, polygon: number): number
  takeIsland(islands: number, world: number, id: number, isApart: number): number
  tryEdits(islands: number, world: number): number
  untryEdits(islands: number, world: number, mark: number): number
  putBody(world: number, numbers: number, i: number, j: number): number
  putAsItLies(world: number, numbers: number, x: number, y: number, cosine: number, sine: number): number
  unloadedChunks(world: number): number
  saveGround(world: number, numbers: number, bytes: number): number
  loadGround(bytes: number, relation: number, isFloat: number, i0: number, j0: number, i1: number, j1: number): number
  convexParts(numbers: number, maxVertices: number): number
  massOf(numbers: number): number
  pieces(world: number, maxVertices: number): number
  dropPieces(pieces: number): void
  updatePieces(pieces: number, world: number): number
  arePiecesOfNow(pieces: number, world: number): number
  changedPieces(pieces: number): number
  solidPieces(pieces: number, world: number, i: number, j: number): number
  freePieces(pieces: number, i: number, j: number): number
  portals(pieces: number, i: number, j: number, index: number): number
  freePieceAt(pieces: number, x: number, y: number): number
  wholeCells(pieces: number, i0: number, j0: number, i1: number, j1: number, isFree: number): number
}

export function islandCalls({ call }: Engine): IslandCalls {
  if (!call.islands)
    throw new LgsError('not-ready', "the engine runs without islands and pieces: await init() of 'localgridseg/islands' before any other")
  return call as IslandCalls
}
