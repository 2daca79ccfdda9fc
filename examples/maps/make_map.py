#!/usr/bin/env python3
"""Draws landscape.tmx, landscape.tsx and landscape.png beside this file: the platformer map for verify.sh and tests.

Nothing is random: the script always draws the same map. Heights are in tiles from the map's lower edge, y up; tile
shapes are in pixels from a tile's upper left corner, y down, as Tiled has them.
"""
import math
import pathlib
import struct
import zlib

WIDTH, HEIGHT, TILE = 180, 48, 32
COLUMNS = 16  # of the tileset's image; one row for each material, one for the special tiles
MATERIALS = {"ground": (122, 92, 62), "stone": (128, 130, 140), "ice": (158, 214, 238)}
FLIP_X, FLIP_Y = 0x80000000, 0x40000000


def polygon(*points):
    return {"points": points}


def box(x, y, width, height, **more):
    return {"box": (x, y, width, height), **more}


def ramp(low, high):
    """A surface that rises from `low` to `high` pixels above the tile's bottom."""
    left = [(0, TILE - low)] if low else []
    return polygon((0, TILE), *left, (TILE, TILE - high), (TILE, TILE))


# The tiles that every material has. RAMPS[n] are the parts of a ramp that rises one tile in n columns.
KINDS = ["full", "half", "steep", "middle a", "middle b", "gentle a", "gentle b", "gentle c", "gentle d",
         "sloppy full", "sloppy steep", "mound", "stairs", "arch"]
RAMPS = {1: ["steep"], 2: ["middle a", "middle b"], 4: ["gentle a", "gentle b", "gentle c", "gentle d"]}
SHAPES = {
    "full": [box(0, 0, 32, 32)],
    "half": [box(0, 16, 32, 16)],
    "steep": [ramp(0, 32)],
    "middle a": [ramp(0, 16)],
    "middle b": [ramp(16, 32)],
    "gentle a": [ramp(0, 8)],
    "gentle b": [ramp(8, 16)],
    "gentle c": [ramp(16, 24)],
    "gentle d": [ramp(24, 32)],
    # Drawn by a hand that misses the tile's edge by a fraction of a pixel; the importer snaps these.
    "sloppy full": [polygon((0.2, -0.31), (31.75, 0.12), (32.3, 31.9), (-0.14, 32.22))],
    "sloppy steep": [polygon((0.31, 31.6), (32.4, -0.22), (31.72, 32.35))],
    "mound": [polygon((0, 32), (0, 26), (7, 20), (13, 25), (20, 14), (26, 22), (32, 26), (32, 32))],
    "stairs": [box(0, 16, 16, 16), box(16, 0, 16, 32)],
    "arch": [polygon((0, 0), (32, 0), *[(round(32 - 32 * math.cos(a * math.pi / 16), 2),
                                         round(32 - 32 * math.sin(a * math.pi / 16), 2)) for a in range(7, 0, -1)],
                     (0, 32))],
}
SPECIALS = ["bridge", "plank", "crystal", "boulder", "stalactite", "vein", "lean-to"]
SPECIAL_CLASS = {"bridge": "wood", "plank": "oneway", "crystal": "ice", "boulder": "stone", "stalactite": "stone",
                 "vein": "ground", "lean-to": "wood"}
SPECIAL_COLOUR = {"wood": (166, 118, 66), "oneway": (214, 172, 92), **MATERIALS}
SPECIAL_SHAPES = {
    "bridge": [box(0, 0, 32, 8), box(4, 8, 6, 24), box(22, 8, 6, 24)],
    "plank": [box(0, 0, 32, 6)],
    "crystal": [box(16, 3.7, 20, 20, rotation=45)],
    "boulder": [{"ellipse": (0, 4, 32, 28)}],
    "stalactite": [polygon((4, 0), (28, 0), (15, 44))],  # reaches into the tile below
    # One tile of two materials along a diagonal: the class of an object goes before that of its tile.
    "vein": [polygon((0, 0), (32, 32), (0, 32)), {**polygon((0, 0), (32, 0), (32, 32)), "class": "stone"}],
    "lean-to": [polygon((0, 0), (32, 20), (32, 26), (0, 8)), box(26, 26, 4, 6)],
}


