// What one sees first, and whenever the page's address is opened: the digger of examples/digger.js, what there is to win in
// it (goal.ts), its source beside it, and two wheels below. A hand shows how one digs until somebody does. What was done is
// there again the next time.
import type { GroundPicture } from 'localgridseg/draw'
import type { Ground } from 'localgridseg/planck'
import { digger, land, stone } from '../../examples/digger.js'
import { cavern as wide, cavernAt, type Winnings } from './crystals.js'
import { type Counts, Deeds } from './deeds.js'
import { element, onClick } from './dom.js'
import { Goal } from './goal.js'
import { keepDigger, keptDigger } from './keep.js'
import { Strip } from './race/strip.js'
import { copied, pack, unpack } from './share.js'
import { wantsCalm } from './theme.js'

const high = 24 // cells, of the land
const before = 900 // milliseconds until the hand digs
const cut = 500 // that it takes for a stem
const pause = 1700 // until it asks who looks on to cut the next one
const stems = [[7, 16.4], [14, 17.4]] // where the hand cuts, and where it asks: x, y in cells
const isHeld = 350 // milliseconds: then going back runs on
const tapWalks = 0.8 // of what is seen
const keepsEach = 1000 // milliseconds

interface Kept extends Counts {
  readonly ground: string // packed
  readonly x: number
  readonly winnings: Winnings
}

export class Digger {
  ground: Ground | null = null
  goal: Goal | null = null
  picture: GroundPicture | null = null
  #deeds: Deeds | null = null
  readonly #section = element('digger')
  readonly #view = element('dig-pane')
  readonly #canvas = element<HTMLCanvasElement>('dig')
  readonly #hand = element('dig-hand')
  #isShowing = !wantsCalm() // the hand digs
  #isOwn = false // somebody was here, and not only the hand
  #kept = '' // what of it is kept
  #cursor: [number, number] | null = null // of the keyboard, in pixels
  #isPlacing = false // a boulder
  #holding = 0 // a timer
  #walking = 0 // a frame

  get size(): number {
    return this.picture!.size
  }

