// Sounds of the digger, made here: no files. It is silent until somebody switches it on.
const steps = [0, 2, 4, 7, 9, 12] // of a scale in which everything fits together
const lowest = 392 // Hz

export class Sound {
  #context: AudioContext | null = null
  #noise: AudioBuffer | null = null
  #quietUntil = 0

  /** Browsers allow it after a click alone. */
  set isOn(on: boolean) {
    if (!on) void this.#context?.suspend()
    else if (this.#context === null) this.#begin()
    else void this.#context.resume()
  }

  /** Soil that is dug: not more often than one can hear. */
  scrape(): void {
    const now = performance.now()
    if (now < this.#quietUntil) return
    this.#quietUntil = now + 70
    this.#rush(900 + 500 * Math.random(), 0.09, 0.08)
  }

  /** Of something that fell; `hard` is from 0 to 1. */
  thud(hard: number): void {
    this.#rush(110 + 60 * Math.random(), 0.22, 0.2 + 0.8 * hard)
  }

  /** The nth thing that was won. */
  chime(nth: number): void {
    const c = this.#playing
    if (c === null) return
    const hertz = lowest * 2 ** (steps[nth % steps.length] / 12)
    for (const [times, loud] of [[1, 0.16], [2.01, 0.05]]) {
      const tone = c.createOscillator(), gain = this.#fading(c, loud, 0.7)
      tone.type = 'triangle'
      tone.frequency.value = times * hertz
      tone.connect(gain)
      tone.start()
      tone.stop(c.currentTime + 0.7)
    }
  }

  get #playing(): AudioContext | null {
    return this.#context?.state === 'running' ? this.#context : null
  }

  #begin(): void {
    const c = (this.#context = new AudioContext())
    this.#noise = c.createBuffer(1, c.sampleRate / 2, c.sampleRate)
    const samples = this.#noise.getChannelData(0)
    for (let k = 0; k < samples.length; ++k) samples[k] = 2 * Math.random() - 1
  }

  #rush(hertz: number, seconds: number, loud: number): void {
    const c = this.#playing
    if (c === null) return
    const source = c.createBufferSource(), filter = c.createBiquadFilter()
    source.buffer = this.#noise
    filter.type = 'lowpass'
    filter.frequency.value = hertz
    source.connect(filter).connect(this.#fading(c, loud, seconds))
    source.start(0, 0.2 * Math.random(), seconds)
  }

  #fading(c: AudioContext, loud: number, seconds: number): GainNode {
    const gain = c.createGain()
    gain.gain.setValueAtTime(loud, c.currentTime)
    gain.gain.exponentialRampToValueAtTime(0.0001, c.currentTime + seconds)
    gain.connect(c.destination)
    return gain
  }
}
