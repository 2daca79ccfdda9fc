// The naive reference: what the outline of a trace must be, and the page that steps through it.
import { init, outline, page } from 'localgridseg/oracle'

const answers = { outline, page }
export interface Question {
  readonly what: keyof typeof answers
  readonly trace: string
}
export type Answer = { readonly text: string } | { readonly error: string }

addEventListener('message', async ({ data: { what, trace } }: MessageEvent<Question>) => {
  try {
    await init()
    postMessage({ text: answers[what](trace) } satisfies Answer)
  } catch (error) {
    postMessage({ error: (error as Error).message } satisfies Answer)
  }
})
