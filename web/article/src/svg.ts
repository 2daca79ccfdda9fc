// Elements of SVG. Figures are drawn in cells with y up; SVG has y down, so it is turned around here, and only here.
export type Point = readonly [number, number]

export function el<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string | number>> = {},
): SVGElementTagNameMap[K] {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag)
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value))
  return made
}

const place = ([x, y]: Point) => `${round(x)} ${round(-y)}`

export function path(kind: string, points: readonly Point[], isClosed = false): SVGPathElement {
  return el('path', { class: kind, d: `M${points.map(place).join('L')}${isClosed ? 'z' : ''}` })
}

export function disc(kind: string, [x, y]: Point, radius: number): SVGCircleElement {
  return el('circle', { class: kind, cx: round(x), cy: round(-y), r: round(radius) })
}

export function rect(kind: string, x0: number, y0: number, x1: number, y1: number): SVGRectElement {
  return el('rect', { class: kind, x: x0, y: -y1, width: x1 - x0, height: y1 - y0 })
}

export function words(kind: string, [x, y]: Point, size: number, text: string): SVGTextElement {
  const made = el('text', { class: kind, x: round(x), y: round(-y), 'font-size': round(size), 'text-anchor': 'middle' })
  made.textContent = text
  return made
}

/**
 * A line with a head, in its middle or `where` along it, that says which way it runs; half a head's width to the right of
 * it if `aside`.
 */
export function arrow(kind: string, a: Point, b: Point, head: number, aside = 0, where = 0.5): SVGPathElement {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]]
  const length = Math.hypot(dx, dy) || 1
  const [ux, uy] = [dx / length, dy / length]
  const [ox, oy] = [uy * aside, -ux * aside]
  const size = Math.min(head, length / 2)
  const [mx, my] = [a[0] + dx * where + ox + (ux * size) / 2, a[1] + dy * where + oy + (uy * size) / 2]
  const barb = (side: number): Point => [mx - ux * size - side * uy * size * 0.6, my - uy * size + side * ux * size * 0.6]
  const from: Point = [a[0] + ox, a[1] + oy]
  const to: Point = [b[0] + ox, b[1] + oy]
  return el('path', { class: kind, d: `M${place(from)}L${place(to)}M${place(barb(1))}L${place([mx, my])}L${place(barb(-1))}` })
}

/** An arc about a point, from one angle to another; it runs the way that the sign of the difference says. */
export function arc(kind: string, [x, y]: Point, radius: number, from: number, to: number): SVGPathElement {
  const steps = Math.max(2, Math.ceil(Math.abs(to - from) / 0.1))
  const points: Point[] = []
  for (let k = 0; k <= steps; ++k) {
    const angle = from + ((to - from) * k) / steps
    points.push([x + radius * Math.cos(angle), y + radius * Math.sin(angle)])
  }
  return path(kind, points)
}

function round(x: number): number {
  return Math.round(x * 10000) / 10000
}
