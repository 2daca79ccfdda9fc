// iOverlay, as WebAssembly, as an engine of regions for `lgs check --engine`. What is solid is kept in doubles.
//
//     npm ci --prefix examples/engines
//     lgs check --engine 'node examples/engines/ioverlay_regions.mjs' --edits 500
import { readFileSync } from 'node:fs'
import { FillRule, initSync, Overlay, OverlayRule, simplify } from 'ishape_wasm'
import { serve } from './regions.mjs'

initSync({ module: readFileSync(new URL(import.meta.resolve('ishape_wasm/ishape_wasm_bg.wasm'))) })

const overlay = (a, b, rule) => {
  if (a.length === 0 || b.length === 0) return rule === OverlayRule.Union ? [...a, ...b] : a
  return Overlay.new_with_subj_and_clip(a, b).overlay(rule, FillRule.EvenOdd)
}

serve({
  greeting: 'iOverlay regions slants round=1',
  nothing: [],
  regionOf: (rings) => simplify(rings, FillRule.EvenOdd) ?? [],
  unite: (a, b) => overlay(a, b, OverlayRule.Union),
  subtract: (a, b) => overlay(a, b, OverlayRule.Difference),
  ringsOf: (solid) => solid.flat(),
})
