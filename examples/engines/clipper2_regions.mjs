// Clipper2, as WebAssembly, as an engine of regions for `lgs check --engine`. What is solid is kept on its lattice.
//
//     npm ci --prefix examples/engines
//     lgs check --engine 'node examples/engines/clipper2_regions.mjs' --edits 500
import load from 'clipper2-wasm'
import { serve } from './regions.mjs'

const clipper = await load()
const { Difference64, FillRule, Paths64, Union64, UnionSelf64 } = clipper

function regionOf(rings) {
  const paths = new Paths64()
  for (const ring of rings) paths.push_back(clipper.MakePath64(ring.flat().map(BigInt)))
  return UnionSelf64(paths, FillRule.EvenOdd)
}

function ringsOf(paths) {
  return Array.from({ length: paths.size() }, (_, k) => paths.get(k))
    .map((path) => Array.from({ length: path.size() }, (_, k) => path.get(k)).map(({ x, y }) => [Number(x), Number(y)]))
}

serve({
  greeting: 'Clipper2 regions slants round=1',
  nothing: new Paths64(),
  regionOf,
  unite: (a, b) => Union64(a, b, FillRule.NonZero),
  subtract: (a, b) => Difference64(a, b, FillRule.NonZero),
  ringsOf,
})