def tile_id(material, kind):
    return list(MATERIALS).index(material) * COLUMNS + KINDS.index(kind)


def special_id(name):
    return len(MATERIALS) * COLUMNS + SPECIALS.index(name)


# --- The landscape ---------------------------------------------------------------------------------------------------

def walk(x, y, moves, underside=False):
    """Follows a surface. A move is (rise, run): rise 0 goes level for `run` columns, rise ±n climbs or falls n tiles by
    ramps of `run` columns each; None is a gap of `run` columns. Yields (x, height, kind, backwards) for each column; an
    underside has the parts of a ramp upside down, and so in the other order."""
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
        """Solid from the map's lower edge up to a surface."""
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
        """Solid between a surface and an underside."""
        for (cx, ty, tk, tb), (_, by, bk, bb) in zip(walk(x, top, top_moves), walk(x, bottom, bottom_moves, True)):
            for cy in range(by if bk == "level" else by + 1, ty):
                self.put(cx, cy, "full", material=material)
            if tk != "level":
                self.put(cx, ty, tk, FLIP_X if tb else 0, material)
            if bk != "level":  # an underside that falls grows thicker to the right
                self.under(cx, by, bk, bb, material)

    def under(self, x, y, kind, backwards, material=None):
        self.put(x, y, kind, FLIP_Y | (0 if backwards else FLIP_X), material)

    def cave(self, x, floor, floor_moves, roof, roof_moves):
        """Empty between a floor and a roof."""
        for (cx, fy, fk, fb), (_, ry, rk, rb) in zip(walk(x, floor, floor_moves), walk(x, roof, roof_moves, True)):
            for cy in range(fy, ry + (rk != "level")):
                self.terrain.pop((cx, cy), None)
            if fk != "level":
                self.put(cx, fy, fk, FLIP_X if fb else 0)
            if rk != "level":
                self.under(cx, ry, rk, rb)

    def next_solid(self, x, y, step):
        """The height of the first solid tile from y on, upwards (step 1) or downwards (-1), if it is a full square."""
        while 0 <= y < HEIGHT and (x, y) not in self.terrain:
            y += step
        full = [tile_id(material, "full") + 1 for material in MATERIALS]
        return y if self.terrain.get((x, y)) in full else None

    def clear(self, x, y, width, height):
        for cx in range(x, x + width):
            for cy in range(y, y + height):
                self.terrain.pop((cx, cy), None)


def draw():
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


def decorate(land):
    """Bridges over the gaps, an aqueduct of arches, stairs, planks, and small things in the caves."""
    gaps = [x for x in range(WIDTH) if land.surface.get(x) == 0]
    for x in gaps:
        edge = x
        while land.surface.get(edge) == 0:
            edge -= 1
        land.prop(x, land.surface[edge] - 1, "bridge")
    base = land.surface[148]
    for pier in range(4):  # each pier is two tiles wide and carries half an arch on either side
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
    for (x, y), gid in sorted(land.terrain.items()):  # veins of two materials, and hasty drawing
        if gid == tile_id("ground", "full") + 1 and (x * 3 + y * 5) % 23 == 0 and land.surface[x] - y > 2:
            land.terrain[x, y] = special_id("vein") + 1
        elif gid & ~(FLIP_X | FLIP_Y) == tile_id("ground", "steep") + 1 and x % 3 == 0:
            land.terrain[x, y] += KINDS.index("sloppy steep") - KINDS.index("steep")
        elif gid == tile_id("ground", "full") + 1 and (x + y * 3) % 17 == 0:
            land.terrain[x, y] += KINDS.index("sloppy full")


# --- Writing ---------------------------------------------------------------------------------------------------------

def all_tiles():
    """(id, class, shapes, colour) of each tile."""
    for material, colour in MATERIALS.items():
        for kind in KINDS:
            yield tile_id(material, kind), material, SHAPES[kind], colour
    for name in SPECIALS:
        yield special_id(name), SPECIAL_CLASS[name], SPECIAL_SHAPES[name], SPECIAL_COLOUR[SPECIAL_CLASS[name]]


