// A page that uses the package as a game would: here, and in a worker.
import { init } from 'localgridseg'
import { segmentsOfASquare } from './square.js'

const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })
const answer = new Promise((resolve) => { worker.onmessage = ({ data }) => resolve(data) })
await init()
document.body.dataset.page = segmentsOfASquare()
document.body.dataset.worker = await answer
