// The controls of the page that are not of a tool.
import { dump } from 'localgridseg/trace'
import { Facts } from './facts.js'
import { choose, element, onClick, radios } from './dom.js'
import { openFiles, openTrace, traceText } from './documents.js'
import type { Game, View } from './game.js'
import { forgetGround, keepGround, keptGround } from './keep.js'
import type { Loop } from './loop.js'
import { askReference, differences } from './reference.js'
import { sceneOf } from './scenes/all.js'
import { ScenePanel } from './scenes/panel.js'
import { copied, download, fromHash, toHash } from './share.js'
import { capture, restore, type State } from './state.js'
import type { Viewer } from './viewer.js'

const readFor = 5000 // milliseconds
const longest = 60_000 // characters: longer addresses are cut on their way

export class Ui {
  readonly #game: Game
  readonly #viewer: Viewer
  readonly #loop: Loop
  readonly #facts = new Facts()
  readonly #scenes: ScenePanel
  #scene: string | null = 'hills' // null: not of the menu
  #isKeeping = false // what is done here
  #forget = 0

  constructor(game: Game, viewer: Viewer, loop: Loop) {
    this.#game = game
    this.#viewer = viewer
    this.#loop = loop
    this.#scenes = new ScenePanel((id) => void this.#openScene(id), (text) => this.#say(text))
    this.#listenToGround()
    this.#setUpTime()
    this.#setUpGround()
    this.#setUpView()
    this.#setUpDocument()
    this.#viewer.labels = sceneOf('hills').labels!
    this.#viewer.home = sceneOf('hills')
  }

