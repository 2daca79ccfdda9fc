// What flies about and is only seen: crumbs, dust, and shards on their way. Lengths are in cells, y up, and times in
// seconds.
type Point = readonly [number, number]

interface Spark {
  x: number
  y: number
  vx: number
  vy: number
  angle: number
  readonly spin: number
  age: number
  readonly life: number
  readonly size: number
  readonly colour: string
  readonly isDust: boolean
}

interface Word {
  readonly at: Point
  readonly text: string
  age: number
}

interface Flight {
  readonly from: Point
  readonly bend: Point
  readonly to: () => Point
  readonly colour: string
  readonly life: number
  readonly arrive: () => void
  age: number
}

const most = 700
const wordLife = 1.3
const gravity = 22 // cells per second squared

export class Sparks {
  readonly #sparks: Spark[] = []
  #flights: Flight[] = []
  #words: Word[] = []
  #time = 0
  /** Where rings are. */
  marks: readonly Point[] = []

  /** Crumbs to all sides, and a little up. */
  crumbs([x, y]: Point, count: number, colour: string, speed: number, size = 0.22): void {
    for (let k = 0; k < count; ++k) {
      const way = 2 * Math.PI * Math.random(), fast = speed * (0.3 + 0.7 * Math.random())
      const motion = { x, y, vx: fast * Math.cos(way), vy: fast * Math.sin(way) + 0.4 * speed }
      this.#add({ ...motion, colour, isDust: false, size: size * (0.5 + Math.random()), life: 0.5 + 0.5 * Math.random() })
    }
  }

  /** Along the ground, to both sides of where something fell. */
  dust([x, y]: Point, count: number, speed: number, colour: string): void {
    for (let k = 0; k < count; ++k) {
      const way = k % 2 === 0 ? 1 : -1
      const motion = { x, y, vx: way * speed * Math.random(), vy: 0.25 * speed * Math.random() }
      this.#add({ ...motion, colour, isDust: true, size: 0.3 + 0.5 * Math.random(), life: 0.5 + 0.6 * Math.random() })
    }
  }

  /** A shard that flies to a place, which may move meanwhile. */
  fly(from: Point, to: () => Point, colour: string, life: number, arrive: () => void): void {
    const bend: Point = [from[0] + 8 * (Math.random() - 0.5), from[1] + 3 + 3 * Math.random()]
    this.#flights.push({ from, bend, to, colour, life, arrive, age: 0 })
  }

  /** It rises, and is gone. */
  say(at: Point, text: string): void {
    this.#words.push({ at, text, age: 0 })
  }

  step(time: number): void {
    this.#time += time
    for (const each of this.#words) each.age += time
    this.#words = this.#words.filter(({ age }) => age < wordLife)
    for (const each of this.#sparks) {
      each.age += time
      each.x += time * each.vx
      each.y += time * each.vy
      each.angle += time * each.spin
      if (!each.isDust) each.vy -= time * gravity
      else each.vx *= 1 - Math.min(1, 3 * time)
    }
    for (let k = this.#sparks.length - 1; k >= 0; --k) if (this.#sparks[k].age >= this.#sparks[k].life) this.#sparks.splice(k, 1)
    for (const each of this.#flights) each.age += time
    const arrived = this.#flights.filter(({ age, life }) => age >= life)
    this.#flights = this.#flights.filter(({ age, life }) => age < life)
    for (const { arrive } of arrived) arrive()
  }

  /** Into a context whose units are cells. */
  draw(c: CanvasRenderingContext2D): void {
    for (const { x, y, angle, age, life, size, colour, isDust } of this.#sparks) {
      const rest = 1 - age / life
      c.fillStyle = colour
      c.globalAlpha = isDust ? 0.45 * rest : Math.min(1, 2 * rest)
      c.beginPath()
      if (isDust) c.arc(x, y, size * (1.6 - rest), 0, 2 * Math.PI)
      else for (let k = 0; k < 3; ++k) c.lineTo(x + size * Math.cos(angle + 2.1 * k), y + size * Math.sin(angle + 2.1 * k))
      c.fill()
    }
    for (const flight of this.#flights) this.#drawFlight(c, flight)
    c.globalAlpha = 1
    c.strokeStyle = '#ffd166'
    c.lineWidth = 0.22
    for (const [x, y] of this.marks) {
      c.beginPath()
      c.arc(x, y, 0.95 + 0.15 * Math.sin(6 * this.#time), 0, 2 * Math.PI)
      c.stroke()
    }
    for (const word of this.#words) this.#drawWord(c, word)
    c.globalAlpha = 1
  }

  // It begins slowly, and draws a tail.
  #drawFlight(c: CanvasRenderingContext2D, { from, bend, to, colour, age, life }: Flight): void {
    const target = to()
    c.fillStyle = colour
    for (let k = 0; k < 6; ++k) {
      const t = Math.max(0, age / life - 0.02 * k) ** 2, size = 0.34 * (1 - k / 6)
      const at = (n: 0 | 1) => (1 - t) * ((1 - t) * from[n] + t * bend[n]) + t * ((1 - t) * bend[n] + t * target[n])
      const x = at(0), y = at(1)
      c.globalAlpha = 1 - k / 6
      c.beginPath()
      for (const [dx, dy] of [[0, 1.3], [0.8, 0], [0, -1.3], [-0.8, 0]]) c.lineTo(x + size * dx, y + size * dy)
      c.fill()
    }
  }

  #drawWord(c: CanvasRenderingContext2D, { at: [x, y], text, age }: Word): void {
    const t = age / wordLife
    c.save()
    c.translate(x, y + 3 * Math.sqrt(t))
    c.scale(1, -1) // letters stand upright
    c.globalAlpha = Math.min(1, 3 * (1 - t))
    c.font = `800 ${Math.min(1, 8 * t) * 1.7}px system-ui, sans-serif`
    c.textAlign = 'center'
    c.lineWidth = 0.25
    c.lineJoin = 'round'
    c.strokeStyle = 'rgba(20, 16, 44, 0.8)'
    c.fillStyle = '#fff'
    c.strokeText(text, 0, 0)
    c.fillText(text, 0, 0)
    c.restore()
  }

  #add(spark: Omit<Spark, 'angle' | 'spin' | 'age'>): void {
    if (this.#sparks.length >= most) this.#sparks.shift()
    this.#sparks.push({ ...spark, angle: 6 * Math.random(), spin: 14 * (Math.random() - 0.5), age: 0 })
  }
}
