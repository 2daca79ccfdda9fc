import * as inline from 'localgridseg/inline'
import * as lgs from 'localgridseg'

async function segments({ init, createWorld, unitSquare }) {
  await init()
  const world = createWorld()
  world.addPolygon(0, 0, unitSquare, 1)
  return world.commit().added.length
}

function ofWorker() {
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })
  return new Promise((done) => { worker.onmessage = ({ data }) => done(data) })
}

Promise.all([segments(lgs), segments(inline), ofWorker()]).then(([page, inlined, worker]) => {
  document.title = `done: page ${page}, inline ${inlined}, worker ${worker}`
})
