#!/usr/bin/env python3
"""Draws landscape.tmx, landscape.tsx and landscape.png beside this file: the platformer map for verify.sh and tests.

Nothing is random, so the files are always the same.
"""
import pathlib
import struct
import zlib

from landscape import HEIGHT, WIDTH, draw
from tiles import COLUMNS, MATERIALS, TILE, all_tiles, covers


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
           f' width="{WIDTH}" height="{HEIGHT}" tilewidth="{TILE}" tileheight="{TILE}"'
           ' infinite="0" nextlayerid="3" nextobjectid="1">\n'
           ' <tileset firstgid="1" source="landscape.tsx"/>\n']
    for number, (name, tiles) in enumerate([("Terrain", land.terrain), ("Props", land.props)], 1):
        rows = [",".join(str(tiles.get((x, HEIGHT - 1 - row), 0)) for x in range(WIDTH)) for row in range(HEIGHT)]
        out.append(f' <layer id="{number}" name="{name}" width="{WIDTH}" height="{HEIGHT}">\n  <data encoding="csv">\n'
                   + ",\n".join(rows) + "\n</data>\n </layer>\n")
    return "".join(out) + "</map>\n"


def image_png():
    """The picture of the tiles, in flat colours. Tiled does not open the map without it."""
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
    (here / "landscape.tsx").write_text(tileset_xml(), encoding="utf-8")
    (here / "landscape.tmx").write_text(map_xml(land), encoding="utf-8")
    (here / "landscape.png").write_bytes(image_png())


if __name__ == "__main__":
    main()
