// Asks the naive reference about a trace. It loads when it is first asked.
import type { Answer, Question } from './reference-worker.js'

export function askReference(question: Question): Promise<string> {
  const worker = new Worker(new URL('reference-worker.js', import.meta.url), { type: 'module' })
  return new Promise((resolve, reject) => {
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => {
      worker.terminate()
      if ('error' in data) reject(new Error(data.error))
      else resolve(data.text)
    })
    worker.postMessage(question)
  })
}

/** The segments that only one of two dumps has: x, y, x, y of each, in cells. */
export function differences(a: string, b: string): Float64Array {
  const [inA, inB] = [a, b].map((dump) => new Set(dump.split('\n')))
  const alone = [...inA].filter((line) => !inB.has(line)).concat([...inB].filter((line) => !inA.has(line)))
  return Float64Array.from(alone.flatMap((line) => line.split(' ').slice(1, 5).map((units) => Number(units) / 65536)))
}
