// The convex pieces of a world, kept up to date.
import { bad, int32, object, options as known, real, rect, uint32, within } from './check.js'
import { Follower, type Place } from './follower.js'
import type { Block, CellRect, Changes, PolygonId, World } from './types.js'

/** A convex piece: x, y, x, y, … in cells of the world, counter-clockwise from the least vertex. */
export interface Piece {
  readonly vertices: Float64Array
}

/** A piece of one polygon. */
export interface SolidPiece extends Piece {
  readonly polygon: PolygonId
  readonly block: Block
}

/** Names a free piece: the index in freePieces() of its cell. It is good until its cell has other pieces. */
export interface PieceId {
  readonly i: number
  readonly j: number
  readonly index: number
}

/**
 * From one free piece to another: what the two have in common. `right` and `left` are its ends, in the direction
 * of passage: [x, y] in cells of the world.
 */
export interface Portal {
  readonly to: PieceId
  readonly right: readonly [number, number]
  readonly left: readonly [number, number]
}

export interface PiecesOptions {
  /** Of one piece, 3 to 4,096. Box2D and planck take 8, which it is if it is not given. */
  maxVertices?: number | undefined
}

/** So many cells are looked at by one call of wholeCells(), at most. */
const mostCells = 2 ** 24

/**
 * The convex pieces of a world, on vertices that are there already. The solid pieces of a cell make up its polygons, and
 * the free ones what they leave of it. Make it while no edit waits for its commit and while there is no mark, and give
 * it each commit's and roll-back's changes. docs/pieces.md describes all of it.
 */
export class Pieces extends Follower {
  /** Reads all polygons once. */
  constructor(world: World, options: PiecesOptions = {}) {
    const { maxVertices = 8 } = known('options', ['maxVertices'], options)
    within('maxVertices', int32('maxVertices', maxVertices), 3, 4096)
    super(world, 'dropPieces', (call, _, address) => call.pieces(address, maxVertices))
  }

  protected override isOfNow({ call, view, world }: Place): number { return call.arePiecesOfNow(view, world) }

  /**
   * Takes over what a commit or a roll-back did, each once and before the next edit. Returns the cells that have other
   * pieces now. Throws, and has changed nothing: 'not-the-last', 'uncommitted', or 'left-out', after which new Pieces are
   * needed. After a roll-back to a mark that was made while edits waited it is 'uncommitted': make new Pieces after the
   * next commit.
   */
  update(changes: Changes): { readonly i: number; readonly j: number }[] {
    this.follow(changes, ({ call, view, world }) => call.updatePieces(view, world))
    const { call, view } = this.at
    const n = this.numbers(call.changedPieces(view))
    return Array.from({ length: n.length / 2 }, (_, k) => ({ i: n[2 * k]!, j: n[2 * k + 1]! }))
  }

  /** By polygons, then by vertices. Refused while edits wait, or a commit was left out. */
  solidPieces(i: number, j: number): SolidPiece[] {
    int32('i', i), int32('j', j)
    const { call, view, world } = this.current
    const n = this.from.answer(call.solidPieces(view, world, i, j)), pieces: SolidPiece[] = []
    for (let k = 0; k < n.length; ) {
      const end = k + 3 + 2 * n[k + 2]!
      pieces.push({ polygon: n[k]!, block: n[k + 1]!, vertices: n.slice(k + 3, end) })
      k = end
    }
    return pieces
  }

  /** As of the last update. A cell without polygons has one, a cell out of range none. */
  freePieces(i: number, j: number): Piece[] {
    int32('i', i), int32('j', j)
    const { call, view } = this.at
    const n = this.from.answer(call.freePieces(view, i, j)), pieces: Piece[] = []
    for (let k = 0; k < n.length; ) {
      const end = k + 1 + 2 * n[k]!
      pieces.push({ vertices: n.slice(k + 1, end) })
      k = end
    }
    return pieces
  }

  /** The portals of a free piece, as of the last update. A piece that is not there has none. */
  portals(piece: PieceId): Portal[] {
    object('piece', '{ i, j, index }', piece)
    const i = int32('i', piece.i), j = int32('j', piece.j), index = uint32('index', piece.index)
    const { call, view } = this.at
    const n = this.numbers(call.portals(view, i, j, index))
    return Array.from({ length: n.length / 7 }, (_, portal) => {
      const k = 7 * portal
      return {
        to: { i: n[k]!, j: n[k + 1]!, index: n[k + 2]! },
        right: [n[k + 3]!, n[k + 4]!], left: [n[k + 5]!, n[k + 6]!],
      }
    })
  }

  /** A free piece that has a point, its boundary included; null in what is solid. */
  freePieceAt(x: number, y: number): PieceId | null {
    real('x', x), real('y', y)
    const { call, view } = this.at
    if (!call.freePieceAt(view, x, y)) return null
    const [i, j, index] = this.numbers(3) as [number, number, number]
    return { i, j, index }
  }

  /** The cells of a rectangle, at most 2^24, that are solid, or free, as a whole, merged to rectangles. */
  wholeCells(cells: CellRect, part: 'solid' | 'free'): CellRect[] {
    const { i0, j0, i1, j1 } = rect(cells)
    if (part !== 'solid' && part !== 'free') throw bad('part', "'solid' or 'free'", part)
    if (i1 >= i0 && j1 >= j0) within('the number of cells', (i1 - i0 + 1) * (j1 - j0 + 1), 0, mostCells)
    const { call, view } = this.at
    const n = this.numbers(call.wholeCells(view, i0, j0, i1, j1, part === 'free' ? 1 : 0))
    return Array.from({ length: n.length / 4 }, (_, k) =>
      ({ i0: n[4 * k]!, j0: n[4 * k + 1]!, i1: n[4 * k + 2]!, j1: n[4 * k + 3]! }))
  }
}
