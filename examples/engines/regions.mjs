// The protocol of `lgs check --engine` for libraries of JavaScript that take regions. The adapters beside it say what
// is theirs:
//
//   greeting            NAME and the capabilities
//   regionOf(rings)     a region of rings, inside where they run around an odd number of times
//   unite(a, b), subtract(a, b)
//   ringsOf(solid)      its rings, [x, y] …, each with the solid on its left: outer ones counter-clockwise
import { createInterface } from 'node:readline'

const kUnits = 65536 // of the lattice, in a cell

function readRings(words) {
  const numbers = (part) => part.trim().split(' ').map((word) => Number(word) * kUnits) // exact
  return words.join(' ').split('|').map(numbers)
    .map((xy) => xy.filter((_, k) => k % 2 === 0).map((x, k) => [x, xy[2 * k + 1]]))
}

function segmentsOf(ring) {
  const lines = []
  for (let k = 0; k < ring.length; ++k) {
    const [a, b] = [ring[k], ring[(k + 1) % ring.length]].map((p) => p.map(Math.round))
    if (a[0] !== b[0] || a[1] !== b[1]) lines.push(`segment ${a.join(' ')} ${b.join(' ')} - - - - 0`)
  }
  return lines
}

/** For libraries without the even-odd rule: the triangles from a ring's first vertex, by exclusive or. */
export function trianglesOf(rings) {
  return rings.flatMap((ring) => ring.slice(2).map((c, k) => [ring[0], ring[k + 1], c]))
    .filter(([a, b, c]) => (b[0] - a[0]) * (c[1] - a[1]) !== (b[1] - a[1]) * (c[0] - a[0]))
}

export function serve({ greeting, nothing, regionOf, unite, subtract, ringsOf }) {
  let solid = nothing
  const answers = {
    'lgs-engine': () => [`lgs-engine 1 ${greeting}`],
    reset() { solid = nothing },
    paint(_block, _mode, ...words) { solid = unite(solid, regionOf(readRings(words))) }, // one block: modes do the same
    carve(...words) { solid = subtract(solid, regionOf(readRings(words))) },
    commit: () => [...ringsOf(solid).flatMap(segmentsOf), 'end'],
  }
  createInterface({ input: process.stdin }).on('line', (line) => {
    const [word, ...rest] = line.split(' ')
    const lines = answers[word](...rest)
    if (lines) process.stdout.write(lines.join('\n') + '\n')
  })
}
