/// <reference lib="esnext.disposable" preserve="true" />
// What the package hands out and takes. Lengths and positions are in cells, y up; they are exact, since the lattice has
// 65,536 units to a cell and a double holds them all.

/**
 * A number, which the compiler does not let stand for an id of another kind. What is a number alone, as in a list, can
 * stand for any.
 */
export type Id<Kind extends string> = number & { readonly isA?: Kind }

/** A polygon that was validated once: see World.shape(). One of another world is refused, as 'unknown-shape'; a world that
 *  was loaded takes those of the world that was saved. */
export type ShapeId = Id<'shape'>
/** A placed polygon. It is a safe integer. Once the polygon is removed, its id never names another one. */
export type PolygonId = Id<'polygon'>
/** A segment of the outline: small and dense, good as an index. 0 names none. */
export type SegmentId = Id<'segment'>
/** A number of yours that a polygon carries, say of a material: 0 to 2^32 - 1. */
export type Block = Id<'block'>
/** A moment to which a world can roll back. */
export type Mark = Id<'mark'>
/** A state of the ground and its segments: World.version. */
export type Version = Id<'version'>

/** Vertices of a polygon, counter-clockwise: x, y, x, y, …, or pairs. They are rounded to the lattice. */
export type Vertices = ArrayLike<number> | readonly (readonly [number, number])[]

/** All cells from (i0, j0) to (i1, j1), both included. Empty if i1 < i0 or j1 < j0. */
export interface CellRect {
  readonly i0: number
  readonly j0: number
  readonly i1: number
  readonly j1: number
}

/** A square of cells and the hash of what is in it. */
export interface HashedSquare {
  /** 0: a chunk of 32×32 cells. Each level has squares of 4×4 of the one below, up to 14, the world. */
  readonly level: number
  /** As far as they are in range. */
  readonly cells: CellRect
  /** The sum of the hashes of its polygons, modulo 2^64. */
  readonly hash: bigint
}

export interface WorldOptions {
  /**
   * Whether the edges between polygons of these two blocks stay. The smaller block comes first. It is called once
   * for each pair. If it throws, the pair is cancelled, and the call in which that happened throws an LgsError.
   */
  preserve?: ((smaller: Block, greater: Block) => boolean) | undefined
  /** Geometry in 'double' (Float64Array, exact; the default) or 'float' (Float32Array, rounded). */
  precision?: 'double' | 'float' | undefined
}

/**
 * Segments with their geometry, as typed arrays. Those of a commit are valid until the world's next commit(), rollBack()
 * or free(), those of segments() until its next segments() or free(): read later, a property throws an LgsError
 * 'stale-list'. An array that you keep yourself is not guarded: the next call of that kind overwrites it. copy() makes
 * lists that stay, and that can be posted.
 *
 * for (const segment of list) gives them one by one, which is comfortable, and slower than to read the arrays.
 */
export interface SegmentList {
  readonly length: number
  /** Ids. */
  readonly id: Uint32Array
  /**
   * Eight numbers a segment: start x, y, end x, y, ghost1 x, y, ghost2 x, y. The solid is on the left of start to end.
   * ghost1 is the start of the predecessor, ghost2 the end of the successor; NaN if there is none, which happens only
   * under a preserve relation.
   */
  readonly geometry: Float64Array | Float32Array
  readonly block: Uint32Array
  /** Two numbers a segment: i, j of its polygon's cell. */
  readonly cell: Int32Array
  /** The polygon of each segment: a PolygonId. */
  readonly owner: Float64Array
  /**
   * The segment before each one, and the one after it; 0 if there is none. A later commit may put another segment with
   * the same far end there, and does not list this one then: as no ghost has moved, it is not relinked.
   */
  readonly predecessor: Uint32Array
  readonly successor: Uint32Array
  copy(): SegmentList
  [Symbol.iterator](): Iterator<Segment>
}

/** What a commit or a roll-back did to the segments. No id is in two lists; after a roll-back one that named one
 * segment and names another one now is removed, and then added. Valid as long as a SegmentList. */
export interface Changes {
  /** Ids that name nothing from now on. */
  readonly removed: Uint32Array
  readonly added: SegmentList
  /** Alive before and after, with another ghost. */
  readonly relinked: SegmentList
  /** World.version before and after. If they are equal, there was nothing to do. */
  readonly before: Version
  readonly after: Version
  copy(): ChangesCopy
}

