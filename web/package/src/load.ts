// The code of WebAssembly: from a module, from bytes, or from a URL.
import type { InitOptions } from './types.js'

export async function compile({ url, bytes, module }: InitOptions, beside: () => URL): Promise<WebAssembly.Module> {
  if (module) return module
  if (bytes) return WebAssembly.compile(bytes)
  const from = url === undefined ? beside() : url
  if (String(from).startsWith('file:')) {  // Node, whose fetch() takes no files
    const files = 'node:fs/promises'
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ files)
    return WebAssembly.compile(await readFile(new URL(from)))
  }
  const response = await fetch(from)
  if (!response.ok) throw new Error(`${response.url || from}: ${response.status} ${response.statusText}`)
  // Browsers keep code that they compiled from a stream. They want the right type for that; otherwise any will do.
  if (/^application\/wasm\b/.test(response.headers.get('content-type') ?? '')) return WebAssembly.compileStreaming(response)
  return WebAssembly.compile(await response.arrayBuffer())
}
