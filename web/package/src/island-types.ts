// What islands and bodies are. Lengths and positions are in cells, y up.
import type { Block, CellRect, Id } from './types.js'

/** An island: small, good as an index. 0 names none. After a roll-back the same island may have another id. */
export type IslandId = Id<'island'>

/** What holds an island: polygons of these blocks, wherever they are, and all polygons in these cells. */
export interface Anchors {
  readonly blocks?: readonly Block[]
  readonly cells?: readonly CellRect[]
}

/** What is at the edge of memory: with 'holds' ground of which nothing more is known, so what reaches it is of the island
 *  `beyond`; with 'open' nothing, so an island ends there, and only anchors in memory hold it. */
export type AtEdge = 'holds' | 'open'

/** What is known of an island. */
export interface Island {
  readonly id: IslandId
  /** With its holes. */
  readonly area: number
  /** Its box. */
  readonly x0: number
  readonly y0: number
  readonly x1: number
  readonly y1: number
  /** Of its outer loop. */
  readonly segments: number
  /** How many of its polygons are anchors. 0: nothing holds it. */
  readonly anchors: number
}

/** An island of before, and one of now. */
export interface IslandPair {
  readonly from: IslandId
  readonly into: IslandId
}

/**
 * What an update did: it compares the moment before with the moment after. Islands correspond if the solid of both moments
 * together connects them. Of those that correspond the largest of now has the id of the largest of before.
 */
export interface IslandChanges {
  /** New ids, of islands to which none before corresponds. */
  readonly added: readonly IslandId[]
  /** Ids that are no more, of islands to which none of now corresponds. */
  readonly removed: readonly IslandId[]
  /** Ids that stay, of islands with another outer loop or other anchors. */
  readonly changed: readonly IslandId[]
  /** `into` is new. `from` is the largest that corresponds: that may be the one that nothing holds. */
  readonly cutOff: readonly IslandPair[]
  /** `from` is no more. */
  readonly joined: readonly IslandPair[]
}

/** What an edit would do. */
export interface Foreseen {
  /** With the ids that there would be. */
  readonly changes: IslandChanges
  /** The islands that `changes` names and that there would be then. */
  readonly after: readonly Island[]
}

export interface GroundPolygon {
  /** Its cell, from that of the body's origin. */
  readonly i: number
  readonly j: number
  readonly block: Block
  /** x, y, x, y, … from the lower left corner of the cell: 0 to 1. */
  readonly vertices: ArrayLike<number>
}

/** What polygons weigh where each square cell weighs one: sums that are exact, rounded once. */
export interface Mass {
  readonly area: number
  /** The centroid, from the lower left corner of the origin's cell. */
  readonly x: number
  readonly y: number
  /** Of area, about the centroid: times density it is inertia. */
  readonly secondMoment: number
}

/** Ground that has left its world. It is data: it can be posted, copied and kept. */
export interface GroundBody {
  /** The cell where its origin was: the lower left one of its box. */
  readonly i: number
  readonly j: number
  readonly polygons: readonly GroundPolygon[]
  readonly mass: Mass
}

export interface ConvexPart {
  readonly block: Block
  /** x, y, x, y, …, counter-clockwise, from the body's origin. */
  readonly vertices: Float64Array
}
