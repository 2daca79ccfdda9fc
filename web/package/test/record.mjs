// An engine for `lgs check` that keeps what it is asked: each case as a trace, and its outline after each commit.
//   node record.mjs FOLDER
import { createInterface } from 'node:readline'
import { writeFileSync } from 'node:fs'
import { LgsError, createWorld, init } from 'localgridseg'
import { TracePlayer, dump, parseTrace, preserveOf } from 'localgridseg/trace'

const folder = process.argv[2]
await init()
let cases = -1, lines = [], dumps = [], player, refused = []

const text = () => ['lgs-trace 1', ...lines, ''].join('\n')
function keep() {
  if (cases >= 0) writeFileSync(`${folder}/${cases}.json`, JSON.stringify({ lines, dumps }))
  player?.world.free()
  lines = []
  dumps = []
  refused = []
  player = undefined
  ++cases
}

for await (const line of createInterface({ input: process.stdin })) {
  if (line.startsWith('lgs-engine')) {
    process.stdout.write('lgs-engine 1 recorder ghosts blocks several slants preserve refuses\n')
  } else if (line === 'reset') {
    keep()
  } else if (line.startsWith('preserve')) {
    lines.push(line)
  } else {
    player ??= new TracePlayer(createWorld({ preserve: preserveOf(parseTrace(text())) }))
    const [edit] = parseTrace(`lgs-trace 1\n${line}`).edits
    try {
      player.apply(edit)
      lines.push(line)
    } catch (error) {
      if (!(error instanceof LgsError)) throw error
      refused.push(`refused ${edit.name} ${error.code}\n`)
    }
    if (line !== 'commit') continue
    dumps.push([lines.length, dump(player.world)])
    process.stdout.write(refused.join('') + dumps.at(-1)[1] + 'end\n')
    refused = []
  }
}
keep()