def object_xml(number, shape):
    more = f' type="{shape["class"]}"' if "class" in shape else ""
    if "points" in shape:
        points = " ".join(f"{x:g},{y:g}" for x, y in shape["points"])
        return f'   <object id="{number}"{more} x="0" y="0">\n    <polygon points="{points}"/>\n   </object>\n'
    x, y, width, height = shape.get("box") or shape["ellipse"]
    head = f'   <object id="{number}"{more} x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}"'
    if "rotation" in shape:
        head += f' rotation="{shape["rotation"]:g}"'
    return head + (">\n    <ellipse/>\n   </object>\n" if "ellipse" in shape else "/>\n")


def tileset_xml():
    rows = len(MATERIALS) + 1
    out = ['<?xml version="1.0" encoding="UTF-8"?>\n'
           f'<tileset version="1.10" tiledversion="1.10.2" name="landscape" tilewidth="{TILE}" tileheight="{TILE}"'
           f' tilecount="{COLUMNS * rows}" columns="{COLUMNS}">\n'
           f' <image source="landscape.png" width="{COLUMNS * TILE}" height="{rows * TILE}"/>\n']
    for number, class_name, shapes, _ in all_tiles():
        out.append(f' <tile id="{number}" type="{class_name}">\n  <objectgroup draworder="index" id="2">\n')
        out += [object_xml(i, shape) for i, shape in enumerate(shapes, 1)]
        out.append("  </objectgroup>\n </tile>\n")
    return "".join(out) + "</tileset>\n"


def map_xml(land):
    out = ['<?xml version="1.0" encoding="UTF-8"?>\n'
           '<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down"'
           f' width="{WIDTH}" height="{HEIGHT}" tilewidth="{TILE}" tileheight="{TILE}" infinite="0" nextlayerid="3" nextobjectid="1">\n'
           ' <tileset firstgid="1" source="landscape.tsx"/>\n']
    for number, (name, tiles) in enumerate([("Terrain", land.terrain), ("Props", land.props)], 1):
        rows = [",".join(str(tiles.get((x, HEIGHT - 1 - row), 0)) for x in range(WIDTH)) for row in range(HEIGHT)]
        out.append(f' <layer id="{number}" name="{name}" width="{WIDTH}" height="{HEIGHT}">\n  <data encoding="csv">\n'
                   + ",\n".join(rows) + "\n</data>\n </layer>\n")
    return "".join(out) + "</map>\n"


def covers(shape, x, y):
    if "ellipse" in shape:
        left, top, width, height = shape["ellipse"]
        return ((x - left) / width - 0.5) ** 2 + ((y - top) / height - 0.5) ** 2 <= 0.25
    if "box" in shape:
        left, top, width, height = shape["box"]
        angle = math.radians(shape.get("rotation", 0))
        dx, dy = x - left, y - top
        return (0 <= dx * math.cos(angle) + dy * math.sin(angle) <= width and
                0 <= dy * math.cos(angle) - dx * math.sin(angle) <= height)
    inside = False
    points = shape["points"]
    for (x1, y1), (x2, y2) in zip(points, points[1:] + points[:1]):
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) * (x2 - x1) / (y2 - y1):
            inside = not inside
    return inside


def image_png():
    """The tiles as flat colours, so that the map can be opened in Tiled."""
    width, height = COLUMNS * TILE, (len(MATERIALS) + 1) * TILE
    pixels = bytearray(4 * width * height)
    for number, _, shapes, colour in all_tiles():
        left, top = number % COLUMNS * TILE, number // COLUMNS * TILE
        for y in range(TILE):
            for x in range(TILE):
                shape = next((s for s in shapes if covers(s, x + 0.5, y + 0.5)), None)
                if shape:
                    at = 4 * ((top + y) * width + left + x)
                    pixels[at:at + 4] = bytes(MATERIALS.get(shape.get("class"), colour)) + b"\xff"
    rows = b"".join(b"\0" + pixels[4 * width * y:4 * width * (y + 1)] for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    here = pathlib.Path(__file__).parent
    land = draw()
    decorate(land)
    (here / "landscape.tsx").write_text(tileset_xml(), encoding="utf-8")
    (here / "landscape.tmx").write_text(map_xml(land), encoding="utf-8")
    (here / "landscape.png").write_bytes(image_png())


if __name__ == "__main__":
    main()
