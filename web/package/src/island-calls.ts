// What of the engine is for islands. web/wasm/islands.cpp is the other side.
import type { Engine } from './engine.js'
import { LgsError } from './error.js'

/** Addresses are numbers. Only lgs-islands.wasm has these. */
export interface IslandCalls {
  islands(world: number, numbers: number): number
  freeIslands(islands: number): void
  updateIslands(islands: number, world: number): number
  areIslandsOfNow(islands: number, world: number): number
  islandChanges(islands: number, list: number): number
  looseIslands(islands: number): number
  allIslands(islands: number): number
  island(islands: number, id: number): number
  islandOf(islands: number, world: number, polygon: number): number
  takeIsland(islands: number, world: number, id: number): number
  putBody(world: number, numbers: number, i: number, j: number): number
  putAsItLies(world: number, numbers: number, x: number, y: number, cosine: number, sine: number): number
  convexParts(numbers: number, maxVertices: number): number
  massOf(numbers: number): number
}

export function islandCalls({ call }: Engine): IslandCalls {
  if (!call.islands)
    throw new LgsError('not-ready', "the engine runs without islands: await init() of 'localgridseg/islands' before any other")
  return call as IslandCalls
}
