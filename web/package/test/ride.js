// A body rides over the ground, and kicks are counted: pushes in a direction that the ground does not have there
// (docs/reports/box2d.md, The ride). For planck.
const near = 0.06 // metres
const leastKick = 0.01 // metres a second
const degree = Math.PI / 180
// The ground has a direction if it has it to within a degree. But polygons: planck takes the direction of a polygon's
// face for that of an edge if the cosine between them is at least 1 - angularSlop, which is 15.2 degrees.
const toleranceOf = (fixture) => Math.sin((fixture.getType() === 'circle' ? 1 : 15.5) * degree)

/** The true surface. Cells are of one metre. */
export class Surface {
  #facets = new Map()

  constructor(world) {
    const { geometry: g, cell, length } = world.segments()
    for (let k = 0; k < length; ++k) {
      const at = 8 * k
      const facet = {
        start: [g[at], g[at + 1]],
        end: [g[at + 2], g[at + 3]],
        normal: normalOf(g[at], g[at + 1], g[at + 2], g[at + 3]),
      }
      facet.next = normalOf(g[at + 2], g[at + 3], g[at + 6], g[at + 7])
      facet.convex = cross(facet.normal, facet.next) > 0
      const key = `${cell[2 * k]} ${cell[2 * k + 1]}`
      if (!this.#facets.has(key)) this.#facets.set(key, [])
      this.#facets.get(key).push(facet)
    }
  }

  /** Whether a side near the point, or a convex corner between two sides, faces this way. */
  faces(x, y, normal, tolerance) {
    for (let i = Math.floor(x - near); i <= Math.floor(x + near); ++i) {
      for (let j = Math.floor(y - near); j <= Math.floor(y + near); ++j) {
        for (const f of this.#facets.get(`${i} ${j}`) ?? []) {
          if (distance(f, x, y) > near) continue
          if (isAlong(f.normal, normal, tolerance)) return true
          if (!f.convex || Math.hypot(x - f.end[0], y - f.end[1]) > near) continue
          if (isAlong(f.next, normal, tolerance) || (cross(f.normal, normal) > 0 && cross(normal, f.next) > 0))
            return true
        }
      }
    }
    return false
  }
}

/** Steps the world, and returns the number of kicks of a body and its path: x, y, vx, vy of each step. */
export function ride(physics, surface, body, { steps, drive = 0 }) {
  const odd = new Map() // of each contact: whether its points push in a direction that the surface does not have
  let strongest = 0
  physics.on('pre-solve', (contact) => {
    const isA = contact.getFixtureA().getBody() === body
    const { normal, points, pointCount } = contact.getWorldManifold(null)
    const outward = isA ? [-normal.x, -normal.y] : [normal.x, normal.y]
    const tolerance = toleranceOf(isA ? contact.getFixtureA() : contact.getFixtureB())
    odd.set(
      contact,
      points.slice(0, pointCount).map(({ x, y }) => !surface.faces(x, y, outward, tolerance)),
    )
  })
  physics.on('post-solve', (contact, impulse) => {
    odd.get(contact)?.forEach((isOdd, k) => {
      if (isOdd) strongest = Math.max(strongest, impulse.normalImpulses[k] / body.getMass())
    })
  })
  const path = []
  let kicks = 0
  let kicked = false
  for (let step = 0; step < steps; ++step) {
    if (drive !== 0)
      body.applyForceToCenter(
        { x: body.getMass() * Math.min(10, Math.max(-10, 60 * (drive - body.getLinearVelocity().x))), y: 0 },
        true,
      )
    odd.clear()
    strongest = 0
    physics.step(1 / 60, 8, 3)
    const kick = strongest >= leastKick
    if (kick && !kicked) ++kicks
    kicked = kick
    const { x, y } = body.getPosition()
    path.push([x, y, body.getLinearVelocity().x, body.getLinearVelocity().y])
  }
  return { kicks, path }
}

function normalOf(x0, y0, x1, y1) {
  const length = Math.hypot(x1 - x0, y1 - y0)
  return [(y1 - y0) / length, (x0 - x1) / length]
}

function cross(a, b) {
  return a[0] * b[1] - a[1] * b[0]
}

function isAlong(a, b, tolerance) {
  return a[0] * b[0] + a[1] * b[1] > 0 && Math.abs(cross(a, b)) <= tolerance
}

function distance({ start: [ax, ay], end: [bx, by] }, x, y) {
  const [ux, uy] = [bx - ax, by - ay]
  const t = Math.min(1, Math.max(0, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)))
  return Math.hypot(x - ax - t * ux, y - ay - t * uy)
}