  /** Opens what the address holds, if it holds something; otherwise what was here last time. Whether there was any. */
  async openAddress(): Promise<boolean> {
    const kept = location.hash === '#tools' ? keptGround() : null
    let isOpen = false
    await this.#try(async () => {
      const held = await fromHash(kept ?? location.hash)
      if (held === null) return
      isOpen = true
      if (held.kind === 'trace') return this.#show(() => this.#game.open(openTrace(held.text)), null)
      const state = JSON.parse(held.text) as State
      await restore(state, this.#game)
      choose('view', state.worlds)
      this.#show(() => {}, state.scene)
      this.#viewer.lookAt(...state.view)
      if (kept !== null) this.#say('Your terrain from last time. Pick a scene to start over.')
    })
    return isOpen
  }

  async #openScene(id: string): Promise<void> {
    await this.#try(async () => {
      const { make, cast } = sceneOf(id)
      const document = await make()
      this.#show(() => this.#game.open(document, cast?.()), id)
      forgetGround()
    })
  }

  // What was edited is there again after the page was closed.
  async #keep(): Promise<void> {
    if (this.#isKeeping || !this.#game.ground.isEdited) return
    this.#isKeeping = true
    try {
      keepGround(await toHash(JSON.stringify(capture(this.#game, this.#viewer.camera, this.#scene))))
    } catch {
      forgetGround() // too large
    } finally {
      this.#isKeeping = false
    }
  }

  #listenToGround(): void {
    const { ground } = this.#game
    this.#game.onChange = (change) => {
      this.#viewer.layer.touch(change.cells)
      if (element<HTMLInputElement>('show-more').checked) this.#viewer.glow.note(change.changes, this.#game.mirror) // the key is there, too
      this.#viewer.differences = new Float64Array()
      if (change.what === 'fall') {
        if (!ground.isInStroke) setTimeout(() => void this.#keep()) // otherwise its end does that
        return
      }
      this.#facts.note(change)
    }
    ground.onRefusal = (message) => this.#say(message)
    ground.onBegin = () => {
      this.#facts.begin()
      element<HTMLButtonElement>('undo').disabled = !ground.canUndo
    }
    ground.onEnd = () => {
      element<HTMLButtonElement>('undo').disabled = !ground.canUndo
      element<HTMLButtonElement>('redo').disabled = !ground.canRedo
      void this.#keep()
    }
  }

  #setUpTime(): void {
    const play = element('play')
    const show = () => {
      play.textContent = this.#loop.playing ? 'Pause' : 'Play'
    }
    onClick('play', () => {
      this.#loop.playing = !this.#loop.playing
      show()
    })
    onClick('step', () => {
      this.#loop.playing = false
      show()
      this.#game.step()
    })
    element<HTMLInputElement>('slow').addEventListener('change', (event) => {
      this.#loop.slow = (event.target as HTMLInputElement).checked
    })
    onClick('restart', () => this.#game.restart())
    for (const button of document.querySelectorAll<HTMLElement>('[data-drive]')) {
      button.addEventListener('pointerdown', () => this.#game.drive(Number(button.dataset.drive)))
      button.addEventListener('keydown', ({ key }) => {
        if (key === 'Enter' || key === ' ') this.#game.drive(Number(button.dataset.drive))
      })
      for (const end of ['pointerup', 'pointerleave', 'pointercancel', 'keyup', 'blur'])
        button.addEventListener(end, () => this.#game.drive(0))
    }
  }

  #setUpGround(): void {
    onClick('undo', () => this.#game.ground.undo())
    onClick('redo', () => this.#game.ground.redo())
  }

  #setUpView(): void {
    for (const radio of radios('view')) {
      radio.addEventListener('change', () => {
        this.#game.view = radio.value as View
        element('panes').dataset.view = radio.value
        this.#viewer.showSides()
        this.#viewer.showHome()
      })
    }
    element<HTMLInputElement>('overlay').addEventListener('change', (event) => {
      this.#viewer.overlay = (event.target as HTMLInputElement).checked
    })
    onClick('zoom-in', () => this.#viewer.zoom(1.25))
    onClick('zoom-out', () => this.#viewer.zoom(0.8))
    onClick('zoom-fit', () => this.#viewer.fit())
    onClick('help', () => element<HTMLDialogElement>('help-dialog').showModal())
  }

  #setUpDocument(): void {
    onClick('copy', () => void this.#copyTrace())
    onClick('share', () => void this.#share())
    onClick('check', () => void this.#check())
    onClick('steps', () => void this.#steps())
    const input = element<HTMLInputElement>('file')
    onClick('open', () => input.click())
    input.addEventListener('change', () => {
      void this.#open([...input.files!])
      input.value = ''
    })
    addEventListener('hashchange', () => void this.openAddress())
    addEventListener('dragover', (event) => {
      event.preventDefault()
      document.body.classList.add('dropping')
    })
    addEventListener('dragleave', () => document.body.classList.remove('dropping'))
    addEventListener('drop', (event) => {
      event.preventDefault()
      document.body.classList.remove('dropping')
      void this.#open([...event.dataTransfer!.files])
    })
  }

  async #open(files: readonly File[]): Promise<void> {
    if (files.length === 0) return
    await this.#try(async () => {
      const { document, name, partial } = await openFiles(files)
      this.#show(() => this.#game.open(document), null)
      const { polygons } = document.world.stats()
      this.#say(`${name}: ${polygons} polygons.${partial ? ` Not all of it: ${partial}.` : ''}`)
    })
  }

  async #share(): Promise<void> {
    await this.#try(async () => {
      const hash = await toHash(JSON.stringify(capture(this.#game, this.#viewer.camera, this.#scene)))
      if (hash.length > longest) return this.#say('This terrain is too large for a link. Use "Copy trace" instead.')
      history.replaceState(null, '', hash)
      const isCopied = await copied(location.href)
      this.#say(`The link in the address bar now has your terrain, view and bodies${isCopied ? ', and is copied' : ''}.`)
    })
  }

  // Browsers give the clipboard only to pages of localhost or https. Elsewhere the trace is a file.
  async #copyTrace(): Promise<void> {
    await this.#try(async () => {
      const text = traceText(this.#game.ground.document)
      if (await copied(text)) return this.#say('The trace is copied. Replay it with: lgs replay FILE --check')
      download(text, 'ground.trace')
      this.#say('The browser does not let this page copy, so the trace is saved as ground.trace.')
    })
  }

  async #check(): Promise<void> {
    await this.#try(async () => {
      const { ground } = this.#game
      ground.commit()
      const shown = dump(ground.world)
      this.#say('The reference is computing …')
      const found = differences(shown, await askReference({ what: 'outline', trace: traceText(ground.document) }))
      this.#viewer.differences = found
      this.#say(
        found.length === 0
          ? `No mismatch: all ${ground.world.stats().segments} segments and their ghost vertices equal those of the reference.`
          : `MISMATCH with the reference: ${found.length / 4} segments, drawn thick.`,
      )
    })
  }

  // A trace as it was opened, and otherwise the ground. The tab must be opened before anything is waited for.
  async #steps(): Promise<void> {
    const { document, isEdited } = this.#game.ground, tab = window.open('', '_blank')
    const trace = (isEdited ? undefined : document.trace) ?? traceText(document)
    await this.#try(async () => {
      const page = await askReference({ what: 'page', trace })
      if (tab) tab.location = URL.createObjectURL(new Blob([page], { type: 'text/html' }))
    })
  }

  // Another document; `scene` is its name in the menu.
  #show(open: () => void, scene: string | null): void {
    open()
    this.#scene = scene
    this.#scenes.open = scene
    this.#viewer.labels = scene === null ? [] : (sceneOf(scene).labels ?? [])
    this.#viewer.home = scene === null ? null : sceneOf(scene)
    this.#say('')
    this.#facts.reset()
    this.#viewer.showSides()
    this.#viewer.layer.reset()
    this.#viewer.differences = new Float64Array()
    this.#viewer.showHome()
    this.#game.ground.onEnd()
  }

  async #try(action: () => Promise<void>): Promise<void> {
    try {
      await action()
    } catch (error) {
      this.#say((error as Error).message)
    }
  }

  #say(text: string): void {
    element('message').textContent = text
    clearTimeout(this.#forget)
    this.#forget = window.setTimeout(() => {
      element('message').textContent = ''
    }, readFor)
  }
}
