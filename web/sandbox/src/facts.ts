// The line below: what the last edit did, how long it took, and how long a full recompute takes.
import { element } from './dom.js'
import type { GroundChange } from './ground.js'

const clock = 0.1 // milliseconds: browsers round times to that

export class Facts {
  #commits = 0
  #editTime = 0
  #commitTime = 0

  /** A new stroke begins: times are means over its commits. */
  begin(): void {
    this.#commits = this.#editTime = this.#commitTime = 0
  }

  /** Of another document nothing is known yet. */
  reset(): void {
    this.begin()
    for (const id of ['removed', 'added', 'relinked']) element(id).textContent = `0 ${id}`
    element('times').textContent = 'Dig to see numbers.'
    element('recompute').textContent = ''
  }

  note({ changes, what, editTime, commitTime }: GroundChange): void {
    ++this.#commits
    this.#editTime += editTime
    this.#commitTime += commitTime
    element('removed').textContent = `${changes.removed.length} removed`
    element('added').textContent = `${changes.added.length} added`
    element('relinked').textContent = `${changes.relinked.length} relinked`
    const mean = this.#commits > 1 ? `, mean of ${this.#commits}` : ''
    element('times').textContent = `${what}: edit ${this.#time(this.#editTime)}, commit ${this.#time(this.#commitTime)}${mean}`
  }

  /** What a union of all polygons takes, and one of the chunks in which the edit was; null if it was not measured. */
  recomputed(world: number, chunks: number | null): void {
    const inWords = (milliseconds: number) => `${Math.round(milliseconds * 10) / 10} ms`
    const part = chunks === null ? '' : `, only the chunks touched: ${inWords(chunks)}`
    element('recompute').textContent = `recomputing everything (polygon-clipping): ${inWords(world)}${part}`
  }

  // The clock is coarse, so one short time is only a bound; the mean of many is right.
  #time(total: number): string {
    const mean = total / this.#commits
    if (total < clock) return `< ${Math.round((1000 * clock) / this.#commits)} µs`
    return mean < 1 ? `${Math.round(1000 * mean)} µs` : `${Math.round(10 * mean) / 10} ms`
  }
}
