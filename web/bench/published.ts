// The published algorithm in TypeScript, as its article "An Algorithm for Local Grid Segmentation" gives it: five maps,
// two phases, atan2. Names are those of its pseudo-code. bench/published/published.h is the same in C++. "Silent:" marks
// what the article leaves open.

interface Vec2 { x: number; y: number }
interface Seg { start: Vec2; end: Vec2; ghost1: Vec2 | null; ghost2: Vec2 | null; cellHash: bigint; ogBlock: number }
type Segments = Map<bigint, Seg[]>

const epsilon = 1e-3
const equals = (a: Vec2, b: Vec2) => Math.abs(a.x - b.x) < epsilon && Math.abs(a.y - b.y) < epsilon

// Section 5.2: "by reinterpreting their Float32 bit patterns as BigInt in JS".
const floats = new Float32Array(2)
const bits = new BigUint64Array(floats.buffer)
function hash(x: number, y: number): bigint {
  floats[0] = x
  floats[1] = y
  return bits[0]!
}
function unhash(vertex: bigint): Vec2 {
  bits[0] = vertex
  return { x: floats[0]!, y: floats[1]! }
}

function at(map: Segments, key: bigint): Seg[] {
  let segments = map.get(key)
  if (!segments) map.set(key, (segments = []))
  return segments
}

/** Silent: what there is to resolve a boundary along x or y with; the article has two functions, "identical in concept". */
interface Boundaries { axis: 'x' | 'y'; raw: Segments; resolved: Segments; dirty: Set<bigint> }
const boundaries = (axis: 'x' | 'y'): Boundaries => ({ axis, raw: new Map(), resolved: new Map(), dirty: new Set() })

export class Published {
  #vertexManifold: Segments = new Map()
  #horizontal = boundaries('x')
  #vertical = boundaries('y')
  #dirtyVertices = new Set<bigint>()

  /** Section 4.1. Silent: a ramp's diagonal has both ends on a boundary, and is an interior edge all the same. */
  add(i: number, j: number, polygon: readonly Vec2[], block: number): void {
    for (let k = 0; k < polygon.length; ++k) {
      const start = polygon[k]!, end = polygon[(k + 1) % polygon.length]!
      const seg: Seg = { start, end, ghost1: null, ghost2: null, cellHash: hash(i, j), ogBlock: block }
      const place = this.#placeOf(i, j, start, end)
      if (!place) this.#insertIntoManifold(seg)
      else {
        at(place.of.raw, place.key).push(seg)
        place.of.dirty.add(place.key)
        this.#removeResolved(place.of, place.key)
      }
    }
  }

  /** Section 4.3. */
  compute(): void {
    for (const of of [this.#horizontal, this.#vertical]) for (const key of of.dirty) this.#resolve(of, key)
    for (const vertex of this.#dirtyVertices) this.#assignGhostVertices(vertex)
    for (const dirty of [this.#horizontal.dirty, this.#vertical.dirty, this.#dirtyVertices]) dirty.clear()
  }

  /** All segments, each once. */
  *segments(): Generator<Seg> {
    for (const [vertex, segs] of this.#vertexManifold)
      for (const seg of segs) if (hash(seg.start.x, seg.start.y) === vertex) yield seg
  }

  #placeOf(i: number, j: number, start: Vec2, end: Vec2): { of: Boundaries; key: bigint } | null {
    if (start.y === end.y && Number.isInteger(start.y)) return { of: this.#horizontal, key: hash(i, start.y) }
    if (start.x === end.x && Number.isInteger(start.x)) return { of: this.#vertical, key: hash(start.x, j) }
    return null
  }
  #insertIntoManifold(seg: Seg): void {
    for (const v of [seg.start, seg.end]) {
      const key = hash(v.x, v.y)
      at(this.#vertexManifold, key).push(seg)
      this.#dirtyVertices.add(key)
    }
  }
  #removeResolved({ resolved }: Boundaries, key: bigint): void {
    for (const seg of resolved.get(key) ?? []) {
      for (const v of [seg.start, seg.end]) {
        const vertex = hash(v.x, v.y), segs = this.#vertexManifold.get(vertex)!
        segs.splice(segs.indexOf(seg), 1)
        if (segs.length === 0) this.#vertexManifold.delete(vertex)
        this.#dirtyVertices.add(vertex)
      }
    }
    resolved.delete(key)
  }

  /** Section 3.1. Silent: who owns what is left; here it is the first segment's polygon. */
  #resolve({ axis, raw, resolved }: Boundaries, key: bigint): void {
    const segs = raw.get(key)
    if (!segs || segs.length === 0) return
    const keep = (results: Seg[]) => {
      for (const seg of results) this.#insertIntoManifold(seg)
      resolved.set(key, results)
    }
    if (segs.length === 1) return keep([{ ...segs[0]! }])
    if (segs.length === 2 && equals(segs[0]!.start, segs[1]!.end) && equals(segs[0]!.end, segs[1]!.start)) return
    const candidates = segs.flatMap(({ start, end }) => {
      const forward = start[axis] < end[axis]
      return [{ val: start[axis], forward, delta: forward ? 1 : -1 }, { val: end[axis], forward, delta: forward ? -1 : 1 }]
    }).sort((a, b) => a.val - b.val)
    const first = segs[0]!, results: Seg[] = []
    const push = (from: number, to: number) => results.push(
      { ...first, start: { ...first.start, [axis]: from }, end: { ...first.start, [axis]: to } })
    let activeUp = 0, activeDown = 0
    for (let k = 0; k + 1 < candidates.length; ++k) {
      const curr = candidates[k]!, next = candidates[k + 1]!
      if (curr.forward) activeDown += curr.delta
      else activeUp += curr.delta
      if (next.val === curr.val || (activeUp > 0 && activeDown > 0)) continue
      if (activeUp > 0) push(next.val, curr.val)
      if (activeDown > 0) push(curr.val, next.val)
    }
    if (results.length > 0) keep(results)
  }

  /** Section 3.2. */
  #assignGhostVertices(key: bigint): void {
    const segs = this.#vertexManifold.get(key)
    if (!segs) return
    const vertex = unhash(key)
    const outgoing = segs.filter((s) => equals(s.start, vertex)), incoming = segs.filter((s) => equals(s.end, vertex))
    for (const seg of segs) {
      const isOutgoing = equals(seg.start, vertex)
      const candidates = isOutgoing ? incoming : outgoing
      if (candidates.length === 0) continue
      const best = findBestMatch(isOutgoing ? seg.end : seg.start, candidates, vertex, isOutgoing)
      if (best) seg[isOutgoing ? 'ghost1' : 'ghost2'] = isOutgoing ? best.start : best.end
    }
  }
}

function findBestMatch(far: Vec2, candidates: readonly Seg[], vertex: Vec2, clockwise: boolean): Seg | null {
  const direction = (to: Vec2) => Math.atan2(to.y - vertex.y, to.x - vertex.x)
  let best: Seg | null = null, minAngle = Infinity
  for (const cand of candidates) {
    const from = direction(far), to = direction(equals(cand.start, vertex) ? cand.end : cand.start)
    let angle = clockwise ? from - to : to - from
    if (angle < 0) angle += 2 * Math.PI
    if (angle < epsilon || angle >= minAngle) continue // the first: itself
    minAngle = angle
    best = cand
  }
  return best
}
