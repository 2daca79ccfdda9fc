// What one sees first: the digger of examples/digger.js, what there is to win in it (goal.ts), its source beside it, and two
// wheels that race below. A hand digs until somebody else does.
import type { GroundPicture } from 'localgridseg/draw'
import type { Ground } from 'localgridseg/planck'
import { digger } from '../../examples/digger.js'
import { element, onClick } from './dom.js'
import { cavernAt } from './crystals.js'
import { Goal } from './goal.js'
import { Race } from './race/race.js'
import { drawLanes } from './race/view.js'
import { copied, holdsGround } from './share.js'
import { stepTime } from './side.js'
import { wantsCalm } from './theme.js'

const high = 24 // cells, of the land
const before = 900 // milliseconds until the hand digs
const cut = 500 // that it takes for a stem
const pause = 1700 // between two stems
const shown = 2 // things that it cuts; then it asks who looks on to cut the next
const wait = 1500 // between two races
const stems = [[7, 16.4], [11.8, 6.4], [16.6, 13.5]] // where the hand cuts: x, y in cells
const isHeld = 350 // milliseconds: then going back runs on
const quick = 9 // how fast one goes back: such a part of the way in a second, at first
const margin = 0.2 // of the width: what is taken back is nearer to the middle

export class Digger {
  static readonly address = '#digger'
  ground: Ground | null = null
  goal: Goal | null = null
  size = 0 // pixels of a cell
  picture: GroundPicture | null = null
  readonly #section = element('digger')
  readonly #canvas = element<HTMLCanvasElement>('dig')
  readonly #hand = element('dig-hand')
  readonly #strip = element('dig-race').querySelector('canvas')!
  #isShowing = !wantsCalm() // the hand digs
  #cursor: [number, number] | null = null // of the keyboard, in pixels
  #at = 0 // where the last stroke was made, as x
  readonly #places: number[] = [] // of all strokes that can be taken back
  readonly #begun: number[] = [] // how many there were when each dig began
  #to: number | null = null // so many strokes stay: it goes back
  #wentBack = -Infinity // when
  #holding = 0 // a timer

