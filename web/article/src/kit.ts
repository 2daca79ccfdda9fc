// A figure: a stage that is drawn in cells with y up, things on it that can be dragged, by keyboard too, controls below
// it, and a line that says what is seen.
import { el, type Point } from './svg.js'

export interface Box {
  readonly x0: number
  readonly y0: number
  readonly x1: number
  readonly y1: number
}

export interface HandleOptions {
  readonly at: Point
  readonly label: string
  /** How far an arrow key moves it; with Shift five times as far. */
  readonly step: number
  /** Where it would be moved to. Returns where it goes. */
  move(x: number, y: number): Point
  /** The pointer has let go of it, or the key has moved it. */
  drop?(): void
  /** The pointer drags it, after each move; whether that is the first one. */
  drag?(x: number, y: number, isFirst: boolean): void
  /** It was pressed without being dragged, here, or Enter was. */
  tap?(x: number, y: number): void
}

export interface Handle {
  at: Point
  readonly element: SVGGElement
}

const arrows: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}
const finger = 22 // pixels: the radius in which a handle is hit
const still = 4 // pixels: who moves the pointer by less has tapped
const afterDrag = 4000 // milliseconds until what runs goes on
const longestFrame = 0.05 // seconds

export class Figure {
  readonly svg: SVGSVGElement
  readonly box: Box
  readonly #element: HTMLElement
  readonly #controls = document.createElement('div')
  readonly #says = document.createElement('output')
  readonly #handles: Handle[] = []
  readonly #handleLayer = el('g')
  #redraw: () => void = () => {}
  #isVisible = false

  constructor(element: HTMLElement, box: Box, label: string) {
    this.#element = element
    this.box = box
    this.svg = el('svg', {
      viewBox: `${box.x0} ${-box.y1} ${box.x1 - box.x0} ${box.y1 - box.y0}`,
      role: 'group',
      'aria-label': label,
    })
    this.#controls.className = 'controls'
    this.svg.append(this.#handleLayer)
    element.querySelector('.stage')!.replaceChildren(this.svg, this.#controls, this.#says)
    element.classList.add('untouched') // until somebody drags something: its grips ask for it
    for (const event of ['pointerdown', 'keydown'])
      this.#handleLayer.addEventListener(event, () => element.classList.remove('untouched'), { once: true })
    new ResizeObserver(() => this.redraw()).observe(this.svg)
    new IntersectionObserver(([entry]) => {
      this.#isVisible = entry.isIntersecting
    }).observe(this.svg)
  }

  /** Cells a pixel. */
  get pixel(): number {
    const { x0, y0, x1, y1 } = this.box // it is drawn as large as fits, in a low window too
    return Math.max((x1 - x0) / (this.svg.clientWidth || 600), (y1 - y0) / (this.svg.clientHeight || Infinity))
  }

  /** A group to draw into, above those before it and below the handles. */
  layer(): SVGGElement {
    const group = el('g')
    this.svg.insertBefore(group, this.#handleLayer)
    return group
  }

  /** What draws the figure. It is called now, and when the size changes. */
  draws(redraw: () => void): void {
    this.#redraw = redraw
    this.redraw()
  }

  redraw(): void {
    for (const { at, element } of this.#handles) {
      element.setAttribute('transform', `translate(${at[0]} ${-at[1]}) scale(${this.pixel})`)
    }
    this.#redraw()
  }

  handle(options: HandleOptions): Handle {
    const element = el('g', { class: 'handle', tabindex: 0, role: 'button', 'aria-label': options.label })
    element.setAttribute('aria-description', `Drag it, or move it by the arrow keys${options.tap ? '. Tap it or press Enter to use it' : ''}`)
    element.append(el('circle', { class: 'asks', r: 8 }), el('circle', { class: 'hit', r: finger }), el('circle', { class: 'grip', r: 8 }))
    const handle: Handle = { at: options.at, element }
    const move = (x: number, y: number) => {
      handle.at = options.move(x, y)
      this.redraw()
    }
    let off: Point | null = null // from the pointer to the middle of the handle
    let pressed: Point = [0, 0] // where on the page
    let isTap = false
    element.addEventListener('touchstart', (event) => event.preventDefault()) // the finger drags, and scrolls nothing
    element.addEventListener('pointerdown', (event) => {
      event.preventDefault()
      element.focus({ preventScroll: true })
      element.setPointerCapture(event.pointerId)
      const [x, y] = this.#place(event)
      off = [handle.at[0] - x, handle.at[1] - y]
      pressed = [event.clientX, event.clientY]
      isTap = true
    })
    element.addEventListener('pointermove', (event) => {
      if (off === null) return
      const isFirst = isTap
      if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) >= still) isTap = false
      const [x, y] = this.#place(event), to: Point = [x + off[0], y + off[1]]
      if (options.drag === undefined) return move(...to)
      if (isTap) return
      options.drag(...to, isFirst)
      this.redraw()
    })
    for (const end of ['pointerup', 'pointercancel'] as const) {
      element.addEventListener(end, (event) => {
        if (off === null) return
        off = null
        options.drop?.()
        if (isTap && end === 'pointerup') options.tap?.(...this.#place(event))
        this.redraw()
      })
    }
    element.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') options.tap?.(...handle.at)
      const way = arrows[event.key]
      if (way === undefined) return
      event.preventDefault()
      const length = options.step * (event.shiftKey ? 5 : 1)
      move(handle.at[0] + way[0] * length, handle.at[1] + way[1] * length)
      options.drop?.()
      this.redraw()
    })
    this.#handles.push(handle)
    this.#handleLayer.append(element)
    return handle
  }

