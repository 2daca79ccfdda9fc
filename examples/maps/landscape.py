"""The landscape of the project's map: hills, caves, islands, and what stands on them.

Heights are in tiles from the map's lower edge, y up.
"""
import math

from tiles import KINDS, MATERIALS, RAMPS, special_id, tile_id

WIDTH, HEIGHT = 180, 48  # in tiles
FLIP_X, FLIP_Y = 0x80000000, 0x40000000  # Tiled's flags beside a tile's number


def walk(x, y, moves, underside=False):
    """Follows a surface, and yields (x, height, kind, backwards) for each column.

    A move is (rise, run). Rise 0 goes level for `run` columns. Rise ±n climbs or falls n tiles, by n ramps of `run`
    columns each. Rise None is a gap of `run` columns. On an underside the parts of a ramp are upside down, and so they
    come in the other order.
    """
    for rise, run in moves:
        for _ in range(max(1, abs(rise or 0))):
            if not rise:
                for _ in range(run):
                    yield x, y, None if rise is None else "level", False
                    x += 1
                continue
            kinds = RAMPS[run]
            if rise < 0:
                y -= 1
            for kind in kinds if (rise > 0) != underside else reversed(kinds):
                yield x, y, kind, rise < 0
                x += 1
            if rise > 0:
                y += 1


class Landscape:
    def __init__(self):
        self.terrain = {}
        self.props = {}
        self.surface = {}

    def material(self, x, y):
        top = self.surface.get(x, 0)
        if y >= 30 + round(1.5 * math.sin(x / 2)) and top - y < 5:
            return "ice"
        return "stone" if top - y > 5 + round(2 * math.sin(x / 5)) or y > 24 + round(math.sin(x)) else "ground"

    def put(self, x, y, kind, flips=0, material=None):
        self.terrain[x, y] = tile_id(material or self.material(x, y), kind) + 1 | flips

    def prop(self, x, y, name, flips=0):
        self.props[x, y] = special_id(name) + 1 | flips

    def hills(self, x, y, moves):
        """Fills the columns from the map's lower edge up to a surface."""
        columns = list(walk(x, y, moves))
        for cx, cy, kind, _ in columns:
            self.surface[cx] = cy if kind else 0
        for cx, cy, kind, backwards in columns:
            if kind is None:
                continue
            for below in range(cy):
                self.put(cx, below, "full")
            if kind != "level":
                self.put(cx, cy, kind, FLIP_X if backwards else 0)

    def island(self, x, top, top_moves, bottom, bottom_moves, material):
        """Fills what lies between a surface and an underside."""
        for (cx, ty, tk, tb), (_, by, bk, bb) in zip(walk(x, top, top_moves), walk(x, bottom, bottom_moves, True)):
            for cy in range(by if bk == "level" else by + 1, ty):
                self.put(cx, cy, "full", material=material)
            if tk != "level":
                self.put(cx, ty, tk, FLIP_X if tb else 0, material)
            if bk != "level":
                self.under(cx, by, bk, bb, material)

    def under(self, x, y, kind, backwards, material=None):
        self.put(x, y, kind, FLIP_Y | (0 if backwards else FLIP_X), material)

    def cave(self, x, floor, floor_moves, roof, roof_moves):
        """Empties what lies between a floor and a roof."""
        for (cx, fy, fk, fb), (_, ry, rk, rb) in zip(walk(x, floor, floor_moves), walk(x, roof, roof_moves, True)):
            for cy in range(fy, ry + (rk != "level")):
                self.terrain.pop((cx, cy), None)
            if fk != "level":
                self.put(cx, fy, fk, FLIP_X if fb else 0)
            if rk != "level":
                self.under(cx, ry, rk, rb)

    def next_solid(self, x, y, step):
        """Looks from y upwards (step 1) or downwards (-1) for a solid tile; its height, if it is a full square."""
        while 0 <= y < HEIGHT and (x, y) not in self.terrain:
            y += step
        full = [tile_id(material, "full") + 1 for material in MATERIALS]
        return y if self.terrain.get((x, y)) in full else None

    def clear(self, x, y, width, height):
        for cx in range(x, x + width):
            for cy in range(y, y + height):
                self.terrain.pop((cx, cy), None)