  /** `onLeave`: for all tools. The digger is gone then. */
  async open(onLeave: () => Promise<void>): Promise<void> {
    const leave = async () => {
      if (location.hash === Digger.address) history.replaceState(null, '', location.pathname + location.search)
      this.#section.remove()
      document.documentElement.classList.remove('first')
      await onLeave()
    }
    this.size = this.#canvas.clientHeight / high
    const { ground, picture } = await digger(this.#canvas, this.size)
    this.ground = ground
    onClick('dig-more', () => void leave())
    addEventListener('hashchange', () => { if (this.#section.isConnected && holdsGround(location.hash)) void leave() })
    this.#count(ground)
    this.picture = picture
    const digsIn = (cavern: number) => this.#begun.filter((k) => k < this.#places.length && cavernAt(this.#places[k]) === cavern).length
    const strokes = () => this.#places.length, digs = () => this.#begun.length, goesBack = () => this.#goesBack
    const deeds = { get strokes() { return strokes() }, get digs() { return digs() }, get goesBack() { return goesBack() }, digsIn }
    this.goal = new Goal(this.#canvas, ground, picture, deeds)
    this.#listen()
    requestAnimationFrame((now) => this.#goBack(now))
    requestAnimationFrame((now) => this.#dig(now, now))
    requestAnimationFrame(() => requestAnimationFrame((now) => this.#race(now))) // once the ground is seen
    const source = await (await fetch('digger.js')).text()
    element('dig-code').querySelector('code')!.textContent = source
    onClick('dig-copy', () => void copied(source))
  }

  #listen(): void {
    for (const event of ['pointerdown', 'keydown']) addEventListener(event, ({ isTrusted }) => { if (isTrusted) this.#isShowing = false }, { capture: true })
    this.#onHold('dig-back', () => this.#press(), () => this.#release())
    for (const [id, key] of [['dig-left', 'a'], ['dig-right', 'd']]) this.#onHold(id, () => say('keydown', key), () => say('keyup', key))
    // A tap takes one dig back; digger.js, which goes on for as long as the key is down, hears of it later.
    const isBack = ({ key, isTrusted }: KeyboardEvent) => isTrusted && key.toLowerCase() === 'z' && this.#section.isConnected
    addEventListener('keydown', (event) => {
      if (!isBack(event)) return
      event.stopImmediatePropagation()
      if (!event.repeat) this.#press()
    }, { capture: true })
    addEventListener('keyup', (event) => { if (isBack(event)) this.#release() }, { capture: true })
    addEventListener('blur', () => this.#release())
    for (const type of ['pointerdown', 'pointermove'] as const)
      this.#canvas.addEventListener(type, (event) => { this.#at = this.picture!.at(event)[0] }, { capture: true })
    this.#canvas.addEventListener('pointerdown', ({ isTrusted }) => { if (isTrusted) this.#begin() }, { capture: true })
    this.#canvas.addEventListener('pointermove', ({ isTrusted }) => {
      if (!isTrusted || this.#cursor === null) return
      this.#cursor = null // whoever points needs no cursor
      this.#hand.hidden = true
    })
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

  #onHold(id: string, begin: () => void, end: () => void): void {
    const button = element(id), isUse = ({ key }: KeyboardEvent) => key === 'Enter' || key === ' '
    button.addEventListener('pointerdown', begin)
    for (const type of ['pointerup', 'pointerleave', 'pointercancel', 'blur']) button.addEventListener(type, end)
    button.addEventListener('keydown', (event) => { if (isUse(event) && !event.repeat) begin() })
    button.addEventListener('keyup', (event) => { if (isUse(event)) end() })
  }

  // A dig has a stroke for each move of the pointer. One goes back where it is seen: until then the picture moves.
  #count(ground: Ground): void {
    const edit = ground.edit.bind(ground), undo = ground.undo.bind(ground)
    ground.edit = (edits) => {
      const result = edit(edits)
      this.#places.push(this.#at)
      return result
    }
    ground.undo = () => {
      if (!ground.canUndo) return false
      const isSeen = this.#isSeen(this.#places.at(-1)!)
      this.#wentBack = performance.now()
      if (!isSeen) return false
      this.#places.pop()
      return undo()
    }
  }

  get #goesBack(): boolean {
    return this.#to !== null || performance.now() - this.#wentBack < 150
  }

  /** A part of the way, if it is not. */
  #isSeen(at: number): boolean {
    const picture = this.picture!, wide = this.#canvas.clientWidth / picture.size
    const part = 1 - Math.exp((-quick * Math.min(50, performance.now() - this.#wentBack)) / 1000)
    const off = Math.max(0, picture.x + margin * wide - at) - Math.max(0, at - picture.x - (1 - margin) * wide)
    if (Math.abs(off) < 0.5) return true
    picture.x -= wantsCalm() ? off : Math.sign(off) * Math.min(Math.abs(off), part * (2 + Math.abs(off)))
    return false
  }

  #begin(): void {
    this.#to = null
    this.#begun.push(this.#places.length)
  }

  #press(): void {
    this.#release()
    this.#rewind()
    this.#holding = window.setTimeout(() => say('keydown', 'z'), isHeld)
  }

  #release(): void {
    clearTimeout(this.#holding)
    say('keyup', 'z')
  }

  /** To before the last dig. */
  #rewind(): void {
    while (this.#begun.length > 0) {
      const strokes = this.#begun.pop()!
      if (strokes >= this.#places.length) continue // it is taken back already
      this.#to = Math.min(strokes, this.#to ?? strokes)
      return
    }
  }

  #goBack(now = 0, last = now): void {
    if (!this.#section.isConnected) return
    if (this.#to !== null) {
      let left = Math.ceil((this.#places.length - this.#to) * Math.min(1, (quick * (now - last)) / 1000))
      for (; left > 0; --left) if (!this.ground!.undo()) break
      if (this.#places.length <= this.#to || !this.ground!.canUndo) this.#to = null
    }
    this.#section.classList.toggle('rewinds', this.#goesBack)
    requestAnimationFrame((next) => this.#goBack(next, now))
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
    const [cx, cy] = stems[k], x = (cx - this.picture!.x) * this.size, y = clientHeight - cy * this.size
    const after = (part: number): [number, number] => { // a stem at a slant, so that its cap slides off the stump
      const way = this.size * 1.4 * (2 * part - 1)
      return [x + way, k % 2 === 0 ? y : y + way]
    }
    const at = after(Math.max(0, Math.min(1, time)))
    if (k === shown) { // whoever has a narrow screen must walk there
      const isSeen = x > 0 && x < clientWidth - this.size
      if (isSeen) this.#show(x + 1.4 * this.size * Math.sin(now / 300), y)
      this.#hand.hidden = !isSeen
      this.#section.classList.add('asks')
      requestAnimationFrame((later) => this.#dig(begun, later, k))
      return
    }
    this.#show(...at)
    if (time > 0 && last === null) this.#begin()
    if (time > 0) this.#touch(...(last ?? after(0)), ...at)
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

function say(type: string, key: string): void {
  dispatchEvent(new KeyboardEvent(type, { key }))
}
