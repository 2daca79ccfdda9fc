"""The tiles of the project's map: materials and shapes.

Shapes are in pixels from a tile's upper left corner, y down, as Tiled has them.
"""
import math

TILE = 32  # pixels
COLUMNS = 16  # of the tileset's image; it has one row for each material, and one for the special tiles
MATERIALS = {"ground": (122, 92, 62), "stone": (128, 130, 140), "ice": (158, 214, 238)}


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
    # Drawn by a hand that misses the tile's edge by a fraction of a pixel. The importer snaps these.
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
    # One tile of two materials along a diagonal. The class of an object goes before the class of its tile.
    "vein": [polygon((0, 0), (32, 32), (0, 32)), {**polygon((0, 0), (32, 0), (32, 32)), "class": "stone"}],
    "lean-to": [polygon((0, 0), (32, 20), (32, 26), (0, 8)), box(26, 26, 4, 6)],
}


def tile_id(material, kind):
    return list(MATERIALS).index(material) * COLUMNS + KINDS.index(kind)


def special_id(name):
    return len(MATERIALS) * COLUMNS + SPECIALS.index(name)


def all_tiles():
    """Yields (id, class, shapes, colour) for each tile."""
    for material, colour in MATERIALS.items():
        for kind in KINDS:
            yield tile_id(material, kind), material, SHAPES[kind], colour
    for name in SPECIALS:
        yield special_id(name), SPECIAL_CLASS[name], SPECIAL_SHAPES[name], SPECIAL_COLOUR[SPECIAL_CLASS[name]]


def covers(shape, x, y):
    """Whether a shape covers a point of its tile."""
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
