// What a Ground is set up by, and what it hands out. Lengths and positions are in cells, y up.
import type { Anchors, AtEdge, GroundBody } from './island-types.js'
import type { Block, CellRect, Changes, World, WorldOptions } from './types.js'

/**
 * Where chunks of 32×32 cells are that are not in memory, by the column and the row of their lower left cells. A later
 * put() takes the place of an earlier one. Where get() can not answer yet, as it reads a disk, it gives nothing: the chunk
 * stays away, and the next window() tries again.
 */
export interface Shelf {
  put(i: number, j: number, bytes: Uint8Array): void
  get(i: number, j: number): Uint8Array | null | undefined
}

/**
 * What these functions throw comes out of the call that asked them, when that is done all the same: a pair of blocks whose
 * preserve() throws is cancelled; a chunk whose land or bytes do not come is away, and what the shelf does not take is kept,
 * until the next window(). They must not change the ground: that is refused as 'busy'.
 */
export interface GroundOptions {
  /** What holds an island: without it nothing ever falls. */
  readonly anchors?: Anchors
  /** 'holds', if it is not given; with 'open' what no anchor in memory holds falls at the edge of memory. */
  readonly atEdge?: AtEdge
  readonly preserve?: WorldOptions['preserve']
  /**
   * Makes the land of a chunk that was never loaded, when a window comes near it: with edits inside its cells alone,
   * which hold nothing; the same for the same chunk, in whichever world and whenever it is called.
   */
  readonly land?: (land: World, chunk: CellRect) => void
  /** Where chunks outside of the window are: in memory, if none is given. */
  readonly shelf?: Shelf
  /**
   * How many chunks window() makes, brings in and takes out in one call, at least one: all, if it is not given. So a game
   * spreads over several frames what takes most of one. It then calls window() in each frame, and before it begins until
   * that is true.
   */
  readonly chunksAtOnce?: number
  /** How many strokes can be undone: 64, if it is not given. */
  readonly undoSteps?: number
  /** Is notified of each commit, roll-back and redo, for further views. After a load() they begin again. */
  readonly follow?: (world: World, changes: Changes) => void
}

/** How ground that came loose lies and moves. */
export interface Motion {
  /** Where its origin is, the lower left corner of its cells when it was in the ground. */
  x: number
  y: number
  /** Counter-clockwise. */
  angle: number
  /** Of its centre of mass, in cells a second. */
  vx: number
  vy: number
  /** Radians a second. */
  spin: number
}

/** Ground that came loose, and is not ground again. */
export interface Rock<Body> extends Readonly<Motion> {
  /** What it is made of: polygons from its origin, with their blocks. */
  readonly ground: GroundBody
  /** Null if all of it is too thin for a body. */
  readonly body: Body | null
}

/** What there is to draw in a square of cells. Both lists are empty where there is nothing any more. */
export interface GroundDrawing {
  /** Names the square: the same string for the same square. */
  readonly key: string
  readonly cells: CellRect
  /** Polygons of the ground, counter-clockwise, as x, y, x, y, …; not all of them are convex. */
  readonly fills: readonly { readonly block: Block; readonly vertices: Float64Array }[]
  /** Lines along the outline, each x, y, x, y, …; the solid is on the left. */
  readonly lines: readonly Float64Array[]
}

/** What a Ground needs of a physics engine, or of what is in its place. */
export interface Host<Body> {
  /** Throws where nothing can be changed now. */
  refuseInStep(): void
  /** Does work, all of it, even if a listener throws: that comes out at its end. */
  whole<T>(work: () => T): T
  /** Which bodies the game has not destroyed. */
  living(): (body: Body) => boolean
  /** After each commit and roll-back. */
  show(changes: Changes): void
  /** A body for a rock; null, if there can be none. */
  make(ground: GroundBody, motion: Motion): Body | null
  motionOf(body: Body): Motion
  /** Whether it rests, and may be ground again. */
  rests(body: Body): boolean
  /** Puts it into the ground, as an edit, and its body goes. False, and nothing has changed, where it does not fit. */
  settle(body: Body, ground: GroundBody): boolean
  destroy(body: Body): void
  /** The game's from now on. */
  forget(body: Body): void
  /** These cells are in memory, as far as they came in yet, and no others. */
  window(cells: CellRect, isWhole: boolean): void
  step(dt: number): void
  free(): void
}
