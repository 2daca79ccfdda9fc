// Timings of the package in Node, round by round beside the native engine and others, in one run. It prints the tables of
// docs/timings.md, "In the browser".
//
//   cmake --preset release && cmake --build build/release --target lgs_web_native     (at the root of the project)
//   npm install && npm run bench                                                      (here; the package must be built)
import { fileURLToPath } from 'node:url'
import { makeSubjects, Native } from './subjects.mjs'

const rounds = Number(process.argv[2] ?? 15)
const editsARound = 20_000
const program = process.env.LGS_NATIVE ?? fileURLToPath(new URL('../../build/release/web/bench/lgs_web_native', import.meta.url))

const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]
const units = (ns) => (ns < 1e3 ? `${Math.round(ns)} ns` : ns < 1e6 ? `${(ns / 1e3).toPrecision(3)} µs` : `${(ns / 1e6).toPrecision(3)} ms`)

async function measure(kind, task, subjects, native) {
  const times = { native: [], ...Object.fromEntries(Object.keys(subjects).map((name) => [name, []])) }
  const editsNow = task === 'edits' ? ` ${editsARound}` : ''
  for (let round = -10; round < rounds; ++round) {  // the first ones warm up
    const [time, sum] = await native.ask(`${task} ${kind}${editsNow}`)
    const note = (name, ns) => { if (round >= 0) times[name].push(ns) }
    note('native', time)
    for (const [name, subject] of Object.entries(subjects)) {
      note(name, task === 'edits' ? subject.edits(editsARound) : subject.build())
      if (name === 'localgridseg' && subject.sum !== sum) throw new Error(`it read ${subject.sum}, the native engine ${sum}`)
    }
  }
  return Object.entries(times).map(([name, all]) => {
    const ratio = median(all.map((time, k) => time / times.native[k]))
    return `| ${name} | ${units(median(all))} | ${units(Math.min(...all))} | ${ratio < 10 ? ratio.toFixed(2) : Math.round(ratio)} |`
  })
}

const native = new Native(program)
for (const [kind, title] of [['full', 'full blocks'], ['ramps', 'random ramps']]) {
  const subjects = await makeSubjects(kind)
  const editing = Object.fromEntries(Object.entries(subjects).filter(([, subject]) => subject.digHoles))
  const builders = await makeSubjects(kind)
  for (const subject of Object.values(editing)) subject.digHoles()
  for (const [task, what, all] of [['edits', 'an edit', editing], ['build', 'a world from nothing', builders]]) {
    console.log(`\n| ${title}, ${what} | median | least | of native |\n|---|---:|---:|---:|`)
    for (const row of await measure(kind, task, all, native)) console.log(row)
  }
}
native.end()