def draw_ground():
    """Hills and a mountain with caves, an overhang and floating islands."""
    land = Landscape()
    land.hills(0, 14, [(0, 6), (1, 4), (0, 3), (1, 2), (1, 4), (0, 5), (-1, 4), (-1, 2), (0, 4), (-2, 1), (0, 4),
                       (None, 6), (0, 4), (1, 2), (2, 1), (0, 3), (-1, 4), (0, 3), (1, 4), (1, 2), (3, 1), (0, 2),
                       (2, 2), (6, 1), (1, 2), (4, 1), (2, 2), (0, 4), (-1, 2), (-5, 1), (-2, 2), (0, 3),  # mountain
                       (-6, 1), (-1, 2), (-1, 4), (0, 6), (None, 4), (0, 11), (1, 4), (1, 2),
                       (0, 8), (-1, 2), (-2, 1), (0, 20), (1, 4), (0, 8)])
    for x, y in sorted(land.terrain):  # grassy bumps here and there on level ground
        if (x, y + 1) not in land.terrain and land.surface[x] == y + 1 and x % 9 == 4 and y < 24:
            if land.terrain[x, y] == tile_id("ground", "full") + 1:
                land.put(x, y + 1, "mound" if x % 2 else "half")

    # A cave system under the hills and the mountain, joined by shafts.
    land.cave(4, 7, [(1, 4), (0, 6), (-1, 4), (-1, 2), (0, 8)],
              8, [(1, 1), (1, 2), (0, 6), (-1, 4), (0, 3), (-1, 2), (0, 6)])
    land.cave(52, 5, [(0, 4), (1, 2), (0, 5), (-1, 4), (0, 6), (2, 1), (0, 9), (1, 4), (1, 2), (0, 6)],
              7, [(2, 1), (1, 2), (0, 6), (-1, 4), (1, 2), (0, 5), (2, 1), (0, 8), (1, 4), (0, 4), (-1, 2), (0, 6)])
    land.cave(72, 13, [(0, 5), (1, 4), (1, 2), (0, 6), (2, 1), (0, 10)],
              15, [(1, 2), (2, 1), (0, 6), (1, 4), (0, 5), (2, 2), (0, 6)])
    land.clear(75, 10, 2, 4)
    land.clear(60, 9, 2, 5)
    for x, y in [(60, 10), (70, 18), (79, 12), (14, 9)]:
        roof = land.next_solid(x, y, 1)
        if roof:
            land.prop(x, roof - 1, "stalactite")

    # An overhang on the mountain's far side, with a sloping underside.
    land.island(113, 26, [(0, 12)], 23, [(0, 5), (1, 4), (1, 2), (0, 1)], "stone")

    # Floating islands: gentle on top, hanging below.
    land.island(18, 29, [(1, 4), (0, 5), (-1, 4)], 29, [(-2, 1), (-1, 2), (0, 5), (1, 2), (2, 1)], "ground")
    land.island(68, 40, [(0, 2), (1, 4), (1, 2), (0, 3), (-2, 1), (0, 2)],
                40, [(-1, 2), (-2, 1), (0, 5), (1, 4), (2, 1)], "stone")
    land.island(128, 37, [(1, 1), (0, 5), (-1, 4)], 37, [(-1, 1), (-1, 2), (0, 3), (1, 2), (1, 2)], "ice")
    land.island(4, 38, [(1, 2), (0, 3), (-1, 2)], 38, [(-1, 1), (-1, 1), (0, 3), (2, 1)], "stone")
    land.island(40, 35, [(1, 2), (0, 4), (-1, 2)], 35, [(-2, 1), (0, 4), (2, 1)], "ice")
    land.island(150, 30, [(0, 3), (1, 4), (0, 4), (-1, 2), (0, 3)],
                29, [(-1, 4), (-2, 1), (0, 3), (1, 2), (1, 4), (0, 1)], "ground")
    return land


def add_bridges(land):
    """Bridges lead over the gaps, each at the height of the edge on its left."""
    for x in range(WIDTH):
        if land.surface.get(x) != 0:
            continue
        edge = x
        while land.surface.get(edge) == 0:
            edge -= 1
        land.prop(x, land.surface[edge] - 1, "bridge")


def add_aqueduct(land):
    """An aqueduct of arches, and the stairs up to it. Each pier is two tiles wide, with half an arch on either side."""
    base = land.surface[148]
    for pier in range(4):
        x = 142 + 6 * pier
        for y in range(base, base + 5):
            for cx in (x, x + 1):
                land.put(cx, y, "full", material="stone")
        for cx in range(x - 2, x + 4) if pier < 3 else range(x - 2, x + 2):
            land.put(cx, base + 5, "full", material="stone")
        land.put(x - 1, base + 4, "arch", FLIP_X, "stone")
        if pier < 3:
            land.put(x + 2, base + 4, "arch", 0, "stone")
    for step in range(6):
        x = 134 + step
        if step:
            for y in range(land.surface[x], base + step):
                land.put(x, y, "full", material="stone")
        land.put(x, max(base + step, land.surface[x]), "stairs", 0, "stone")


def add_things(land):
    """Planks in the air, and small things in the caves and on the hills."""
    for x, y, length in [(10, 22, 4), (32, 25, 3), (36, 28, 3), (50, 30, 4), (58, 27, 3), (128, 21, 4), (127, 26, 4),
                         (142, 28, 4)]:
        for cx in range(x, x + length):
            land.prop(cx, y, "plank")
    for x, y, name in [(12, 24, "boulder"), (121, 40, "boulder"), (172, 40, "boulder"), (20, 8, "boulder"),
                       (56, 7, "crystal"), (68, 15, "boulder"), (82, 17, "crystal"), (90, 12, "crystal")]:
        floor = land.next_solid(x, y, -1)
        if floor is not None and (x, floor + 1) not in land.terrain:
            land.prop(x, floor + 1, name)
    for x in (30, 106, 165):
        y = land.surface[x]
        if (x, y) not in land.terrain:
            land.prop(x, y, "lean-to")


def vary(land):
    """Turns some tiles into veins of two materials, and some into hastily drawn ones."""
    for (x, y), gid in sorted(land.terrain.items()):
        if gid == tile_id("ground", "full") + 1 and (x * 3 + y * 5) % 23 == 0 and land.surface[x] - y > 2:
            land.terrain[x, y] = special_id("vein") + 1
        elif gid & ~(FLIP_X | FLIP_Y) == tile_id("ground", "steep") + 1 and x % 3 == 0:
            land.terrain[x, y] += KINDS.index("sloppy steep") - KINDS.index("steep")
        elif gid == tile_id("ground", "full") + 1 and (x + y * 3) % 17 == 0:
            land.terrain[x, y] += KINDS.index("sloppy full")


def draw():
    """The whole landscape."""
    land = draw_ground()
    add_bridges(land)
    add_aqueduct(land)
    add_things(land)
    vary(land)
    return land
