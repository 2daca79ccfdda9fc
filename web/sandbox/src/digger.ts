// What one sees first: the digger of examples/digger.js, what there is to win in it (goal.ts), its source beside it, and two
// wheels that race below. A hand digs until somebody else does.
import type { Ground } from 'localgridseg/planck'
import { digger } from '../../examples/digger.js'
import { element, onClick } from './dom.js'
import { Goal } from './goal.js'
import { Race } from './race/race.js'
import { drawLanes } from './race/view.js'
import { copied, holdsGround } from './share.js'
import { stepTime } from './side.js'
import { wantsCalm } from './theme.js'

const before = 900 // milliseconds until the hand digs
const cut = 500 // that it takes for a stem
const pause = 1700 // between two stems
const shown = 2 // things that it cuts; then it asks who looks on to cut the next
const wait = 1500 // between two races

export class Digger {
  static readonly address = '#digger'
  ground: Ground | null = null
  goal: Goal | null = null
  size = 0 // pixels of a cell
  readonly #section = element('digger')
  readonly #canvas = element<HTMLCanvasElement>('dig')
  readonly #hand = element('dig-hand')
  readonly #strip = element('dig-race').querySelector('canvas')!
  #isShowing = !wantsCalm() // the hand digs
  #cursor: [number, number] | null = null // of the keyboard, in pixels
  #strokes = 0 // that can be taken back
  readonly #begun: number[] = [] // how many there were when each dig began

