// What there is to win in the digger. Crystals burst that fall far, or that a boulder falls on: they fly to their places, and
// their cavern gets lighter. It is to be done with few digs. Gold that is dug out buys boulders. Undo takes all of it back.
// Whatever falls throws dust, and shakes the picture.
import type { GroundPicture } from 'localgridseg/draw'
import type { CellRect } from 'localgridseg/islands'
import type { Ground } from 'localgridseg/planck'
import { colours } from '../../examples/digger.js'
import { Cave } from './cave.js'
import { cavernAt, Crystals, gold, type Hit, large, type Piece, shine, type Winnings } from './crystals.js'
import type { Deeds } from './deeds.js'
import { element } from './dom.js'
import { type Hold, holdOf } from './hold.js'
import { Sound } from './sound.js'
import { Sparks } from './sparks.js'
import { wantsCalm } from './theme.js'

const gravity = 20 // cells per second squared, as in digger.js
const shards = 7 // of a crystal that fly to its place
const crumbColours: Readonly<Record<number, string>> = { 1: '#8d6244', 2: '#d8cfe2', 3: shine[3], 4: '#d95d4a', 5: shine[5], 6: '#a79fac' }
const dustColour = '#d9c3a5'
const feast = 2.5 // seconds, when all places are full
const day = 2 // as the cave counts light
const price = 3 // pieces of gold, of a boulder
const told = 7 // seconds, of what is told once
const near = 9 // cells: what hangs so near may be cut
const thinner = 0.1 // cells: so much is cut away
// Of the caverns in turn: what is told, and with how many digs it is to be done.
const tasks = [['Cut crystals loose. A long fall bursts them.', 7], ['Low crystals: drop boulders on them.', 9], ['Cut the ropes.', 9]] as const
const taskOf = (cavern: number) => tasks[((cavern % tasks.length) + tasks.length) % tasks.length]
const walkOn = 'All five! Go right to the next cavern, or try with fewer digs.'
const tooLow = 'That fall was too short. Dig a pit below, or drop a boulder on it.'
const goldBuys = 'Gold! Three pieces buy a boulder.', canBuy = 'Enough gold: press Boulder.', ofGold = [goldBuys, canBuy], noGold = '3 gold needed: dig the yellow diamonds.'
const isHeld = 'Not through yet: cut at the ring.'

export class Goal {
  readonly crystals: Crystals
  readonly #canvas: HTMLCanvasElement
  readonly #ground: Ground
  readonly #picture: GroundPicture
  readonly #deeds: Deeds
  readonly #cave: Cave
  readonly #sparks = new Sparks()
  readonly #sound = new Sound()
  readonly #lead = element('dig-lead').querySelector('strong')!
  readonly #places = [...element('dig-places').children] as HTMLElement[]
  readonly #gold = element('dig-gold').nextElementSibling as HTMLElement
  #dug: { readonly at: readonly [number, number]; readonly cells: CellRect; gold: number } | null = null
  #before: readonly (Piece & Hold)[] = [] // what hung near, when this dig began
  #marked = 0 // strokes that there were when rings were put
  readonly #boulder = element<HTMLButtonElement>('dig-boulder')
  readonly #score = element('dig-score')
  #seen = '' // of the score, and of gold
  #asks: string | null = null // is told as long as it is asked for
  #news = { text: '', left: 0 } // for so many seconds
  readonly #arrived = new Map<number, number>() // crystals of a cavern that are in their places
  /** The cavern that is counted: where one dug, or walked to. */
  here = 0
  /** The crystals of this cavern that are in their places, when that changes. */
  onFill: (count: number) => void = () => {}
  #x = 0 // where the picture was
  #feast = 0 // seconds that are left of it
  #row = { digs: 0, count: 0 } // crystals that broke after the last dig
  #shake = 0 // pixels

