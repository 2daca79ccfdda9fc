// The ground: the one owner of the LocalGridSeg world. Everybody else hears of changes from here.
import type { CellRect, Changes, LgsError, Mark, World } from 'localgridseg'
import type { Document } from './documents.js'
import { apply, cellsOf, type Edit, union } from './edit.js'

/** What a commit or an undo did. The lists are valid while the listeners run. */
export interface GroundChange {
  readonly changes: Changes
  /** The cells whose polygons may differ. */
  readonly cells: CellRect
  /** A tile is put, a brush strokes; to undo is to roll back; what falls leaves the ground, or is ground again. */
  readonly what: 'tile' | 'stroke' | 'undo' | 'fall'
  /** Of an undo: the moment that it led back to. */
  readonly mark: Mark | null
  /** How long the edits and the commit took, in milliseconds; the browser may round that to 0.1. */
  readonly editTime: number
  readonly commitTime: number
}

interface Stroke {
  readonly mark: Mark
  readonly edits: Edit[]
  cells: CellRect | null
}

const longestHistory = 200

export class Ground {
  onChange: (change: GroundChange) => void = () => {}
  onRefusal: (message: string) => void = () => {}
  /** Before the first and after the last edit of a stroke, and of an undo. */
  onBegin: () => void = () => {}
  onEnd: () => void = () => {}
  /** When the moment is noted to which an undo leads back. */
  onMark: (mark: Mark) => void = () => {}
  #document: Document
  #past: Stroke[] = []
  #future: Stroke[] = []
  #stroke: Stroke | null = null
  #pending: CellRect | null = null
  #editTime = 0
  #what: 'tile' | 'stroke' | 'fall' = 'stroke'
  #forgotten = false // whether strokes are so long ago that they cannot be undone

  constructor(document: Document) {
    this.#document = document
  }

  get document(): Document {
    return this.#document
  }

  get world(): World {
    return this.#document.world
  }

  /** Another document. Its world must be committed. */
  open(document: Document): void {
    this.world.free()
    this.#document = document
    this.#past = []
    this.#future = []
    this.#stroke = null
    this.#pending = null
    this.#editTime = 0
    this.#forgotten = false
  }

  /** Edits between begin() and end() are undone together. */
  begin(): void {
    this.end()
    this.#stroke = { mark: this.world.mark(), edits: [], cells: null }
    this.onMark(this.#stroke.mark)
    this.onBegin()
  }

  end(): void {
    this.commit()
    const stroke = this.#stroke
    this.#stroke = null
    if (stroke === null) return
    if (stroke.edits.length === 0) {
      this.world.forget(stroke.mark)
      return
    }
    this.#past.push(stroke)
    this.#future = []
    if (this.#past.length > longestHistory) {
      this.world.forget(this.#past.shift()!.mark)
      this.#forgotten = true
    }
    this.onEnd()
  }

  /**
   * Between begin() and end(). A refused edit has changed nothing. A stroke that was ended from elsewhere, by an undo or
   * another document, has no further edits: who still holds the button down changes nothing.
   */
  edit(edit: Edit): void {
    if (this.#stroke === null) return
    const start = performance.now()
    try {
      apply(this.world, edit)
    } catch (error) {
      this.onRefusal((error as LgsError).message)
      return
    }
    this.#editTime += performance.now() - start
    this.#what = edit.kind === 'tile' || edit.kind === 'clear' ? 'tile' : 'stroke'
    const cells = cellsOf(edit)
    this.#stroke.edits.push(edit)
    this.#stroke.cells = union(this.#stroke.cells, cells)
    this.#pending = union(this.#pending, cells)
  }

  /**
   * An edit that no hand makes, of what falls, and its commit. An undo of the last stroke takes it back, and a redo lets
   * it happen again. False, and nothing has changed, if the edit says so.
   */
  editAlone(edit: () => boolean, cells: readonly CellRect[]): boolean {
    this.commit()
    if (!edit()) return false
    this.#what = 'fall'
    const stroke = this.#stroke ?? this.#past.at(-1)
    for (const each of cells) {
      this.#pending = union(this.#pending, each)
      if (stroke) stroke.cells = union(stroke.cells, each)
    }
    this.commit()
    return true
  }

  /** Brings the segments up to date, once a frame. */
  commit(): void {
    if (this.#pending === null) return
    const cells = this.#pending
    const editTime = this.#editTime
    this.#pending = null
    this.#editTime = 0
    const start = performance.now()
    const changes = this.world.commit()
    const commitTime = performance.now() - start
    this.onChange({ changes, cells, what: this.#what, mark: null, editTime, commitTime })
  }

  get isInStroke(): boolean {
    return this.#stroke !== null
  }

  /** Also in the middle of a stroke: that one ends then. */
  get canUndo(): boolean {
    return this.#past.length > 0 || this.#stroke !== null
  }

  /** Whether it differs from what was opened, as far as is known. */
  get isEdited(): boolean {
    return this.#past.length > 0 || this.#forgotten
  }

  get canRedo(): boolean {
    return this.#future.length > 0
  }

  undo(): void {
    this.end()
    const stroke = this.#past.pop()
    if (stroke === undefined) return
    this.#future.push(stroke)
    this.onBegin()
    const start = performance.now()
    const changes = this.world.rollBack(stroke.mark)
    const commitTime = performance.now() - start
    this.onChange({ changes, cells: stroke.cells!, what: 'undo', mark: stroke.mark, editTime: 0, commitTime })
    this.world.forget(stroke.mark)
    this.onEnd()
  }

  redo(): void {
    this.end()
    const stroke = this.#future.pop()
    if (stroke === undefined) return
    const future = this.#future
    this.begin()
    for (const edit of stroke.edits) this.edit(edit)
    this.end()
    this.#future = future
    this.onEnd()
  }
}