  async open(): Promise<void> {
    const kept = readKept(), bytes = kept === null ? null : await unpack(kept.ground).catch(() => null)
    const { ground, picture } = await digger(this.#canvas)
    this.ground = ground
    this.picture = picture
    const deeds = (this.#deeds = new Deeds(ground, picture, this.#canvas))
    this.goal = new Goal(this.#canvas, ground, picture, deeds)
    this.#fit()
    const cells = this.#canvas.clientWidth / this.size
    picture.x = cells > wide - 6 ? (wide - cells) / 2 : 2 // all of the first cavern, where there is room
    if (kept !== null && bytes !== null) this.#restore(bytes, kept)
    new ResizeObserver(() => this.#fit()).observe(this.#canvas)
    this.#listen()
    onClick('dig-more', () => { location.hash = '#tools' })
    requestAnimationFrame((now) => this.#frame(now))
    requestAnimationFrame((now) => this.#dig(now, now))
    requestAnimationFrame(() => requestAnimationFrame(() => { // once the ground is seen
      const strip = new Strip()
      this.goal!.onFill = (count) => { strip.load = count }
    }))
    setInterval(() => void this.#keep(), keepsEach)
    const source = await (await fetch('digger.js')).text()
    element('dig-code').querySelector('code')!.textContent = source
    onClick('dig-copy', () => void copied(source))
  }

  /** For all tools. */
  async leave(): Promise<void> {
    await this.#keep()
    this.#section.remove()
    document.documentElement.classList.remove('first')
  }

  /** The land fills what is left between the bars; behind these is rock. */
  #fit(): void {
    const { clientHeight } = this.#canvas, picture = this.picture!
    if (clientHeight === 0) return
    const buttons = element('dig-buttons'), above = element('dig-top').offsetHeight + 10
    const below = buttons.offsetTop > clientHeight / 2 ? buttons.offsetHeight + 10 : 4
    picture.size = Math.max(6, (clientHeight - above - below) / high)
    picture.y = -below / picture.size
  }

  // --- What is kept

  #restore(bytes: Uint8Array, { x, winnings, ...counts }: Kept): void {
    try {
      this.ground!.load(bytes)
    } catch {
      return // of another version
    }
    this.picture!.x = x
    this.#deeds!.counts = counts
    this.goal!.restore(winnings)
    this.#isShowing = false
    this.#isOwn = true
  }

  async #keep(): Promise<void> {
    const { ground, picture, goal } = this
    if (!this.#isOwn || !this.#section.isConnected || this.#deeds!.goesBack) return
    const { counts } = this.#deeds!, { winnings } = goal!.crystals, { x } = picture!
    const seen = JSON.stringify([this.#deeds!.strokes, ground!.rocks().length, counts, winnings, Math.round(x)])
    if (seen === this.#kept) return
    this.#kept = seen
    keepDigger(JSON.stringify({ ground: await pack(ground!.save()), x, winnings, ...counts } satisfies Kept))
  }

  // --- Pointer and keys

  #listen(): void {
    for (const event of ['pointerdown', 'keydown']) addEventListener(event, ({ isTrusted }) => {
      if (!isTrusted) return
      if (this.#isShowing) this.#touch('pointerup', 0, 0) // the hand lets go
      this.#isShowing = false
      this.#isOwn = true
    }, { capture: true })
    this.#onHold('dig-back', () => this.#press(), () => this.#release())
    for (const [id, key] of [['dig-left', 'a'], ['dig-right', 'd']]) this.#onWalk(id, key)
    onClick('dig-again', () => this.#again())
    onClick('dig-boulder', () => this.goal!.canPay ? this.#place(!this.#isPlacing) : this.goal!.tellPrice())
    // A tap takes one dig back; digger.js, which goes on for as long as the key is down, hears of it later.
    const isBack = ({ key, isTrusted }: KeyboardEvent) => isTrusted && key.toLowerCase() === 'z' && this.#section.isConnected
    addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.#place(false)
      if (!isBack(event)) return
      event.stopImmediatePropagation()
      if (!event.repeat) this.#press()
    }, { capture: true })
    addEventListener('keyup', (event) => { if (isBack(event)) this.#release() }, { capture: true })
    addEventListener('blur', () => this.#release())
    for (const type of ['pointerdown', 'pointermove'] as const)
      this.#view.addEventListener(type, (event) => { if (event.target === this.#canvas) this.#onPointer(event) }, { capture: true })
    this.#canvas.addEventListener('focus', () => {
      if (this.#canvas.matches(':focus-visible')) this.#show(...(this.#cursor ??= this.#aim()))
    })
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }
    document.addEventListener('keydown', (event) => {
      if (!this.#section.isConnected || (event.target !== this.#canvas && event.target !== document.body)) return
      const by = event.shiftKey ? arrows[event.key] : undefined
      if (by === undefined && event.key !== 'Enter' && event.key !== ' ') return
      event.preventDefault()
      event.stopPropagation() // else the arrow walked, too
      const [x, y] = this.#cursor ?? this.#aim(), step = this.size / 2
      this.#cursor = by === undefined ? [x, y] : [x + by[0] * step, y + by[1] * step]
      this.#show(...this.#cursor)
      if (by !== undefined) return
      this.#touch('pointerdown', ...this.#cursor)
      this.#touch('pointerup', ...this.#cursor)
    })
  }

  /** Where the cursor begins: at what holds the crystal that is nearest to the middle. */
  #aim(): [number, number] {
    const { clientWidth, clientHeight } = this.#canvas, { picture, size } = this
    const [x, y] = this.goal!.aim(picture!.at({ offsetX: clientWidth / 2, offsetY: clientHeight / 2 }), clientWidth / size / 2 - 1)
    return [(x - picture!.x) * size, clientHeight - (y - picture!.y) * size]
  }

  #onPointer(event: PointerEvent): void {
    const at = this.picture!.at(event), deeds = this.#deeds!
    deeds.at = at[0]
    if (event.isTrusted && this.#isPlacing) this.#show(event.offsetX, event.offsetY)
    else if (event.isTrusted && event.type === 'pointermove' && this.#cursor !== null) {
      this.#cursor = null // whoever points needs no cursor
      this.#hand.hidden = true
    }
    if (this.#isPlacing) {
      event.stopPropagation() // nothing is dug
      if (event.type === 'pointerdown') this.#drop(at)
      return
    }
    if (event.type === 'pointerdown') deeds.begin()
    if (event.buttons !== 0 && deeds.begun > 0) deeds.strike(at)
  }

  #onHold(id: string, begin: () => void, end: () => void): void {
    const button = element(id), isUse = ({ key }: KeyboardEvent) => key === 'Enter' || key === ' '
    let isDown = false // the focus goes later, when another button may be down
    const press = () => { isDown = true; begin() }, letGo = () => { if (isDown) end(); isDown = false }
    button.addEventListener('pointerdown', press)
    for (const type of ['pointerup', 'pointerleave', 'pointercancel', 'blur']) button.addEventListener(type, letGo)
    button.addEventListener('keydown', (event) => { if (isUse(event) && !event.repeat) press() })
    button.addEventListener('keyup', (event) => { if (isUse(event)) letGo() })
  }

  /** A tap walks to another view; whoever holds the button walks until it is let go. */
  #onWalk(id: string, key: string): void {
    let from = 0
    const stop = () => {
      cancelAnimationFrame(this.#walking)
      if (Math.abs(this.picture!.x - from) * this.size >= tapWalks * this.#canvas.clientWidth) say('keyup', key)
      else this.#walking = requestAnimationFrame(stop)
    }
    this.#onHold(id, () => {
      cancelAnimationFrame(this.#walking)
      from = this.picture!.x
      say('keydown', key)
    }, stop)
  }

  #press(): void {
    cancelAnimationFrame(this.#walking)
    this.#release()
    this.#deeds!.rewind()
    this.#holding = window.setTimeout(() => say('keydown', 'z'), isHeld)
  }

  #release(): void {
    clearTimeout(this.#holding)
    say('keyup', 'z')
  }

  #frame(now: number, last = now): void {
    if (!this.#section.isConnected) return
    this.#deeds!.step((now - last) / 1000)
    this.#section.classList.toggle('rewinds', this.#deeds!.goesBack)
    if (this.#isPlacing && !this.goal!.canPay) this.#place(false) // the gold for it was taken back
    requestAnimationFrame((next) => this.#frame(next, now))
  }

  // --- What gold buys, and another try

  #place(isPlacing: boolean): void {
    this.#isPlacing = isPlacing
    this.#section.classList.toggle('places', isPlacing)
    this.goal!.ask(isPlacing ? 'Tap where the boulder should fall.' : null)
    if (isPlacing) this.#canvas.focus({ preventScroll: true }) // so that keys choose the place
    if (!isPlacing) this.#hand.hidden = this.#cursor === null
    else if (this.#cursor === null) this.#show(this.#canvas.clientWidth / 2, this.#canvas.clientHeight / 2)
  }

  /** A boulder, where there is room for it. */
  #drop([x, y]: readonly [number, number]): void {
    if (!this.goal!.canPay) return this.#place(false)
    const ground = this.ground!, ring = stone.map((v, n) => v + (n % 2 === 0 ? x : y))
    const isFree = [0.4, 1.1].every((part) => stone.every((_, n) =>
      n % 2 === 1 || ground.world.at(x + part * stone[n], y + part * stone[n + 1]).where === 'outside'))
    if (!isFree || y < 3 || y > high - 3) return this.goal!.say([x, y], 'no room here')
    this.#deeds!.begin()
    ground.edit((world) => world.paint({ rings: [ring] }, 6))
    this.goal!.pay(this.#deeds!.strokes)
    this.#place(false)
  }

  /** The cavern that is counted begins anew. */
  #again(): void {
    const ground = this.ground!, cavern = this.goal!.here, i0 = wide * cavern, cells = { i0, j0: 0, i1: i0 + wide - 1, j1: 31 }
    for (let k = 0; k < 100 && !ground.window(cells); ++k);
    for (const { body, x } of ground.rocks()) {
      if (body === null || cavernAt(x) !== cavern) continue
      ground.forget(body)
      body.getWorld().destroyBody(body)
    }
    ground.edit((world) => {
      world.removeMany(world.polygons(cells).map(({ id }) => id))
      for (const at of [i0, i0 + wide / 2]) land(world, { i0: at, j0: 0 })
    })
    this.#deeds!.renew(cavern)
    this.goal!.renew()
  }

  // --- The hand

  #show(x: number, y: number): void {
    this.#hand.hidden = false
    Object.assign(this.#hand.style, { left: `${x}px`, top: `${y}px` })
  }

  /** As a finger would. */
  #touch(type: 'pointerdown' | 'pointermove' | 'pointerup', x: number, y: number): void {
    const { left, top } = this.#canvas.getBoundingClientRect(), at = { pointerId: -1, buttons: 1, clientX: left + x, clientY: top + y }
    const to = type === 'pointerup' ? window : this.#canvas
    to.dispatchEvent(new PointerEvent(type, at))
  }

  /** What the first crystal hangs on; and then it waits at the next one. */
  #dig(begun: number, now: number, k = 0, isDown = false): void {
    if (!this.#isShowing || !this.#section.isConnected) {
      this.#section.classList.remove('asks')
      this.#hand.hidden = this.#cursor === null
      return
    }
    const { clientWidth, clientHeight } = this.#canvas, time = (now - begun - before) / cut, [cx, cy] = stems[k]
    const x = (cx - this.picture!.x) * this.size, y = clientHeight - (cy - this.picture!.y) * this.size, half = 1.4 * this.size
    if (k > 0) { // whoever has a narrow screen must walk there
      const isSeen = x > 0 && x < clientWidth - this.size, isTime = time >= 0
      if (isSeen && isTime) this.#show(x + half * Math.sin(now / 300), y)
      this.#hand.hidden = !isSeen || !isTime
      this.#section.classList.toggle('asks', isTime)
      requestAnimationFrame((later) => this.#dig(begun, later, k))
      return
    }
    const at = x + half * (2 * Math.max(0, Math.min(1, time)) - 1), isCut = time >= 1
    this.#show(at, y)
    if (time > 0 && !isDown) this.#touch('pointerdown', x - half, y)
    if (time > 0) this.#touch('pointermove', at, y)
    if (isCut) this.#touch('pointerup', at, y)
    this.#hand.hidden = isCut
    requestAnimationFrame((later) => this.#dig(isCut ? later + pause - before : begun, later, isCut ? 1 : 0, time > 0))
  }
}

function readKept(): Kept | null {
  try {
    return JSON.parse(keptDigger() ?? 'null') as Kept | null
  } catch {
    return null
  }
}

function say(type: string, key: string): void {
  dispatchEvent(new KeyboardEvent(type, { key }))
}
