// Bugs in TypeScript, each as substitutions in files of src/; what a game would suffer is said first. Those in C++ are in
// proptests/bugs/. planted.test.js plants them. `runs`: which tests must each find it, by file and by how their names
// begin.
const buried = (...engines) => engines.map((engine) => ({ file: 'buried.test.js', begin: `${engine}:` }))

const bugIn = (runs) => (game, file, find, replace, ...more) => ({ game, edits: [{ file, find, replace }, ...more], runs })
const bug = bugIn(buried('planck', 'box2d3-wasm'))
const of = (engine, ...rest) => bugIn(buried(engine))(...rest)
const ofFiles = (...files) => bugIn(files.map((file) => ({ file, begin: '' })))
const ofIslands = ofFiles('islands.test.js'), ofPieces = ofFiles('pieces.test.js')
const ofFalling = ofFiles('planck-falling.test.js', 'box2d3-falling.test.js')
const ofPlanckFalling = ofFiles('planck-falling.test.js'), ofBox2dFalling = ofFiles('box2d3-falling.test.js')

export const bugs = [
  bug('who is walled in falls through the ground', 'bodies.ts', 'physics.setEnabled(body, false)', ''),
  bug('who was walled in and is dug out does not move any more', 'bodies.ts', 'if (way === null) return false', 'return false'),
  bug('who is pushed out of a block strikes it at once', 'bodies.ts', 'if (inward < 0) {', 'if (inward > 0) {'),
  bug('who is pushed is pushed too far, or not far enough', 'bodies.ts',
    'x: place.x + way.x / cellSize', 'x: place.x + way.x'),
  bug('a crate presses a small stone through the floor', 'bodies.ts',
    'last !== undefined && this.#isFreeAt(body, last)', 'last !== undefined && !this.#isFreeAt(body, last)'),
  bug('a stone that is shot while a crate lies on it is outside of the world', 'bodies.ts',
    'return this.#rules.crossed(', 'return false && this.#rules.crossed('),
  bug('portals through walls lead nowhere', 'bodies.ts', 'this.#footings.delete(this.#physics.keyOf(body)) }', 'void body }'),
  bug('after loading, bodies jump back to where they were', 'terrain-base.ts', "if (which === 'all') bodies.noteAll(box!)", ''),
  bug('after loading, who stands where a rock was falls through the ground', 'terrain-base.ts',
    'box !== null && catches ?', "box !== null && catches && which !== 'all' ?"),
  bug('who stands in a hole when its digging is undone falls through the ground', 'terrain-base.ts',
    'box !== null && catches ?', 'box !== null && catches && !(globalThis as any).hasRolled ?',
    { file: 'world.ts', find: 'commit(): Changes { return', replace: 'commit(): Changes { (globalThis as any).hasRolled = false; return' },
    { file: 'world.ts', find: "    whole('mark', mark)\n", replace: "    ;(globalThis as any).hasRolled = true\n    whole('mark', mark)\n" }),
  bug('who was held is forgotten when somebody else is', 'bodies.ts', 'this.#held.push(body)', 'this.#held = [body]'),
  bug('what a material lets through is not asked', 'terrain.ts',
    'return material === undefined || forms[form]!.holds(material)', 'return material === undefined || forms[form]!.holds({} as Material)'),
  of('planck', 'of a body of several shapes only one counts', 'planck-bodies.ts',
    'for (let fixture = body.getFixtureList(); fixture; fixture = fixture.getNext()) {\n      if (fixture.isSensor()) continue',
    'for (let fixture = body.getFixtureList(); fixture; fixture = null) {\n      if (fixture.isSensor()) continue'),
  of('planck', 'a shape is judged by its body, and not by its middle', 'planck-bodies.ts',
    '...point(m_centroid)', '...point({ x: 0, y: 0 })'),
  of('planck', 'what is turned is looked at as if it were upright', 'planck-bodies.ts',
    'cos: q.c, sin: q.s', 'cos: 1, sin: 0'),
  of('planck', 'after the origin has moved nobody is where the terrain believes', 'planck-bodies.ts',
    'x: p.x / cellSize + origin.i', 'x: p.x / cellSize'),
  of('planck', 'a platform that is placed throws the player aside', 'planck-bodies.ts',
    '!material.isPassable && collides(own, material)', 'collides(own, material)'),
  of('box2d3-wasm', 'of a body of several shapes only one counts', 'box2d3-bodies.ts',
    'for (const shape of box2d.b2Body_GetShapes(body, box2d.b2Body_GetShapeCount(body)))',
    'for (const shape of box2d.b2Body_GetShapes(body, 1))'),
  of('box2d3-wasm', 'a shape is judged by its body, and not by its middle', 'box2d3-bodies.ts',
    'middle = pointOf(polygon.centroid)', 'middle = { x: 0, y: 0 }'),
  of('box2d3-wasm', 'what is turned is looked at as if it were upright', 'box2d3-bodies.ts',
    'y: y / cellSize + origin.j, cos, sin }', 'y: y / cellSize + origin.j, cos: 1, sin: 0 * (cos + sin) }'),
  of('box2d3-wasm', 'after the origin has moved nobody is where the terrain believes', 'box2d3-bodies.ts',
    'x: x / cellSize + origin.i', 'x: x / cellSize'),
  of('box2d3-wasm', 'a platform that is placed throws the player aside', 'box2d3-bodies.ts',
    '!material.isPassable && this.#collides(shape, material)', 'this.#collides(shape, material)'),

  // Islands
  ofIslands('the game asks whether a cut would let the bridge fall, and the bridge falls', 'islands.ts',
    'if (!call.untryEdits(view, address, mark) || !wereEdits)', 'if (!wereEdits)'),
  ofIslands('what is cut off while something is tried is lost', 'islands.ts',
    "if (this.#isTrying) throw new LgsError('busy', 'what foresee() tries must only edit the world')", ''),
  ofIslands('a rock is taken that is another one by now', 'follower.ts', "if (this.isOfNow(at) === 0) throw misfit('left-out')", ''),
  ofIslands('a polygon that is not committed is said to be in the air', 'follower.ts',
    "if (this.isOfNow(at) === 2) throw misfit('uncommitted')", ''),
  ofIslands('changes of before are taken for those of now', 'follower.ts',
    ".after !== this.world.version) throw misfit('not-the-last')", ".after !== this.world.version) return"),
  ofIslands('who frees islands twice gets those of somebody else', 'follower.ts',
    "if (this.#view === 0) throw new LgsError('freed', 'this view was freed')", ''),
  ofIslands('of what is cut off only the larger part is named', 'islands.ts', 'into: ids[2 * k + 1]!', 'into: ids[2 * k]!'),
  ofIslands('two rocks that touch with a corner fall as one', 'islands.ts', 'return this.#take(id, 1)', 'return this.#take(id, 0)'),
  ofIslands('all parts of a rock weigh as much as the first one', 'ground-body.ts', 'mass: massIn(n, at + 3)', 'mass: massIn(n, 3)'),
  // Pieces
  ofPieces('a way that is pulled straight leads through a wall', 'pieces.ts',
    'right: [n[k + 3]!, n[k + 4]!], left: [n[k + 5]!, n[k + 6]!]', 'left: [n[k + 3]!, n[k + 4]!], right: [n[k + 5]!, n[k + 6]!]'),
  ofPieces('a monster walks through a wall that was built', 'pieces.ts', 'j: n[2 * k + 1]! }))\n  }\n\n  /** By', 'j: n[2 * k]! }))\n  }\n\n  /** By'),
  ofPieces('the physics engine refuses bodies with nine corners', 'pieces.ts', 'call.pieces(address, maxVertices)', 'call.pieces(address, 4096)'),
  ofPieces('monsters walk through full cells', 'pieces.ts', "part === 'free' ? 1 : 0", "part === 'free' ? 0 : 0"),
  ofPieces('a piece has the material of what was there before', 'pieces.ts',
    'world } = this.current\n    const n = this.from.answer(call.solidPieces', 'world } = this.at\n    const n = this.from.answer(call.solidPieces'),
  ofPieces('a ledge has another material than its rock', 'pieces.ts', 'block: n[k + 1]!', 'block: n[1]!'),
  ofPieces('who stands in a cave is told of its first piece', 'pieces.ts', 'return { i, j, index }', 'return { i, j, index: 0 * index }'),
  ofPieces('a piece of many corners takes those of the next one along', 'pieces.ts', 'const end = k + 1 + 2 * n[k]!', 'const end = k + 1 + 2 * n[0]!'),
  // Falling
  ofFalling('what is cut off appears at the other end of the level', 'falling-base.ts', 'this.#terrain.position(x, y)', 'this.#terrain.position(0, 0)'),
  ofFalling('a rock with an iron end does not tip over', 'falling-base.ts', 'this.#density(block)', 'this.#density(0)'),
  ofFalling('a settled rock hangs a centimetre above the floor, and falls again at once', 'falling-base.ts', 'const depth = gap + slop', 'const depth = 0 * (gap + slop)'),
  ofFalling('a rock that was pushed into a wall becomes part of it', 'falling-base.ts',
    'if (!this.#terrain.fits(body, { x: x - down.x * slop, y: y - down.y * slop, angle })) return false', ''),
  ofFalling('a rock is there twice, as ground and as a body in it', 'falling-base.ts', '    this.#maker.destroy(body)\n', ''),
  ofFalling('a long beam spins like a coin', 'falling-base.ts', '+ weight * (cx * cx + cy * cy)', '+ 0 * (cx * cx + cy * cy)'),
  ofPlanckFalling('a crumb of rock is a box of a square metre', 'falling-base.ts', '> 1.1 * this.#maker.slop', '> 0 * this.#maker.slop'),
  ofPlanckFalling('rocks turn as if they were of rubber', 'planck-falling.ts', 'I: inertia + mass * (center.x ** 2 + center.y ** 2)', 'I: inertia'),
  ofPlanckFalling('a rock that is dug free in a step ends the program', 'falling-base.ts', 'if (this.#terrain.isInStep) throw', 'if (false) throw'),
  ofBox2dFalling('what has fallen slides on everything', 'box2d3-bodies.ts', 'if (friction !== undefined) def.material.friction = friction', ''),
  ofBox2dFalling('a rock that leans to the left settles upright', 'box2d3-falling.ts', 'angle: Math.atan2(s, c)', 'angle: 0 * Math.atan2(s, c)'),
  ofBox2dFalling('a rock weighs what its shapes weigh', 'box2d3-falling.ts', 'if (body !== null) this.#setMass(body, mass)', 'if (body === null) this.#setMass(body!, mass)'),
]