/**
 * Changes that stay. All that they hold is theirs, in one buffer: worker.postMessage(copy) copies it, and
 * worker.postMessage(copy, copy.buffers()) hands it over. What arrives has the arrays and the versions, and no functions.
 */
export interface ChangesCopy extends Changes {
  buffers(): ArrayBuffer[]
}

export interface Segment {
  readonly id: SegmentId
  readonly start: readonly [number, number]
  readonly end: readonly [number, number]
  readonly ghost1: readonly [number, number] | null
  readonly ghost2: readonly [number, number] | null
  readonly predecessor: SegmentId
  readonly successor: SegmentId
  readonly block: Block
  readonly polygon: PolygonId
  readonly i: number
  readonly j: number
}

export interface Polygon {
  readonly id: PolygonId
  readonly i: number
  readonly j: number
  readonly block: Block
  /** x, y, x, y, … from the lower left corner of the cell: 0 to 1. */
  readonly vertices: Float64Array
}

/** A closed chain, in the direction of its segments: the solid is on the left. */
export interface Loop {
  /** x, y, x, y, …; the last edge leads back to the first vertex. */
  readonly vertices: Float64Array
  /** segments[k] starts at vertex k; empty if collinear ones were merged. */
  readonly segments: Uint32Array
}

/** A chunk of 32×32 cells that left memory. */
export interface UnloadedChunk {
  /** Its lower-left cell. */
  readonly i: number
  readonly j: number
  /** What World.reload() takes. */
  readonly bytes: Uint8Array
}

/** What was hit. */
export interface Hit {
  readonly polygon: PolygonId
  readonly block: Block
  readonly i: number
  readonly j: number
}

export interface Spot extends Hit {
  /** On an edge the polygon is the first that has it; outside it is 0, and the cell is that of the point. Where a chunk
   * is unloaded that decides it, nothing is known: the polygon is 0, too. */
  readonly where: 'outside' | 'edge' | 'inside' | 'unloaded'
}

export interface Nearest {
  readonly segment: SegmentId
  readonly x: number
  readonly y: number
  readonly distance: number
}

export interface RayHit {
  readonly segment: SegmentId
  /** Of the way from the start to the end of the ray. */
  readonly fraction: number
  readonly x: number
  readonly y: number
  /** The outward normal of the segment, of length 1. */
  readonly nx: number
  readonly ny: number
}

/** A set of points, given by closed rings in cells of the world. They may cross, overlap and run either way around. */
export interface Region {
  readonly rings: readonly Vertices[]
  /** 'nonZero': rings that overlap are united (the default). 'evenOdd': a ring within a ring is a hole. */
  readonly rule?: 'nonZero' | 'evenOdd'
}

/**
 * What a brush did to polygons. A polygon that is not named has kept its id, vertices and block. The lists are made when
 * they are read, which can be until the next brush of that world, or its free(): first read after that, they throw an
 * LgsError 'stale-list'.
 */
export interface BrushResult {
  /** Nothing is left of them. */
  readonly removed: readonly PolygonId[]
  /** There is nothing of an old polygon in them. */
  readonly added: readonly PolygonId[]
  /** Old polygons that are cut, united or recoloured, and what stands in their place. */
  readonly changed: readonly { readonly old: PolygonId; readonly now: readonly PolygonId[] }[]
  /** Of the old ones above those that the region did not reach: rounding moved them, by less than a lattice unit. */
  readonly rounded: readonly PolygonId[]
}

/** How much there is in a world. */
export interface Stats {
  readonly polygons: number
  readonly cells: number
  readonly segments: number
  readonly shapes: number
  readonly contents: number
  readonly chunks: number
  readonly bytes: number
}

/** Where the code of WebAssembly comes from; all optional. Without any, it is the file lgs.wasm beside the module. */
export interface InitOptions {
  url?: string | URL
  bytes?: BufferSource
  module?: WebAssembly.Module
}

