// Serves the built pages on localhost: node serve.js [PORT]. If the port is taken, on another one.
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname } from 'node:path'
import { pathToFileURL } from 'node:url'

const types = { '.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.wasm': 'application/wasm' }
const root = new URL('dist/', import.meta.url)

/** Listens on a port of localhost; 0 takes any that is free. The sandbox is in the folder, and the article in article/ below it. */
export async function serve(port, folder = '/') {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname
    try {
      if (!path.startsWith(folder)) throw new Error('outside')
      const file = new URL(path.slice(folder.length).replace(/(^|\/)$/, '$1index.html'), root)
      if (!file.pathname.startsWith(root.pathname)) throw new Error('outside')
      const body = await readFile(file)
      response.writeHead(200, { 'content-type': types[extname(file.pathname)] ?? 'application/octet-stream' }).end(body)
    } catch {
      response.writeHead(404).end('not found')
    }
  })
  await new Promise((resolve, reject) => server.once('error', reject).listen(port, 'localhost', resolve))
  return server
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const server = await serve(Number(process.argv[2] ?? 8080)).catch((error) => {
    if (error.code === 'EADDRINUSE') return serve(0)
    throw error
  })
  console.log(`open http://localhost:${server.address().port}`)
}
