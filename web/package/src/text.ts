// Bytes as text and back: Base64, by what every browser and Node have.
import { LgsError } from './error.js'

export function textOf(bytes: Uint8Array): string {
  let text = ''
  for (let k = 0; k < bytes.length; k += 0x6000)  // a multiple of three, and not too many arguments
    text += btoa(String.fromCharCode(...bytes.subarray(k, k + 0x6000)))
  return text
}

export function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  let characters
  try {
    characters = atob(text)
  } catch (cause) {
    throw new LgsError('not-a-snapshot', 'this text is not what saveText() wrote', { cause })
  }
  return Uint8Array.from(characters, (c) => c.charCodeAt(0))
}
