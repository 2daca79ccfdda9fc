#!/usr/bin/env node
// polygon-clipping as an engine for `lgs check --engine`: it unites all polygons anew at each commit.
//
//     npm install polygon-clipping
//     lgs check --engine 'node examples/engines/polygon_clipping.cjs' --edits 2000
//
// Ghosts are the neighbours in the ring. They are not the laws' where rings touch, so `ghosts` is not promised.
'use strict'
const { createInterface } = require('node:readline')
const { union } = require('polygon-clipping')

const kUnits = 65536 // of the lattice, in a cell
let polygons = new Map()

function polygonOf([i, j, , ...numbers]) {
  const ring = []
  for (let k = 0; k < numbers.length; k += 2) ring.push([(i + numbers[k]) * kUnits, (j + numbers[k + 1]) * kUnits])
  return [ring]
}

// The solid is on the left: outer rings are counter-clockwise, holes clockwise.
function segmentsOf(ring) {
  const points = ring.slice(1).map(([x, y]) => `${Math.round(x)} ${Math.round(y)}`) // the last is the first again
  const at = (k) => points[(k + points.length) % points.length]
  return points.map((start, k) => `segment ${start} ${at(k + 1)} ${at(k - 1)} ${at(k + 2)} 0`)
}

function outline() {
  const united = polygons.size ? union(...polygons.values()) : []
  return united.flat().flatMap(segmentsOf)
}

const answers = {
  'lgs-engine': () => ['lgs-engine 1 polygon-clipping several slants merged'],
  reset() { polygons = new Map() },
  add(name, ...rest) { polygons.set(name, polygonOf(rest.map(Number))) },
  remove(name) { polygons.delete(name) },
  commit: () => [...outline(), 'end'],
}

createInterface({ input: process.stdin }).on('line', (line) => {
  const [word, ...rest] = line.split(' ')
  const lines = answers[word](...rest)
  if (lines) process.stdout.write(lines.join('\n') + '\n')
})
