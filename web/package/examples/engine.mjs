#!/usr/bin/env node
// The package as an engine of `lgs check`: the harness sends edits, and compares each answer with CGAL's.
//
//     lgs check --engine 'node web/package/examples/engine.mjs' --edits 20000
import { createInterface } from 'node:readline'
import { LgsError, createWorld, init } from 'localgridseg'
import { TracePlayer, dump, parseTrace, preserveOf } from 'localgridseg/trace'

await init()
let preserve = []
let player = null
let refusals = []

/** The world is made with the first edit, when the whole relation is known. */
function playing() {
  player ??= new TracePlayer(createWorld({ preserve: preserveOf({ preserve, edits: [] }) }))
  return player
}

function answer(line) {
  const [word, ...rest] = line.split(' ')
  if (word === 'lgs-engine') return 'lgs-engine 1 localgridseg-wasm ghosts blocks several slants preserve refuses\n'
  if (word === 'reset') {
    player?.world.free()
    player = null
    preserve = []
    refusals = []
  } else if (word === 'preserve') {
    preserve.push(rest.map(Number))
  } else if (word === 'commit') {
    const { world } = playing()
    world.commit()
    const lines = refusals.join('') + dump(world) + 'end\n'
    refusals = []
    return lines
  } else {
    const [edit] = parseTrace(`lgs-trace 1\n${line}`).edits
    try {
      playing().apply(edit)
    } catch (error) {
      if (!(error instanceof LgsError)) throw error
      refusals.push(`refused ${edit.kind === 'add' ? edit.name : edit.goes.name} ${error.code}\n`)
    }
  }
  return ''
}

for await (const line of createInterface({ input: process.stdin })) {
  const text = answer(line)
  if (text) process.stdout.write(text)
}
