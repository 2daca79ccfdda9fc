// Why a call was refused. A refused call has changed nothing.
import type { Block, PolygonId, SegmentId } from './types.js'

/** In the order of lgs::ErrorCode, from 1. */
const engineCodes = [
  'cell-out-of-range', 'empty-shape', 'too-few-vertices', 'capacity', 'not-finite', 'outside-cell', 'repeated-vertex',
  'zero-area', 'self-intersecting', 'clockwise', 'overlap', 'unknown-shape', 'stale-handle', 'unknown-segment',
  'unknown-mark', 'uncommitted', 'out-of-reach', 'unloaded', 'anchored',
] as const

/** In the order of lgs::SnapshotError::What, from 0. */
const snapshotCodes = [
  'not-a-snapshot', 'unknown-version', 'cut', 'damaged', 'too-long', 'relation', 'bad-number', 'bad-polygon',
  'bad-segments', 'snapshot-capacity', 'loaded', 'other-bytes',
] as const

/**
 * 'bad-argument': a number of the wrong kind, an array of the wrong length. 'not-ready': init() has not ended, or found no code.
 * 'freed': the world was freed. 'stale-list': see SegmentList. 'not-a-copy': lists were posted that are no copy.
 * 'busy': a call from within `preserve`, or an edit of a physics world in its step.
 * 'left-out', 'shown-already', 'not-the-last': a terrain was given changes that do not follow what it shows.
 * 'preserve-failed': `preserve` threw; `cause` says what. The call was done none the less, and what it gives is lost.
 * 'out-of-memory' and 'crashed': the engine stopped, and so did every world; init() and new worlds are needed.
 * 'bad-trace' and 'bad-map' are of the text that was read.
 */
export type ErrorCode =
  | (typeof engineCodes)[number]
  | (typeof snapshotCodes)[number]
  | 'bad-argument' | 'not-ready' | 'freed' | 'stale-list' | 'not-a-copy' | 'busy' | 'left-out' | 'shown-already' | 'not-the-last' | 'preserve-failed' | 'out-of-memory' | 'crashed'
  | 'bad-trace' | 'bad-map'

/** What was refused, and where. What does not apply is null. */
export interface ErrorDetails {
  /** The cell of the edit. */
  readonly cell: { readonly i: number; readonly j: number } | null
  /** Index in the polygons, or in the rings of a region, that the call was given. */
  readonly polygon: number | null
  /** Index in that polygon; for an edge its first vertex. */
  readonly vertex: number | null
  /** The other vertex or edge. */
  readonly vertex2: number | null
  /** Overlap within one call: the other polygon. */
  readonly polygon2: number | null
  /** Overlap: the polygon that is there already. Stale handle: that handle. */
  readonly other: PolygonId | null
  readonly otherBlock: Block | null
  readonly segment: SegmentId | null
  /** A call that takes many: the entry that is refused, and the other one involved. */
  readonly index: number | null
  readonly index2: number | null
  /** A saved world: the byte. */
  readonly offset: number | null
  /** A trace or a map: the line, from 1. */
  readonly line: number | null
}

const nowhere: ErrorDetails = {
  cell: null, polygon: null, vertex: null, vertex2: null, polygon2: null, other: null, otherBlock: null, segment: null,
  index: null, index2: null, offset: null, line: null,
}

export interface LgsError extends ErrorDetails {}
export class LgsError extends Error {
  override readonly name = 'LgsError'
  constructor(readonly code: ErrorCode, message: string, details: Partial<ErrorDetails> & { cause?: unknown } = {}) {
    super(message, 'cause' in details ? { cause: details.cause } : undefined)
    const { cause: _, ...where } = details
    Object.assign(this, nowhere, where)
  }
}

const noCell = -(2 ** 31)

/** An error from the numbers of lgs::web::Failure (web/wasm/bridge.cpp), and its sentence. */
export function engineError(n: Float64Array, sentence: string): LgsError {
  if (n[12] !== 0) return new LgsError(snapshotCodes[n[0]!]!, sentence, { offset: n[13]! })
  const index = (v: number | undefined) => (v! < 0 ? null : v!)
  const id = (v: number | undefined) => (v === 0 ? null : v!)
  const code = engineCodes[n[0]! - 1]!
  return new LgsError(code, sentence, {
    cell: n[1] === noCell ? null : { i: n[1]!, j: n[2]! },
    polygon: index(n[3]), vertex: index(n[4]), vertex2: index(n[5]), polygon2: index(n[6]),
    other: id(n[7]), otherBlock: code === 'overlap' && n[7] !== 0 ? n[8]! : null,
    segment: id(n[9]), index: index(n[10]), index2: index(n[11]),
  })
}
