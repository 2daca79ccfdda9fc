// A copy of the segments by id, kept up to date from changes: for whoever asks many times in each step.
import type { Changes, SegmentId, SegmentList, World } from 'localgridseg'

export class Mirror {
  /** Eight numbers of each segment: start, end, ghosts; NaN where there is no ghost. */
  readonly geometry: Float64Array[] = []
  readonly block: number[] = []

  reset(world: World): void {
    this.geometry.length = 0
    this.block.length = 0
    this.#write(world.segments())
  }

  /** The geometry of removed segments stays readable until their ids are given out again. */
  update(changes: Changes): void {
    this.#write(changes.added)
    this.#write(changes.relinked)
  }

  /** The ends of some segments, to be kept: start x, y, end x, y of each. */
  ends(ids: ArrayLike<SegmentId>): Float64Array {
    const ends = new Float64Array(4 * ids.length)
    for (let k = 0; k < ids.length; ++k) ends.set(this.geometry[ids[k]].subarray(0, 4), 4 * k)
    return ends
  }

  #write(list: SegmentList): void {
    const { id, geometry, block } = list
    for (let k = 0; k < id.length; ++k) {
      this.geometry[id[k]] = Float64Array.from(geometry.subarray(8 * k, 8 * k + 8))
      this.block[id[k]] = block[k]
    }
  }
}