  /** A pointer goes down on the stage, beside the handles, and drags on; whether it has just gone down. */
  onDrag(action: (x: number, y: number, isFirst: boolean) => void): void {
    const { svg } = this
    svg.classList.add('tappable')
    svg.addEventListener('pointerdown', (event) => {
      if ((event.target as Element).closest('.handle') !== null) return
      svg.setPointerCapture(event.pointerId)
      this.#element.classList.remove('untouched')
      action(...this.#place(event), true)
    })
    svg.addEventListener('pointermove', (event) => {
      if (svg.hasPointerCapture(event.pointerId)) action(...this.#place(event), false)
    })
  }

  button(text: string, action: () => void): HTMLButtonElement {
    const made = document.createElement('button')
    made.type = 'button'
    made.textContent = text
    made.addEventListener('click', action)
    this.#controls.append(made)
    return made
  }

  toggle(text: string, isOn: boolean, action: (isOn: boolean) => void): HTMLInputElement {
    const label = document.createElement('label')
    const input = document.createElement('input')
    input.type = 'checkbox'
    input.checked = isOn
    input.addEventListener('change', () => action(input.checked))
    label.append(input, text)
    this.#controls.append(label)
    return input
  }

  slider(text: string, least: number, most: number, step: number, value: number, action: (value: number) => void): HTMLInputElement {
    const label = document.createElement('label')
    const input = document.createElement('input')
    Object.assign(input, { type: 'range', min: least, max: most, step, value })
    input.addEventListener('input', () => action(input.valueAsNumber))
    label.append(text, input)
    this.#controls.append(label)
    return input
  }

  /** What moves by itself says so `quietly`: nobody wants it read aloud all the time. */
  say(text: string, quietly = false): void {
    this.#says.ariaLive = quietly ? 'off' : 'polite'
    if (this.#says.textContent !== text) this.#says.textContent = text
    this.#element.dataset.says = text
  }

  /**
   * Calls step() sixty times a second while the figure is on the screen. Who wants no motion starts it by a button. It
   * returns what stops it until the button is pressed, and what holds it as long as somebody drags, and a little longer.
   */
  runs(step: () => void): { readonly stop: () => void; readonly hold: () => void } {
    let heldUntil = 0
    let isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches
    const button = this.button('', () => {
      isPlaying = !isPlaying
      heldUntil = 0
      name()
    })
    const name = () => {
      button.textContent = isPlaying ? 'Pause' : 'Play'
    }
    name()
    let last = 0
    let owed = 0
    const frame = (now: number) => {
      if (isPlaying && this.#isVisible && now > heldUntil) {
        owed += Math.min(longestFrame, (now - last) / 1000)
        if (owed >= 1 / 60) {
          for (; owed >= 1 / 60; owed -= 1 / 60) step()
          this.redraw()
        }
      }
      last = now
      requestAnimationFrame(frame)
    }
    requestAnimationFrame(frame)
    const stop = () => {
      isPlaying = false
      name()
    }
    return { stop, hold: () => { heldUntil = performance.now() + afterDrag } }
  }

  #place(event: MouseEvent): [number, number] {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM()!.inverse())
    return [at.x, -at.y]
  }
}

export function clamp(x: number, least: number, most: number): number {
  return Math.min(most, Math.max(least, x))
}
