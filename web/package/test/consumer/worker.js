import { init } from 'localgridseg/full'
import { segmentsOfASquare } from './square.js'

await init()
postMessage(segmentsOfASquare())