/**
 * A world of unit cells that hold polygons, and the outline of these. Free it when it is no longer needed.
 *
 * What is refused throws an LgsError, and has changed nothing. For any call its `code` can be 'bad-argument', 'freed' or
 * 'busy' (and 'preserve-failed', 'out-of-memory' or 'crashed', where something went wrong: see ErrorCode); besides:
 *
 * | call | code |
 * |---|---|
 * | shape | 'too-few-vertices', 'capacity', 'not-finite', 'outside-cell', 'repeated-vertex', 'zero-area', 'self-intersecting', 'clockwise' |
 * | add, addMany, fill, replace | 'cell-out-of-range', 'unloaded', 'unknown-shape', 'overlap' (not replace), 'capacity' |
 * | addPolygon | as shape and add |
 * | remove, removeMany, setBlock | 'stale-handle', 'unloaded', 'capacity' |
 * | clear | 'cell-out-of-range', 'unloaded' |
 * | paint, carve | 'out-of-reach', 'capacity', 'unloaded' |
 * | rollBack, redo, forget | 'unknown-mark' |
 * | unload, reloadEmpty | 'cell-out-of-range' |
 * | reload | those of saves, from 'not-a-snapshot' to 'other-bytes' in ErrorCode |
 * | polygon | 'stale-handle', 'unloaded' |
 * | segment, hit | 'unknown-segment', 'unloaded' |
 * | at | 'out-of-reach' |
 * | nearest, rayCast | 'out-of-reach', 'unloaded' |
 * | save, saveText | 'uncommitted', 'unloaded' |
 * | all others | no more |
 */
export interface World {
  /** Validates and stores one polygon: simple, counter-clockwise, in the closed cell from (0, 0) to (1, 1). */
  shape(vertices: Vertices): ShapeId
  add(i: number, j: number, shape: ShapeId, block: Block): PolygonId
  /** Four integers an entry: i, j, shape, block. All of them or none. Returns the ids, in this order. */
  addMany(entries: Int32Array): Float64Array
  /** A polygon by its vertices: a shape that is made on the way. */
  addPolygon(i: number, j: number, vertices: Vertices, block: Block): PolygonId
  remove(polygon: PolygonId): void
  /** All of them or none. */
  removeMany(polygons: ArrayLike<PolygonId>): void
  /** Puts a shape in the place of all polygons of a cell. */
  replace(i: number, j: number, shape: ShapeId, block: Block): PolygonId
  setBlock(polygon: PolygonId, block: Block): void
  /** A shape in every cell of a rectangle, or in none. Returns the number of cells. */
  fill(cells: CellRect, shape: ShapeId, block: Block): number
  /** Removes all polygons of a rectangle, or of a cell. Returns their number. */
  clear(cells: CellRect): number
  clear(i: number, j: number): number
  /** 'fill' (the default) paints what is free; 'replace' takes over what is there. */
  paint(region: Region, block: Block, mode?: 'fill' | 'replace'): BrushResult
  carve(region: Region): BrushResult

  /** Brings the segments up to date with all edits, and returns what changed. */
  commit(): Changes
  mark(): Mark
  /** The mark stays. Later ones are invalidated, or with 'keep' they are ahead, and redo() leads there. */
  rollBack(mark: Mark, undone?: 'drop' | 'keep'): Changes
  /** To a mark that is ahead: what was undone comes back with its handles and ids, if nothing was edited since. */
  redo(mark: Mark): Changes
  forget(mark: Mark): void

  /**
   * The chunks of 32×32 cells that lie in a rectangle as a whole leave memory. They are handed out as bytes, with which
   * they come back. The next commit reports their segments as removed, and no wall appears where the loaded world ends.
   * Until they are back edits there are refused as 'unloaded', and so are handles of their polygons, and questions that
   * would have to look there.
   */
  unload(cells: CellRect): UnloadedChunk[]
  /** A chunk comes back as it was, to the last handle: the bytes that unload() gave last for it. Returns where it is. */
  reload(chunk: Uint8Array): { i: number; j: number }
  /** The unloaded chunks that lie in a rectangle as a whole come back empty, for a game that makes their ground again.
   * Returns how many these are. */
  reloadEmpty(cells: CellRect): number
  /** The first unloaded cell of a rectangle, by rows; null if there is none. */
  firstUnloaded(cells: CellRect): { i: number; j: number } | null

