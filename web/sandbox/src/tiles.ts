// The palette of tiles: polygons in the unit cell, counter-clockwise.
export type Corner = readonly [number, number]

export interface Tile {
  readonly name: string
  readonly vertices: readonly Corner[]
}

const quarterCircle: Corner[] = []
for (let k = 0; k <= 8; ++k) {
  const angle = (k / 8) * (Math.PI / 2)
  quarterCircle.push([Math.cos(angle), Math.sin(angle)])
}

export const tiles: readonly Tile[] = [
  { name: 'Block', vertices: [[0, 0], [1, 0], [1, 1], [0, 1]] },
  { name: 'Ramp', vertices: [[0, 0], [1, 0], [1, 1]] },
  { name: 'Gentle ramp, low', vertices: [[0, 0], [1, 0], [1, 0.5]] },
  { name: 'Gentle ramp, high', vertices: [[0, 0], [1, 0], [1, 1], [0, 0.5]] },
  { name: 'Half block', vertices: [[0, 0], [1, 0], [1, 0.5], [0, 0.5]] },
  { name: 'Pillar', vertices: [[0.25, 0], [0.75, 0], [0.75, 1], [0.25, 1]] },
  { name: 'Rounded', vertices: [[0, 0], ...quarterCircle] },
]

/** Turned by quarters, counter-clockwise. */
export function turned(vertices: readonly Corner[], quarters: number): Corner[] {
  let result = vertices.map(([x, y]): Corner => [x, y])
  for (let k = 0; k < quarters; ++k) result = result.map(([x, y]): Corner => [1 - y, x])
  return result
}