  /** `onLeave`: for all tools. The digger is gone then. */
  async open(onLeave: () => Promise<void>): Promise<void> {
    const leave = async () => {
      if (location.hash === Digger.address) history.replaceState(null, '', location.pathname + location.search)
      this.#section.remove()
      document.documentElement.classList.remove('first')
      await onLeave()
    }
    // The land is 32 cells high, and a mouse hits small ones. For a finger they are larger, and the lower 21 are to be seen.
    const { clientHeight } = this.#canvas, least = matchMedia('(pointer: coarse)').matches ? (innerWidth < 720 ? 22 : 26) : 0
    this.size = Math.max(clientHeight / 32, Math.min(least, clientHeight / 21))
    const { ground, picture } = await digger(this.#canvas, this.size)
    this.ground = ground
    onClick('dig-more', () => void leave())
    addEventListener('hashchange', () => { if (this.#section.isConnected && holdsGround(location.hash)) void leave() })
    this.#count(ground)
    this.goal = new Goal(this.#canvas, ground, picture, () => this.#strokes)
    this.#listen()
    requestAnimationFrame((now) => this.#dig(now, now))
    requestAnimationFrame(() => requestAnimationFrame((now) => this.#race(now))) // once the ground is seen
    const source = await (await fetch('digger.js')).text()
    element('dig-code').querySelector('code')!.textContent = source
    onClick('dig-copy', () => void copied(source))
  }

  #listen(): void {
    for (const event of ['pointerdown', 'keydown']) addEventListener(event, ({ isTrusted }) => { if (isTrusted) this.#isShowing = false }, { capture: true })
    for (const [id, key] of [['dig-back', 'z'], ['dig-left', 'a'], ['dig-right', 'd']]) {
      const button = element(id), say = (type: string) => dispatchEvent(new KeyboardEvent(type, { key }))
      button.addEventListener('pointerdown', () => say('keydown'))
      for (const end of ['pointerup', 'pointerleave', 'pointercancel', 'keyup', 'blur']) button.addEventListener(end, () => say('keyup'))
      button.addEventListener('keydown', (event) => { if (event.key === 'Enter' || event.key === ' ') say('keydown') })
    }
    this.#canvas.addEventListener('pointerdown', ({ isTrusted }) => { if (isTrusted) this.#begin() }, { capture: true })
    this.#canvas.addEventListener('pointermove', ({ isTrusted }) => {
      if (!isTrusted || this.#cursor === null) return
      this.#cursor = null // whoever points needs no cursor
      this.#hand.hidden = true
    })
    addEventListener('keydown', ({ key, repeat }) => { if (key === 'z' && !repeat && this.#section.isConnected) this.#rewind() })
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }
    document.addEventListener('keydown', (event) => {
      if (!this.#section.isConnected || (event.target !== this.#canvas && event.target !== document.body)) return
      const { clientWidth, clientHeight } = this.#canvas, by = event.shiftKey ? arrows[event.key] : undefined
      if (by === undefined && event.key !== 'Enter' && event.key !== ' ') return
      event.preventDefault()
      event.stopPropagation() // else the arrow walked, too
      const [x, y] = this.#cursor ?? [clientWidth / 2, clientHeight / 2], step = this.size / 2
      this.#cursor = by === undefined ? [x, y] : [x + by[0] * step, y + by[1] * step]
      this.#show(...this.#cursor)
      if (by !== undefined) return
      this.#begin()
      this.#touch(...this.#cursor)
    })
  }

  // A dig has a stroke for each move of the pointer. One tap takes all of them back.
  #count(ground: Ground): void {
    const edit = ground.edit.bind(ground), undo = ground.undo.bind(ground)
    ground.edit = (edits) => {
      const result = edit(edits)
      ++this.#strokes
      return result
    }
    ground.undo = () => {
      const isDone = undo()
      if (isDone) --this.#strokes
      return isDone
    }
  }

  #begin(): void {
    this.#begun.push(this.#strokes)
  }

  /** To before the last dig. Who holds the key goes on stroke by stroke: that is digger.js. */
  #rewind(): void {
    while (this.#begun.length > 0) {
      const to = this.#begun.pop()!
      if (to >= this.#strokes) continue // it is taken back already
      while (this.#strokes > to && this.ground!.undo());
      return
    }
  }

  #show(x: number, y: number): void {
    this.#hand.hidden = false
    Object.assign(this.#hand.style, { left: `${x}px`, top: `${y}px` })
  }

  /** As a finger would, and up again. */
  #touch(...points: number[]): void {
    const { left, top } = this.#canvas.getBoundingClientRect()
    for (let k = 0; k < points.length; k += 2) {
      const at = { pointerId: -1, buttons: 1, clientX: left + points[k], clientY: top + points[k + 1] }
      this.#canvas.dispatchEvent(new PointerEvent(k === 0 ? 'pointerdown' : 'pointermove', at))
    }
    window.dispatchEvent(new PointerEvent('pointerup', { pointerId: -1 }))
  }

  /** What a crystal hangs on, later the stem of a mushroom; and then it waits at the next one. */
  #dig(begun: number, now: number, k = 0, last: [number, number] | null = null): void {
    if (!this.#isShowing || !this.#section.isConnected) {
      this.#section.classList.remove('asks')
      this.#hand.hidden = this.#cursor === null
      return
    }
    const { clientWidth, clientHeight } = this.#canvas, time = (now - begun - before) / cut
    const x = (9.4 + 6.2 * k) * this.size, y = clientHeight - (k % 2 === 0 ? 17.5 : 5.4) * this.size
    const way = this.size * 1.4 * (Math.max(0, Math.min(1, time)) - 0.5) * 2
    const at: [number, number] = [x + way, k % 2 === 0 ? y : y + way] // a stem at a slant, so that its cap slides off the stump
    if (k === shown) { // whoever has a narrow screen must walk there
      const isSeen = x < clientWidth - 3 * this.size
      if (isSeen) this.#show(x + 1.4 * this.size * Math.sin(now / 300), y)
      this.#hand.hidden = !isSeen
      this.#section.classList.add('asks')
      requestAnimationFrame((later) => this.#dig(begun, later, k))
      return
    }
    this.#show(...at)
    if (time > 0 && last === null) this.#begin()
    if (time > 0) this.#touch(...(last ?? at), ...at)
    const isCut = time >= 1, next = k + 1
    if (isCut) this.#hand.hidden = true
    requestAnimationFrame((later) => this.#dig(isCut ? later + pause - before : begun, later, isCut ? next : k, time > 0 && !isCut ? at : null))
  }

  /** Again and again. */
  #race(begun: number): void {
    const race = new Race()
    let steps = 0, ended: number | null = null
    if (wantsCalm()) while (!race.isOver) race.step()
    const frame = (now: number) => {
      if (!this.#section.isConnected || (ended !== null && now - ended > wait && !wantsCalm())) {
        race.free()
        if (this.#section.isConnected) this.#race(now)
        return
      }
      for (const due = Math.min(steps + 4, Math.floor((now - begun) / 1000 / stepTime)); steps < due; ++steps) race.step()
      if (race.isOver) ended ??= now
      const ratio = Math.min(2, devicePixelRatio), { clientWidth: width, clientHeight: height } = this.#strip
      if (this.#strip.width !== width * ratio || this.#strip.height !== height * ratio) Object.assign(this.#strip, { width: width * ratio, height: height * ratio })
      const c = this.#strip.getContext('2d')!
      c.setTransform(ratio, 0, 0, ratio, 0, 0)
      drawLanes(c, race, width, height)
      requestAnimationFrame(frame)
    }
    requestAnimationFrame(frame)
  }
}
