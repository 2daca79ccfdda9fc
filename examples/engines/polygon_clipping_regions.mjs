// polygon-clipping as an engine of regions for `lgs check --engine`. What is solid is kept in doubles.
//
//     npm ci --prefix examples/engines
//     lgs check --engine 'node examples/engines/polygon_clipping_regions.mjs' --edits 500
import polygonClipping from 'polygon-clipping'
import { serve, trianglesOf } from './regions.mjs'

const { difference, union, xor } = polygonClipping

serve({
  greeting: 'polygon-clipping regions slants round=1',
  nothing: [],
  regionOf: (rings) => trianglesOf(rings).reduce((region, triangle) => xor(region, [triangle]), []),
  unite: (a, b) => union(a, b),
  subtract: (a, b) => difference(a, b),
  ringsOf: (solid) => solid.flat().map((ring) => ring.slice(1)),
})
