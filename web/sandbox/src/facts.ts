// The line below: what the last edit did, and how long it took.
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

  // The clock is coarse, so one short time is only a bound; the mean of many is right.
  #time(total: number): string {
    const mean = total / this.#commits
    if (total < clock) return `< ${Math.round((1000 * clock) / this.#commits)} µs`
    return mean < 1 ? `${Math.round(1000 * mean)} µs` : `${Math.round(10 * mean) / 10} ms`
  }
}
