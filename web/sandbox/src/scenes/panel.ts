// The menu of scenes, and the code beside the scene that is open.
import { element, onClick, radios } from '../dom.js'
import { copied } from '../share.js'
import { sceneOf, scenes } from './all.js'
import { codes } from './code.js'

// No scenes, but what the menu ends with.
const anew = 'anew'

export class ScenePanel {
  readonly #menu = element<HTMLSelectElement>('scene')
  readonly #show = element<HTMLInputElement>('show-code')
  #open = 'hills'

  constructor(onChoose: (id: string) => void, say: (text: string) => void) {
    const own = new Option('Your terrain', '')
    own.hidden = true
    this.#menu.append(own, ...scenes.map(({ id, name }) => new Option(name, id)), new Option('Start over', anew))
    this.#menu.value = this.#open
    this.#menu.addEventListener('change', () => {
      const value = this.#menu.value === anew ? this.#open || scenes[0].id : this.#menu.value
      this.#menu.value = value
      this.#menu.blur()
      onChoose(value)
    })
    this.#show.addEventListener('change', () => this.#update())
    for (const radio of radios('language')) radio.addEventListener('change', () => this.#update())
    onClick('code-copy', () => void this.#copy(say))
  }

  /** Which scene is open; null if it is somebody's own ground, which has no code. */
  set open(id: string | null) {
    this.#open = this.#menu.value = id ?? ''
    this.#update()
  }

  #update(): void {
    const code = codes[this.#open]
    this.#show.disabled = code === undefined
    element('code').hidden = code === undefined || !this.#show.checked
    if (code === undefined) return
    element('code-title').textContent = sceneOf(this.#open).name
    element('code').querySelector('code')!.textContent = this.#text
  }

  get #text(): string {
    const isC = radios('language').some(({ value, checked }) => checked && value === 'cpp')
    return codes[this.#open][isC ? 'cpp' : 'js']
  }

  async #copy(say: (text: string) => void): Promise<void> {
    say((await copied(this.#text)) ? 'The code is copied.' : 'The browser does not let this page copy.')
  }
}
