// The article: starts the engine, and then each figure by itself. A figure that fails says so in its place, and the
// others go on.
import { init } from 'localgridseg'

type Make = (element: HTMLElement) => void | Promise<void>

const figures: Readonly<Record<string, () => Promise<{ default: Make }>>> = {
  seams: () => import('./figures/seams.js'),
  cuts: () => import('./figures/cuts.js'),
  cancel: () => import('./figures/cancel.js'),
  cells: () => import('./figures/cells.js'),
  fan: () => import('./figures/fan.js'),
  touch: () => import('./figures/touch.js'),
  ghosts: () => import('./figures/ghosts.js'),
  million: () => import('./figures/million.js'),
  rounding: () => import('./figures/rounding.js'),
  proof: () => import('./figures/proof.js'),
}

await Promise.all(
  [...document.querySelectorAll<HTMLElement>('figure')].map(async (element) => {
    try {
      await init()
      const { default: make } = await figures[element.id]()
      await make(element)
      element.dataset.ready = 'true'
    } catch (error) {
      element.querySelector('.stage')!.textContent = `This figure could not start: ${(error as Error).message}`
    }
  }),
)
document.body.dataset.ready = 'true'
