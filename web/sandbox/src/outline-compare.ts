// Compares two outlines, whatever their edges are cut into. On each line edges of one outline count +1, those of the
// other one −1, and edges that run the other way the opposite. Where a count is left the outlines differ. Edges that
// run both ways, as a preserve relation keeps them, count nothing.

const units = 65536 // of the lattice, per cell

interface Step {
  readonly at: bigint
  readonly change: number
}

interface Line {
  readonly dx: number
  readonly dy: number
  readonly offset: bigint
  readonly steps: Step[]
}

/** Takes edges: x, y, x, y of each, in cells. Returns the parts that differ, in the same way. */
export function differences(a: ArrayLike<number>, b: ArrayLike<number>): Float64Array {
  const lines = new Map<string, Line>()
  count(lines, a, 1)
  count(lines, b, -1)
  const different: number[] = []
  for (const line of lines.values()) different.push(...leftOn(line))
  return Float64Array.from(different)
}

function count(lines: Map<string, Line>, edges: ArrayLike<number>, weight: number): void {
  for (let k = 0; k < edges.length; k += 4) {
    const [x0, y0, x1, y1] = [0, 1, 2, 3].map((n) => Math.round(edges[k + n] * units))
    const divisor = greatestDivisor(Math.abs(x1 - x0), Math.abs(y1 - y0))
    if (divisor === 0) continue
    let [dx, dy] = [(x1 - x0) / divisor, (y1 - y0) / divisor]
    const forward = dx > 0 || (dx === 0 && dy > 0)
    if (!forward) [dx, dy] = [-dx, -dy]
    const offset = BigInt(dx) * BigInt(y0) - BigInt(dy) * BigInt(x0)
    const key = `${dx} ${dy} ${offset}`
    let line = lines.get(key)
    if (line === undefined) lines.set(key, (line = { dx, dy, offset, steps: [] }))
    const along = (x: number, y: number) => BigInt(dx) * BigInt(x) + BigInt(dy) * BigInt(y)
    line.steps.push({ at: along(x0, y0), change: weight }, { at: along(x1, y1), change: -weight })
  }
}

function leftOn({ dx, dy, offset, steps }: Line): number[] {
  steps.sort((p, q) => (p.at < q.at ? -1 : p.at > q.at ? 1 : 0))
  const square = dx * dx + dy * dy
  const place = (at: bigint): [number, number] => {
    const [t, o] = [Number(at), Number(offset)]
    return [(t * dx - o * dy) / square / units, (t * dy + o * dx) / square / units]
  }
  const left: number[] = []
  let depth = 0
  for (let k = 0; k < steps.length; ++k) {
    if (depth !== 0 && steps[k].at !== steps[k - 1].at) left.push(...place(steps[k - 1].at), ...place(steps[k].at))
    depth += steps[k].change
  }
  return left
}

function greatestDivisor(a: number, b: number): number {
  while (b !== 0) [a, b] = [b, a % b]
  return a
}
