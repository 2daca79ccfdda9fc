// Links into the repository, whose address is that of the npm package. A page has data-repository="FILE"; while the
// package names none, such a link is not shown. A file that is not there ends the build.
import { existsSync } from 'node:fs'
import { readFile, writeFile } from 'node:fs/promises'

const { repository } = JSON.parse(await readFile(new URL('package/package.json', import.meta.url), 'utf8'))
const address = repository?.url.replace(/^git\+|\.git$/g, '')

export async function copyPage(from, to) {
  const text = await readFile(from, 'utf8')
  const link = (_, file) => {
    if (!existsSync(new URL(`../${file}`, import.meta.url))) throw new Error(`${from}: there is no ${file} in the repository`)
    return address === undefined ? 'class="nowhere"' : `href="${address}${file && `/blob/HEAD/${file}`}"`
  }
  await writeFile(to, text.replaceAll(/data-repository="([^"]*)"/g, link))
}
