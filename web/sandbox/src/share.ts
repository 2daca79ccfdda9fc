// How things leave the page: in its address (deflated, in base64 that addresses can hold), by the clipboard, or as a
// file. An address holds a state (state.ts), or a trace: packed, or as it is, written for an address.
const prefixes = { state: '#state=', trace: '#trace=' } as const
const plain = '#plain='

export interface Held {
  readonly kind: keyof typeof prefixes
  readonly text: string
}

export async function toHash(text: string): Promise<string> {
  return prefixes.state + (await pack(new TextEncoder().encode(text)))
}

/** As text that addresses can hold. */
export async function pack(bytes: Uint8Array): Promise<string> {
  const packed = await through(bytes, new CompressionStream('deflate-raw'))
  let binary = ''
  for (const byte of packed) binary += String.fromCharCode(byte)
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

/** Null if the address holds nothing. Throws if it is damaged. */
export async function fromHash(hash: string): Promise<Held | null> {
  if (hash.startsWith(plain)) return { kind: 'trace', text: decodeURIComponent(hash.slice(plain.length)) }
  for (const kind of ['state', 'trace'] as const) {
    const prefix = prefixes[kind]
    if (!hash.startsWith(prefix)) continue
    try {
      return { kind, text: new TextDecoder().decode(await unpack(hash.slice(prefix.length))) }
    } catch {
      throw new Error('This link is damaged: a part of it is missing or was changed.')
    }
  }
  return null
}

export async function unpack(text: string): Promise<Uint8Array> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'))
  return through(Uint8Array.from(binary, (letter) => letter.charCodeAt(0)), new DecompressionStream('deflate-raw'))
}

async function through(
  bytes: Uint8Array,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  const result = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(stream)
  return new Uint8Array(await new Response(result).arrayBuffer())
}

/** Whether the text is in the clipboard now. */
export async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    return false
  }
}

export function download(text: string, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(new Blob([text], { type: 'text/plain' }))
  link.download = name
  link.click()
  URL.revokeObjectURL(link.href)
}
