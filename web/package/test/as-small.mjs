// node --import ./as-small.mjs FILE: who imports 'localgridseg' gets 'localgridseg/small'.
import { register } from 'node:module'

register(`data:text/javascript,${encodeURIComponent(
  "export const resolve = (name, context, next) => next(name === 'localgridseg' ? 'localgridseg/small' : name, context)")}`)
