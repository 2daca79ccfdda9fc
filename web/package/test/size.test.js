// The size is a promise: what a page loads, with gzip. That of islands has Ground, and the bytes of its saves. Since going
// back reaches ground that is not in memory, the engine has some 6 kB more; since holes are clipped out of mixed ground,
// some 5 kB, of which 3 are won back where what few cells need is compiled for size; the importer has 1 kB more, as more
// maps are taken as they are meant. Islands with an open edge of memory take 3 kB, and
// the reference, with more laws, 11. A Ground whose window comes in over several calls, and that does all or nothing
// whatever its functions throw and whatever bytes it gets, takes 5. Short lists of segments take 2, which what is
// compiled for size gives back. Unloaded chunks in order, and a Ground that keeps bodies out of ground at the edge of
// memory, take 2; bodies in the reference's language of calls, 4. The code of `localgridseg` is compiled for speed, and takes two thirds of the time of
// `localgridseg/small`, which is compiled for size.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { gzipSync } from 'node:zlib'

/** A module and all that it imports. */
function withImports(file, found = new Set()) {
  if (found.has(file)) return found
  found.add(file)
  for (const [, path] of readFileSync(file, 'utf8').matchAll(/(?:from|import)\s*"(\.[^"]+)"/g))
    withImports(fileURLToPath(new URL(path, `file://${file}`)), found)
  return found
}
const dist = (name) => fileURLToPath(new URL(`../dist/${name}`, import.meta.url))
const gzip = (file) => gzipSync(readFileSync(file), { level: 9 }).length

for (const [module, wasm, limit] of [
  ['index.js', 'lgs.wasm', 190_000], ['small.js', 'lgs-small.wasm', 156_500], ['islands.js', 'lgs-islands.wasm', 288_500],
  ['full.js', 'lgs-full.wasm', 368_000], ['oracle.js', 'lgs-oracle.wasm', 422_500]])
  test(`${module} and ${wasm}: at most ${limit} bytes`, (t) => {
    const files = [...withImports(dist(module)), dist(wasm)]
    const bytes = files.reduce((sum, file) => sum + gzip(file), 0)
    t.diagnostic(`${bytes} bytes in ${files.length} files`)
    assert.ok(files.length > 2)
    assert.ok(bytes <= limit, `${bytes} bytes`)
  })
