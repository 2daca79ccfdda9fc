// How things leave the page: in its address (deflated, in base64 that addresses can hold), by the clipboard, or as a
// file. An address holds a state (state.ts), or a trace: packed, or as it is, written for an address.
const prefixes = { state: '#state=', trace: '#trace=' } as const
const plain = '#plain='

export interface Held {
  readonly kind: keyof typeof prefixes
  readonly text: string
}

export async function toHash(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'))
  let binary = ''
  for (const byte of packed) binary += String.fromCharCode(byte)
  return prefixes.state + btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
}

export function holdsGround(hash: string): boolean {
  return [plain, ...Object.values(prefixes)].some((prefix) => hash.startsWith(prefix))
}

/** Null if the address holds nothing. Throws if it is damaged. */
export async function fromHash(hash: string): Promise<Held | null> {
  if (hash.startsWith(plain)) return { kind: 'trace', text: decodeURIComponent(hash.slice(plain.length)) }
  for (const kind of ['state', 'trace'] as const) {
    const prefix = prefixes[kind]
    if (!hash.startsWith(prefix)) continue
    try {
      return { kind, text: await unpacked(hash.slice(prefix.length)) }
    } catch {
      throw new Error('This link is damaged: a part of it is missing or was changed on its way.')
    }
  }
  return null
}

async function unpacked(text: string): Promise<string> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'))
  const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0))
  return new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw')))
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  const result = new Blob([bytes]).stream().pipeThrough(stream)
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