  /** All segments, or those of polygons in a rectangle of cells, as of the last commit. By id, or in no order. */
  segments(cells?: CellRect): SegmentList
  segment(id: SegmentId): Segment
  /** Closed chains; with `merge` a vertex where the outline goes straight on is dropped. */
  loops(options?: { merge?: boolean }): Loop[]
  /** After all edits, committed or not. */
  polygonsAt(i: number, j: number): Polygon[]
  polygons(cells?: CellRect): Polygon[]
  polygon(id: PolygonId): Polygon
  /** The polygon of a segment: which tile was hit? */
  hit(id: SegmentId): Hit
  /** Which polygon is at a point, after all edits. Refused beyond the last cell. */
  at(x: number, y: number): Spot
  /** The segment nearest to a point, at most `radius` (0 to 4,096) away. */
  nearest(x: number, y: number, radius: number): Nearest | null
  /** The first segment that a ray meets on its outward side. */
  rayCast(x0: number, y0: number, x1: number, y1: number): RayHit | null

  /**
   * The world as bytes: loadWorld() makes it again. Everything must be committed. Marks are not saved: the loaded world
   * has none, and it has another version. Ids and handles are saved.
   */
  save(): Uint8Array
  /** The same as text (Base64), for JSON or localStorage. A third longer. */
  saveText(): string
  stats(): Stats
  /** The least rectangle of cells with all polygons; null in an empty world. */
  bounds(): CellRect | null
  /**
   * The version of the ground and its segments. Each commit that finds an edit, or a chunk that left memory or came
   * back, makes a new one, and no other world here ever has it.
   */
  readonly version: Version
  /** The highest segment id in use so far. */
  readonly maxSegmentId: SegmentId
  /** Gives its memory back. A second call does nothing; any other method throws from then on. */
  free(): void
  [Symbol.dispose](): void
}

/**
 * How to import a map; all optional. The options of `lgs import` have the same names. Without `solid`, `solidIf`,
 * `objects` and `tiles` the map decides what is solid, by the strongest evidence that there is in it.
 */
export interface ImportOptions {
  /** Pixels: a vertex that misses a grid line by so much is put on it. Default 1. */
  tolerance?: number
  /** A tile without collision shapes is a full square. */
  solid?: boolean
  /** The same for tiles with one of these properties: 'NAME' or 'NAME=VALUE'. */
  solidIf?: readonly string[]
  /** Where blocks come from. Default 'one': every polygon has block 1. */
  block?: 'one' | 'class' | 'name' | 'layer'
  /** The block of a class, name or layer; others get further numbers. */
  numbers?: Readonly<Record<string, Block>>
  /** Tile layers to import; all by default. */
  layers?: readonly string[]
  /** Object layers to import, or classes or names of objects. */
  objects?: readonly string[]
  /** Classes of tiles and objects, and names of values in LDtk, to leave out. */
  not?: readonly string[]
  /** What tiles are by their numbers: a table as docs/maps.md describes it. */
  tiles?: string
  /** A map of a world that is not among the files is an error; otherwise the others are imported. */
  allMaps?: boolean
  /** Leave out what is hidden. */
  visible?: boolean
  /** Pixels: open polylines become polygons of this thickness. */
  polylineThickness?: number
}

/** A map of Tiled or LDtk as polygons in cells. */
export interface ImportedMap {
  /** Distinct polygons: x, y, x, y, … from the lower left corner of a cell. */
  readonly shapes: readonly Float64Array[]
  /** i, j, index in `shapes`, block. */
  readonly placements: Int32Array
  /** For each placement: its tile, as an index in `tiles`, or -1; its object's id, or 0; its layer. */
  readonly tile: Int32Array
  readonly object: Uint32Array
  readonly layer: Uint32Array
  readonly tiles: readonly { readonly tileset: string; readonly id: number; readonly class: string }[]
  readonly layers: readonly string[]
  /** The block of each class, name or layer. */
  readonly blocks: Readonly<Record<string, Block>>
  /** What says that it is solid and was not taken; '' if all of it was. */
  readonly partial: string
  /** What in the map could be taken instead, and how many polygons that gives; the likeliest first. */
  readonly suggestions: readonly string[]
  /** What came in, and what was left out or changed. */
  readonly report: string
  /** Places all polygons in a world, or none. Returns their ids, in the order of `placements`. */
  place(world: World): Float64Array
}

/** The files of a map by their paths: what the map names is looked for by its path, and then by its name alone. */
export type MapFiles = Readonly<Record<string, Uint8Array | string>>
