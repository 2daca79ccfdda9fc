// Unites polygons with polygon-clipping, on request. It says "ready" and then reads lines from the standard input. The
// first line is all polygons, as one JSON array of rings. Then it answers each "build" with "built", and each "read" with
// the rings of the union as JSON: [[outer, hole, ...], ...].
import { createInterface } from 'node:readline'
import { createRequire } from 'node:module'

const polygonClipping = createRequire(new URL('../../examples/engines/', import.meta.url))('polygon-clipping')
let polygons
let united
const answers = {
  build() {
    united = polygonClipping.union(...polygons)
    return 'built'
  },
  read: () => JSON.stringify(united),
}

console.log('ready')
for await (const line of createInterface({ input: process.stdin })) {
  if (!polygons) {
    polygons = JSON.parse(line).map((ring) => [ring])
  } else {
    console.log(answers[line]())
  }
}
