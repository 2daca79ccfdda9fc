// Draws a race: two lanes, below them the speeds over the same distance, and a close-up of both at the seam of the first
// kick, in slow motion.
import type { World } from 'localgridseg'
import { large, shine } from '../crystals.js'
import { theme, wantsCalm } from '../theme.js'
import { finish, type Lane, type Moment, type Race, start } from './race.js'

const slower = 14 // times, in the close-up
const closeCells = 3.4 // that it is wide
const flashes = 24 // steps
const farthest = 6 // cells, that one wheel is ahead of the other
const font = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif'

interface Place {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/** What of the track is seen: the cell at the left, and how many. */
interface Part {
  readonly from: number
  readonly cells: number
}
const whole: Part = { from: -0.5, cells: finish + 2 }

export function drawRace(c: CanvasRenderingContext2D, race: Race, width: number, height: number, now: number): void {
  const colours = theme()
  c.fillStyle = colours.sky
  c.fillRect(0, 0, width, height)
  const isWide = width > 1.25 * height
  const right = isWide ? width - Math.min(440, 0.36 * width) - 30 : width
  const lane = Math.min(height * (isWide ? 0.4 : 0.2), 50 + (2.6 * right) / (finish + 2))
  race.lanes.forEach((each, k) => drawLane(c, race.world, each, { x: 0, y: k * lane, width: right, height: lane }))
  if (isWide && height - 2 * lane > 130) drawSpeeds(c, race, { x: 0, y: 2 * lane, width: right, height: height - 2 * lane })
  const x = isWide ? right + 16 : 12, y = isWide ? 0 : 2 * lane + 8
  drawCloseUp(c, race, { x, y, width: width - 12 - x, height: Math.min(height - y - 8, 560) }, now)
}

/** The lanes alone, from near: what is seen goes along with the wheel that is behind. So many crystals are in each wheel. */
export function drawLanes(c: CanvasRenderingContext2D, race: Race, width: number, height: number, load: number): void {
  c.clearRect(0, 0, width, height)
  const cells = Math.max(farthest + 3.5, (width / height) * 4.5), behind = race.lanes[1].moments.at(-1)!.x
  const part = { from: Math.min(Math.max(whole.from, behind - 2), finish + 5 - cells), cells }
  race.lanes.forEach((each, k) => drawLane(c, race.world, each, { x: 0, y: (k * height) / 2, width, height: height / 2 }, part, load))
}

function unitOf({ width }: Place, { cells }: Part): number {
  return (width - 24) / cells
}

function drawLane(c: CanvasRenderingContext2D, world: World, lane: Lane, place: Place, part = whole, load = 0): void {
  const colours = theme()
  const unit = unitOf(place, part)
  const text = Math.max(12, Math.min(16, place.height / 5.5, place.width / 26))
  const thick = Math.max(6, text * 0.6)
  const line = place.y + place.height - text - 5 // what is written, below the floor
  const floor = line - thick - 4
  const at = (x: number, y: number): [number, number] => [place.x + 12 + (x - part.from) * unit, floor - (y - 1) * unit]
  const wheel = colours.riders[lane.side.ghosts ? 0 : 1]
  c.save()
  c.beginPath()
  c.rect(place.x, place.y, place.width, floor + thick - place.y)
  c.clip()
  drawFlag(c, at(finish, 1), Math.min(unit, place.height / 3))
  drawPath(c, lane, at)
  for (const kick of lane.kicks) drawKick(c, at(...kick.at), lane.moments.length - 1 - kick.moment, unit)
  for (let i = 0; i < finish + 5; ++i) {
    c.fillStyle = colours.ground
    const [x, y] = at(i, 1)
    c.fillRect(x + 0.5, y, unit - 1, thick)
  }
  const ghosts = lane.side.ghosts ? drawGhosts(c, world, lane.moments.at(-1)!.x, at) : []
  drawWheel(c, lane.moments.at(-1)!, at, unit * start.size, wheel, load)
  if (part !== whole) nameGhosts(c, ghosts, place.width, text)
  c.restore()
  if (part === whole && lane.kicks.length > 0) drawFirst(c, at(...lane.kicks[0].at), place.y + text, text)
  c.textBaseline = 'top'
  c.textAlign = 'left'
  c.fillStyle = wheel
  c.beginPath()
  c.arc(20, line + text / 2 - 1, text * 0.36, 0, 2 * Math.PI)
  c.fill()
  c.fillStyle = colours.ink
  c.font = `600 ${text}px ${font}`
  const title = lane.side.ghosts ? 'With ghost vertices:' : 'Without:'
  c.fillText(title, 32, line)
  const left = 32 + c.measureText(`${title} `).width
  if (lane.time !== null) {
    c.textAlign = 'right'
    c.fillText(`${lane.time.toFixed(2)} s`, place.width - 14, line)
  }
  const kicks = lane.side.kicks.count
  c.font = `${text}px ${font}`
  c.textAlign = 'left'
  c.fillText(`${kicks} ${kicks === 1 ? 'kick' : 'kicks'}`, left, line)
}

// Beside the wheel, where there is room for it: before it, or behind it.
function nameGhosts(c: CanvasRenderingContext2D, ghosts: readonly [number, number][], width: number, text: number): void {
  if (ghosts.length === 0) return
  const word = 'ghost vertex: the floor goes on', xs = ghosts.map(([x]) => x), y = ghosts[0][1] - text * 0.9, behind = Math.min(...xs) - 9, before = Math.max(...xs) + 9
  c.font = `600 ${Math.min(14, text)}px ${font}`
  c.textBaseline = 'middle'
  const isBefore = before + c.measureText(word).width < width - 8
  if (!isBefore && behind - c.measureText(word).width < 8) return
  c.textAlign = isBefore ? 'left' : 'right'
  c.strokeStyle = theme().sky
  c.lineWidth = 4
  c.strokeText(word, isBefore ? before : behind, y)
  c.fillStyle = theme().added
  c.fillText(word, isBefore ? before : behind, y)
}

// What the first kick is, above it.
function drawFirst(c: CanvasRenderingContext2D, [x, y]: [number, number], top: number, text: number): void {
  c.fillStyle = c.strokeStyle = theme().kick
  c.lineWidth = 1.5
  c.font = `600 ${Math.min(14, text)}px ${font}`
  c.textAlign = 'left'
  c.textBaseline = 'middle'
  c.fillText('first kick, at a seam', x + 7, top)
  c.beginPath()
  c.moveTo(x, y)
  c.lineTo(x, top - 7)
  c.stroke()
}

// A ring opens where a kick happens, and a dot stays.
function drawKick(c: CanvasRenderingContext2D, [x, y]: [number, number], age: number, unit: number): void {
  const radius = Math.max(2.5, Math.min(5, unit / 9))
  c.fillStyle = c.strokeStyle = theme().kick
  c.beginPath()
  c.arc(x, y, radius, 0, 2 * Math.PI)
  c.fill()
  if (age > flashes || wantsCalm()) return
  c.lineWidth = 4 * (1 - age / flashes)
  c.beginPath()
  c.arc(x, y, radius * (1 + 4 * Math.sqrt(age / flashes)), 0, 2 * Math.PI)
  c.stroke()
}

function drawFlag(c: CanvasRenderingContext2D, [x, y]: [number, number], unit: number): void {
  const size = Math.max(4, unit / 6)
  for (let k = 0; k < 6; ++k) {
    c.fillStyle = k % 2 === 0 ? theme().ink : theme().sky
    c.fillRect(x, y - (k + 1) * size, size, size)
    c.fillStyle = k % 2 === 1 ? theme().ink : theme().sky
    c.fillRect(x + size, y - (k + 1) * size, size, size)
  }
}

// The ghosts of the segment below the wheel: the far ends of its neighbours. Returns where they are.
function drawGhosts(c: CanvasRenderingContext2D, world: World, x: number, at: (x: number, y: number) => [number, number], radius = 4.5): [number, number][] {
  const near = world.nearest(x, 1.2, 1)
  if (near === null) return []
  const { ghost1, ghost2 } = world.segment(near.segment), places = [ghost1, ghost2].filter((ghost) => ghost !== null).map((ghost) => at(ghost[0], ghost[1]))
  c.strokeStyle = theme().added
  c.lineWidth = radius / 2.2
  for (const place of places) {
    c.beginPath()
    c.arc(...place, radius, 0, 2 * Math.PI)
    c.stroke()
  }
  return places
}

function drawPath(c: CanvasRenderingContext2D, { moments, side }: Lane, at: (x: number, y: number) => [number, number]): void {
  c.strokeStyle = theme().riders[side.ghosts ? 0 : 1]
  c.globalAlpha = 0.6
  c.lineWidth = 1.5
  c.beginPath()
  for (const { x, y } of moments) c.lineTo(...at(x, y))
  c.stroke()
  c.globalAlpha = 1
}

function drawWheel(c: CanvasRenderingContext2D, { x, y, angle }: Moment, at: (x: number, y: number) => [number, number], radius: number, colour: string, load = 0): void {
  const [px, py] = at(x, y)
  c.fillStyle = colour
  c.beginPath()
  c.arc(px, py, radius, 0, 2 * Math.PI)
  c.fill()
  c.strokeStyle = theme().sky
  c.lineWidth = Math.max(1.5, radius / 5)
  c.beginPath()
  if (load === 0) {
    c.moveTo(px, py)
    c.lineTo(px + radius * 0.7 * Math.cos(angle), py - radius * 0.7 * Math.sin(angle))
    return c.stroke()
  }
  c.fillStyle = shine[large]
  const far = load === 1 ? 0 : 0.52 * radius, size = radius * (load === 1 ? 0.6 : 0.34)
  for (let k = 0; k < load; ++k) {
    const turn = (2 * Math.PI * k) / load - angle, cx = px + far * Math.cos(turn), cy = py + far * Math.sin(turn)
    for (const [dx, dy] of [[0, -1], [0.7, -0.1], [0, 1], [-0.7, -0.1]]) {
      const x = dx * Math.cos(angle) + dy * Math.sin(angle), y = dy * Math.cos(angle) - dx * Math.sin(angle)
      if (dy === -1) c.moveTo(cx + size * x, cy + size * y)
      else c.lineTo(cx + size * x, cy + size * y)
    }
  }
  c.fill()
}

// Speed over distance: below each place of the track is how fast the wheels were there; and in words, once it is over.
function drawSpeeds(c: CanvasRenderingContext2D, race: Race, place: Place): void {
  const colours = theme(), unit = unitOf(place, whole), isRoomy = place.height > 150
  const top = place.y + 44, low = place.y + place.height - (isRoomy ? 44 : 24), least = 3
  const at = (x: number, v: number): [number, number] => [12 + (x + 0.5) * unit, low - ((low - top) * (v - least)) / (start.speed - least)]
  const write = (text: string, x: number, y: number, align: CanvasTextAlign, weight = 400, size = 12) => {
    c.font = `${weight} ${size}px ${font}`
    c.textAlign = align
    c.fillText(text, x, y)
  }
  c.strokeStyle = colours.grid
  c.fillStyle = colours.ink
  c.lineWidth = 1
  c.textBaseline = 'middle'
  write('Speed along the track', 14, place.y + 20, 'left', 600, 14)
  write('cells a second ↑', place.width - 14, place.y + 22, 'right')
  for (const v of [3, 5, 7]) {
    const [x, y] = at(-0.5, v)
    c.beginPath()
    c.moveTo(x, y)
    c.lineTo(place.width - 12, y)
    c.stroke()
    write(String(v), place.width - 14, y - 8, 'right')
  }
  for (let x = 0; x <= finish; x += 6) {
    const [px] = at(x, least)
    c.beginPath()
    c.moveTo(px, low)
    c.lineTo(px, low + 5)
    c.stroke()
    write(x === finish ? 'finish' : x === 0 ? 'start' : String(x), px, low + 13, x === 0 ? 'left' : 'center')
  }
  if (isRoomy) write('distance in cells →', place.width - 14, low + 30, 'right')
  for (const lane of [race.lanes[1], race.lanes[0]]) {
    c.strokeStyle = colours.riders[lane.side.ghosts ? 0 : 1]
    c.lineWidth = 3
    c.lineJoin = 'round'
    c.beginPath()
    for (const moment of lane.moments) if (moment.x <= finish + 1) c.lineTo(...at(moment.x, moment.vx))
    c.stroke()
  }
  if (isRoomy && race.isOver) write(race.ending, 14, low + 30, 'left', 600, Math.min(14, place.width / 34))
}

// Above the wheel with ghosts, below that without, at the same seam. What kicks stays until the end.
function drawCloseUp(c: CanvasRenderingContext2D, { world, lanes }: Race, { x, y, width, height }: Place, now: number): void {
  const colours = theme(), { replay, kickInReplay, kicks, kickAt } = lanes[1], isKicked = replay.length > 1
  const length = Math.max(1, replay.length - 1), high = (height - 24) / 2
  const t = wantsCalm() ? Math.min(kickInReplay, length) : ((now / 1000) * 60) / slower % length
  const seam = isKicked ? Math.round(kicks.find(({ moment }) => moment === kickAt)!.at[0]) : Math.round(lanes[1].moments.at(-1)!.x)
  const unit = Math.min(width / closeCells, (high - 40) / 1.15)
  const write = (text: string, tx: number, ty: number, align: CanvasTextAlign = 'center') => {
    c.fillStyle = colours.ink
    c.font = `600 14px ${font}`
    c.textAlign = align
    c.textBaseline = 'middle'
    c.fillText(text, tx, ty)
  }
  write(isKicked ? `The first kick, ${slower} times slower` : 'Close-up', x + width / 2, y + 14)
  for (const [k, lane] of lanes.entries()) {
    const top = y + 26 + k * (high + 4), floor = top + high - 40
    const at = (cx: number, cy: number): [number, number] => [x + width / 2 + (cx - seam + 0.5) * unit, floor - (cy - 1) * unit]
    const passes = k === 1 ? replay : passing(lane, replay[kickInReplay]?.x ?? 0, kickInReplay, replay.length)
    const moment = passes.length < 2 ? lane.moments.at(-1)! : between(passes, Math.min(t, passes.length - 1))
    c.save()
    c.beginPath()
    c.roundRect(x, top, width, high - 4, 12)
    c.strokeStyle = colours.close
    c.lineWidth = 3
    c.stroke()
    c.clip()
    c.fillStyle = colours.ground
    c.fillRect(x, floor, width, high)
    c.fillStyle = colours.sky
    for (let i = seam - 2; i < seam + 3; ++i) c.fillRect(at(i, 1)[0] - 1, floor, 2, 10)
    if (isKicked) drawEdge(c, at(seam - 1, 1), at(seam, 1), colours.riders[k])
    if (isKicked && k === 0) drawGhosts(c, world, seam - 0.5, at, 7)
    if (isKicked && k === 1) drawEdge(c, at(seam, 1), at(seam + 1, 1), colours.kick)
    drawWheel(c, moment, at, unit * start.size, colours.riders[k])
    if (isKicked && k === 1) drawPush(c, replay, kickInReplay, at)
    c.restore()
    write(k === 0 ? 'With' : 'Without', x + 14, top + 16, 'left')
    if (isKicked) write(k === 0 ? '○ ghost vertex: the floor goes on' : 'it hits the end of the next edge', x + width / 2, floor + 23)
  }
}

function drawEdge(c: CanvasRenderingContext2D, from: [number, number], to: [number, number], colour: string): void {
  c.strokeStyle = colour
  c.lineWidth = 5
  c.lineCap = 'round'
  c.beginPath()
  c.moveTo(...from)
  c.lineTo(...to)
  c.stroke()
}

/** As many moments of a wheel around that in which it comes to a place. */
function passing({ moments }: Lane, x: number, before: number, count: number): readonly Moment[] {
  const k = moments.findIndex((moment) => moment.x >= x)
  return k < 0 ? [] : moments.slice(Math.max(0, k - before), k - before + count)
}

// What the kick did to the velocity, as an arrow, and where the wheel was then.
function drawPush(c: CanvasRenderingContext2D, replay: readonly Moment[], k: number, at: (x: number, y: number) => [number, number]): void {
  const [a, b] = [replay[Math.max(0, k - 1)], replay[k]]
  const [dx, dy] = [b.vx - a.vx, b.vy - a.vy]
  const length = Math.hypot(dx, dy)
  if (length === 0) return
  const from = at(b.x, b.y)
  const to = at(b.x + (0.62 * dx) / length, b.y + (0.62 * dy) / length)
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0])
  c.strokeStyle = theme().kick
  c.lineWidth = 2
  c.setLineDash([5, 5])
  c.beginPath()
  c.arc(...from, from[0] - at(b.x - start.size, 0)[0], 0, 2 * Math.PI)
  c.stroke()
  c.setLineDash([])
  c.lineWidth = 4
  c.fillStyle = theme().ink
  c.font = `600 14px ${font}`
  c.textAlign = 'right'
  c.fillText('kick', to[0] - 10, to[1])
  c.beginPath()
  c.moveTo(...from)
  c.lineTo(...to)
  for (const turn of [2.6, -2.6]) {
    c.moveTo(...to)
    c.lineTo(to[0] + 12 * Math.cos(angle + turn), to[1] + 12 * Math.sin(angle + turn))
  }
  c.stroke()
}

function between(moments: readonly Moment[], t: number): Moment {
  const k = Math.min(moments.length - 2, Math.floor(t))
  const [a, b, part] = [moments[k], moments[k + 1], t - k]
  const mix = (u: number, v: number) => u + (v - u) * part
  return { x: mix(a.x, b.x), y: mix(a.y, b.y), angle: mix(a.angle, b.angle), vx: mix(a.vx, b.vx), vy: mix(a.vy, b.vy) }
}