  constructor(canvas: HTMLCanvasElement, ground: Ground, picture: GroundPicture, deeds: Deeds) {
    this.#canvas = canvas
    this.#ground = ground
    this.#picture = picture
    this.#deeds = deeds
    this.crystals = new Crystals(ground)
    this.#cave = new Cave(canvas, element<HTMLCanvasElement>('dig-sky'), picture, this.crystals, colours, gravity)
    for (const type of ['pointerdown', 'pointermove'] as const) {
      canvas.addEventListener(type, (event) => this.#beforeDig(event), { capture: true })
      canvas.addEventListener(type, () => this.#afterDig()) // digger.js has dug meanwhile
    }
    addEventListener('pointerup', () => this.#endDig())
    const switches = element<HTMLInputElement>('dig-sound')
    switches.addEventListener('change', () => { this.#sound.isOn = switches.checked })
    requestAnimationFrame((now) => this.#frame(now, now - 16))
  }

  /** What was won at another visit: it is light there at once. */
  restore(winnings: Winnings): void {
    this.crystals.winnings = winnings
    for (const { cavern } of winnings.won) {
      const count = this.crystals.count(cavern)
      this.#arrived.set(cavern, count)
      this.#cave.setLight(cavern, this.#lightFor(count))
    }
    this.#fill()
  }

  /** The cavern begins anew. */
  renew(): void {
    this.crystals.renew(this.here)
    this.#feast = 0
    this.#news.left = 0
  }

  /** What is asked for now, if anything is. */
  ask(text: string | null): void {
    this.#asks = text
  }

  say(at: readonly [number, number], text: string): void {
    this.#sparks.say(at, text)
  }

  /** What holds the crystal that is nearest to a place; if none is so near, that place. */
  aim([x, y]: readonly [number, number], far: number): readonly [number, number] {
    const off = ({ middle }: Piece) => Math.abs(middle[0] - x)
    const [next] = this.crystals.near([x, y], far).filter(({ block }) => block === large).sort((a, b) => off(a) - off(b))
    return next === undefined ? [x, y] : (holdOf(this.#ground.world, next.middle, large).places[0] ?? [x, y])
  }

  /** For a boulder, which was the last of so many strokes. */
  pay(strokes: number): void {
    this.crystals.spend(price, strokes)
  }

  /** That there is none for a boulder. */
  tellPrice(): void {
    this.#news = { text: noGold, left: told }
  }

  get canPay(): boolean {
    this.crystals.takeBack(this.#deeds.strokes)
    return this.crystals.gold >= price
  }

  get rings(): readonly (readonly [number, number])[] {
    return this.#sparks.marks
  }

  #frame(now: number, last: number): void {
    if (!this.#canvas.isConnected) return
    const time = Math.min(0.05, (now - last) / 1000)
    const { strokes, goesBack } = this.#deeds
    for (const hit of this.crystals.step(time, strokes, gravity, goesBack)) this.#hit(hit)
    this.#sparks.step(time)
    if (strokes !== this.#marked) this.#sparks.marks = []
    this.#settle(time)
    this.#lookAround()
    for (const [cavern, arrived] of this.#arrived) {
      const light = this.#cave.lightOf(cavern)
      this.#cave.setLight(cavern, light + (this.#lightFor(arrived) - light) * Math.min(1, 2 * time))
    }
    this.#tell(time)
    this.#cave.draw(now)
    const c = this.#canvas.getContext('2d')!, { x, y, size } = this.#picture, scale = (size * this.#canvas.width) / this.#canvas.clientWidth
    c.save()
    c.setTransform(scale, 0, 0, -scale, -scale * x, this.#canvas.height + scale * y)
    this.#sparks.draw(c)
    c.restore()
    requestAnimationFrame((next) => this.#frame(next, now))
  }

  #lightFor(arrived: number): number {
    return Math.min(day, (day * arrived) / this.#places.length)
  }

  /** Crumbs of what is there now. */
  #beforeDig(event: PointerEvent): void {
    if (event.buttons === 0) return
    const [x, y] = this.#picture.at(event), [fx, fy] = event.type === 'pointermove' && this.#dug !== null ? this.#dug.at : [x, y]
    const cells = { i0: Math.floor(Math.min(x, fx) - 1), j0: Math.floor(Math.min(y, fy) - 1), i1: Math.floor(Math.max(x, fx) + 1), j1: Math.floor(Math.max(y, fy) + 1) }
    this.#goTo(cavernAt(x))
    if (event.type === 'pointerdown') this.#before = this.crystals.near([x, y], near).map((each) => ({ ...each, ...holdOf(this.#ground.world, each.middle, each.block) }))
    this.#dug = { at: [x, y], cells, gold: this.crystals.goldIn(cells) }
    for (let k = 0; k < 6; ++k) {
      const at = [x + 0.55 * Math.cos(k), y + 0.55 * Math.sin(k)] as const, spot = this.#ground.world.at(...at)
      if (spot.where === 'outside') continue
      this.#sparks.crumbs(at, 1, crumbColours[spot.block] ?? dustColour, 5)
      this.#sound.scrape()
    }
  }

  #afterDig(): void {
    if (this.#dug === null) return
    const { at, cells, gold: before } = this.#dug, count = this.crystals.gold
    this.crystals.noteDug(before - this.crystals.goldIn(cells), this.#deeds.strokes)
    this.#dug.gold = 0
    for (let k = count; k < this.crystals.gold; ++k) this.#win(at, gold)
  }

  /** Rings where something still hangs that this dig has only made thinner, or cut into. */
  #endDig(): void {
    const { world } = this.#ground, isGone = ([x, y]: readonly [number, number]) => world.at(x, y).where === 'outside'
    const left = this.#before.map((before) => ({ before, ...holdOf(world, before.middle, before.block) }))
      .filter(({ before, width }) => width > 0 && (width < before.width - thinner || before.points.some(isGone)))
    this.#before = []
    if (left.length === 0) return
    this.#sparks.marks = left.flatMap(({ places }) => places)
    this.#marked = this.#deeds.strokes
    if (this.#news.left <= 0 || !ofGold.includes(this.#news.text)) this.#news = { text: isHeld, left: told }
  }

  #win(at: readonly [number, number], block: number): void {
    if (block === gold && this.crystals.gold <= price) this.#news = { text: this.crystals.gold < price ? goldBuys : canBuy, left: told }
    this.#sparks.crumbs(at, block === large ? 26 : 10, shine[block], block === large ? 11 : 8, 0.3)
    const cavern = cavernAt(at[0]), nth = this.crystals.count(cavern) - 1
    const to = () => this.#inCells(block === large ? this.#places[nth % this.#places.length] : this.#gold)
    for (let k = 0; k < (block === large ? shards : 2); ++k)
      this.#sparks.fly([at[0], at[1]], to, shine[block], 0.75 + 0.06 * k, () => { if (k === 0) block === gold ? this.#sound.chime(this.crystals.gold) : this.#arrive(cavern) })
  }

  #hit({ at, area, block, speed, what }: Hit): void {
    const hard = Math.min(1, (speed * Math.sqrt(area)) / 50)
    this.#sound.thud(hard)
    if (!wantsCalm()) this.#shake = Math.max(this.#shake, 7 * hard)
    const below: [number, number] = [at[0], at[1] - 0.45 * Math.sqrt(area)]
    this.#sparks.dust(below, 6 + Math.round(14 * hard), 3 + 9 * hard, what === 'is thrown up' ? crumbColours[4] : dustColour)
    this.#sparks.crumbs(below, Math.round(24 * hard), crumbColours[block] ?? dustColour, 6 + 5 * hard, 0.2 + 0.16 * hard)
    if (what === 'is thrown up') this.#sparks.say(at, 'boing')
    if (what === 'stays whole') {
      this.#sparks.say(at, 'too low')
      this.#news = { text: tooLow, left: told }
    }
    if (what !== 'burst') return
    this.#win(at, block)
    if (block !== large) return
    const digs = this.#deeds.begun
    this.#row = { digs, count: digs === this.#row.digs ? this.#row.count + 1 : 1 }
    this.#sparks.say(at, this.#row.count > 1 ? `${this.#row.count} with one dig!` : '+1')
  }

  #arrive(cavern: number): void {
    const arrived = this.#inPlace(cavern)
    this.#sound.chime(arrived)
    if (arrived >= this.crystals.count(cavern)) return // it was undone on its way
    this.#arrived.set(cavern, arrived + 1)
    if (cavern !== this.here) return
    this.#fill()
    if (arrived + 1 !== this.#places.length) return
    this.#feast = feast
    const digs = this.#deeds.digsIn(cavern), best = this.#deeds.best.get(cavern) ?? Infinity
    this.#deeds.best.set(cavern, Math.min(best, digs))
    this.#news = { text: `Daybreak after ${counted(digs)}${digs < best && best < Infinity ? ': your best' : ''}!`, left: feast }
  }

  #inPlace(cavern: number): number {
    return this.#arrived.get(cavern) ?? 0
  }

  /** What time does to the shake, to a feast, and to what was undone. */
  #settle(time: number): void {
    this.#shake *= Math.exp(-9 * time)
    const shift = () => (this.#shake < 0.3 ? 0 : this.#shake * (2 * Math.random() - 1))
    this.#canvas.style.translate = `${shift()}px ${shift()}px`
    for (const [cavern, arrived] of this.#arrived) {
      const count = this.crystals.count(cavern)
      if (arrived <= count) continue
      this.#arrived.set(cavern, count)
      this.#fill()
    }
    if (this.#feast <= 0) return
    const { cells } = this.#picture, before = Math.ceil(this.#feast * 8)
    this.#feast -= time
    if (Math.ceil(this.#feast * 8) < before && !wantsCalm()) {
      const at: [number, number] = [cells.i0 + (cells.i1 - cells.i0) * Math.random(), 9 + 9 * Math.random()]
      this.#sparks.crumbs(at, 24, Object.values(shine)[before % 2], 9, 0.26)
      this.#sound.chime(before)
    }
  }

  #goTo(cavern: number): void {
    if (cavern === this.here) return
    this.here = cavern
    this.#feast = 0
    this.#news.left = 0
    this.#fill()
  }

  /** Where one walked, and whether there is nothing to do but to walk. */
  #lookAround(): void {
    const { x, size } = this.#picture, wide = this.#canvas.clientWidth / size
    if (x !== this.#x) this.#goTo(cavernAt(x + wide / 2))
    this.#x = x
    const here = this.here
    const all = this.crystals.glowing.map(([at]) => at), isSeen = all.some((at) => at > x && at < x + wide)
    const toLeft = !isSeen && !this.#isDone && all.some((at) => at <= x && cavernAt(at) === here) && !all.some((at) => at >= x + wide && cavernAt(at) === here)
    element('dig-left').classList.toggle('asks', toLeft)
    element('dig-right').classList.toggle('asks', this.#feast <= 0 && (this.#isDone || (!isSeen && !toLeft)))
  }

  get #isDone(): boolean {
    return this.#inPlace(this.here) >= this.#places.length
  }

  /** The places of the crystals of this cavern. */
  #fill(): void {
    const full = this.#inPlace(this.here)
    for (const [k, place] of this.#places.entries()) place.className = k < full ? 'full' : ''
    this.onFill(full)
  }

  /** What there is to do, and how far it is done. */
  #tell(time: number): void {
    this.#news.left -= time
    const lead = this.#asks ?? (this.#news.left > 0 ? this.#news.text : this.#isDone ? walkOn : taskOf(this.here)[0])
    if (this.#lead.textContent !== lead) this.#lead.textContent = lead
    this.#lead.parentElement!.classList.toggle('news', lead !== taskOf(this.here)[0])
    const digs = this.#deeds.digsIn(this.here), best = this.#deeds.best.get(this.here), { gold } = this.crystals, arrived = this.#inPlace(this.here)
    const score = `${counted(digs)} · ${best === undefined ? `par ${taskOf(this.here)[1]}` : `best ${best}`}`, seen = `${arrived} ${gold} ${score}`
    if (seen === this.#seen) return
    this.#seen = seen
    this.#score.textContent = score
    this.#gold.className = gold > 0 ? 'full' : ''
    element('dig-gold').textContent = String(gold)
    this.#boulder.ariaDisabled = String(gold < price)
    element<HTMLButtonElement>('dig-again').disabled = digs === 0 && arrived === 0
    element('dig-goal').ariaLabel = `${arrived} crystal${arrived === 1 ? '' : 's'}, ${score}, ${gold} gold`
  }

  #inCells(place: HTMLElement): [number, number] {
    const { left, top, width, height } = place.getBoundingClientRect(), canvas = this.#canvas.getBoundingClientRect()
    return this.#picture.at({ offsetX: left + width / 2 - canvas.left, offsetY: top + height / 2 - canvas.top })
  }
}

function counted(digs: number): string {
  return `${digs} dig${digs === 1 ? '' : 's'}`
}
