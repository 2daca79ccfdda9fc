"""LocalGridSeg for Python, by ctypes: what a game needs of lgs/lgs.h, to use as it is or to carry on from.

    world = World("liblgs.so.0.3")
    square = world.shape([(0, 0), (65536, 0), (65536, 65536), (0, 65536)])
    floor = world.add((3, 4), square, block=7)
    removed, added, relinked = world.commit()

A refused call raises Refused, and has changed nothing. examples/ctypes_digging.py is a whole program.
"""
import ctypes
from ctypes import (CFUNCTYPE, POINTER, Structure, byref, c_double, c_int32, c_int64, c_size_t, c_uint8, c_uint32,
                    c_uint64, c_void_p)

UNITS_PER_CELL = 65536
OVERLAP, SHORT_BUFFER = 11, 101
Preserve = CFUNCTYPE(c_int32, c_void_p, c_uint32, c_uint32)


def struct(name, **fields):
    """A struct of lgs.h that can be compared and taken apart."""
    return type(name, (Structure,), {"_fields_": list(fields.items()),
                                     "__iter__": lambda self: (getattr(self, field) for field in fields)})


Id = struct("Id", value=c_uint32)  # of a shape or a segment
Id.__bool__ = lambda self: self.value != 0
PolygonId = struct("PolygonId", cell_ref=c_uint32, serial=c_uint32)
Mark = struct("Mark", value=c_uint64)
Cell = struct("Cell", i=c_int32, j=c_int32)
CellRect = struct("CellRect", min=Cell, max=Cell)
LocalPoint = struct("LocalPoint", x=c_int32, y=c_int32)
DoublePoint = struct("DoublePoint", x=c_double, y=c_double)
Point = struct("Point", x=c_int64, y=c_int64)
Placement = struct("Placement", cell=Cell, shape=Id, block=c_uint32)
Segment = struct("Segment", id=Id, predecessor=Id, successor=Id, block=c_uint32, polygon=PolygonId, cell=Cell,
                 start=Point, end=Point, ghost1=Point, ghost2=Point)
Error = struct("Error", code=c_int32, cell=Cell, polygon=c_int32, vertex=c_int32, vertex2=c_int32, polygon2=c_int32,
               other=PolygonId, other_block=c_uint32, segment=Id, index=c_int32, offset=c_uint64,
               index2=c_int32, reserved=c_uint32 * 3)
Changes = struct("Changes", removed=POINTER(c_uint32), added=POINTER(c_uint32), relinked=POINTER(c_uint32),
                 removed_count=c_size_t, added_count=c_size_t, relinked_count=c_size_t, before=c_uint64,
                 after=c_uint64)
Options = struct("Options", size=c_uint32, reserved=c_uint32, preserve=Preserve, user=c_void_p)


class Refused(Exception):
    def __init__(self, library, error):
        text = ctypes.create_string_buffer(1000)
        library.lgs_message(byref(error), text, c_size_t(len(text)), None)
        super().__init__(text.value.decode(errors="replace"))
        self.error = error


class World:
    """A world. `preserve` is a function of two blocks, or None."""

    def __init__(self, library, preserve=None):
        self.library = ctypes.CDLL(library)
        self.library.lgs_free.argtypes = [c_void_p]
        self.library.lgs_free.restype = None
        self.options = Options()
        self.library.lgs_default_world_options(byref(self.options), c_size_t(ctypes.sizeof(Options)))
        if preserve:
            self.options.preserve = Preserve(lambda _, a, b: preserve(a, b))
        self.world = c_void_p()
        self.call("lgs_new", byref(self.options), byref(self.world))

    def __del__(self):
        if self.world:
            self.library.lgs_free(self.world)

    def call(self, function, *arguments, error=None):
        status = getattr(self.library, function)(*arguments, *([byref(error)] if error is not None else []))
        if status not in (0, SHORT_BUFFER):
            raise Refused(self.library, error if error is not None else Error(code=status))

    def edit(self, function, *arguments):
        self.call(function, self.world, *arguments, error=Error())

    # --- Edits

    def shape(self, vertices):
        """A polygon, by lattice units in its cell."""
        shape = Id()
        self.edit("lgs_shape", array(LocalPoint, vertices), c_size_t(len(vertices)), byref(shape))
        return shape

    def add(self, cell, shape, block):
        polygon = PolygonId()
        self.edit("lgs_add", Cell(*cell), shape, c_uint32(block), byref(polygon))
        return polygon

    def add_points(self, cell, vertices, block):
        return self.add_vertices("lgs_add_points", cell, array(LocalPoint, vertices), block)

    def add_doubles(self, cell, vertices, block):
        """The same by cells: 1.0 is the far side."""
        return self.add_vertices("lgs_add_doubles", cell, array(DoublePoint, vertices), block)

    def add_vertices(self, function, cell, vertices, block):
        polygon = PolygonId()
        self.edit(function, Cell(*cell), vertices, c_size_t(len(vertices)), c_uint32(block), byref(polygon))
        return polygon

    def add_many(self, placements):
        """(cell, shape, block) each: all or none."""
        polygons = (PolygonId * len(placements))()
        wanted = array(Placement, [(Cell(*cell), shape, block) for cell, shape, block in placements])
        self.edit("lgs_add_many", wanted, c_size_t(len(placements)), polygons)
        return list(polygons)

    def remove(self, polygon):
        self.edit("lgs_remove", polygon)

    def remove_many(self, polygons):
        self.edit("lgs_remove_many", (PolygonId * len(polygons))(*polygons), c_size_t(len(polygons)))

    def clear(self, low, high):
        self.edit("lgs_clear", CellRect(Cell(*low), Cell(*high)), None)

    def commit(self):
        """The ids of the segments that were removed, added and relinked, as three lists."""
        changes = Changes()
        self.call("lgs_commit", self.world, byref(changes))
        return lists(changes)

    def mark(self):
        mark = Mark()
        self.call("lgs_set_mark", self.world, byref(mark))
        return mark

    def roll_back(self, mark):
        changes = Changes()
        self.edit("lgs_roll_back", mark, byref(changes))
        return lists(changes)

    # --- Reading

    def segments(self, ids):
        out = (Segment * len(ids))()
        self.edit("lgs_segments", (c_uint32 * len(ids))(*ids), c_size_t(len(ids)), out)
        return list(out)

    def all_segments(self):
        return self.listed("lgs_all_segments", c_uint32)

    def save(self):
        return bytes(self.listed("lgs_save_to_buffer", c_uint8, Error()))

    def load(self, saved):
        """Becomes the world that was saved."""
        data = (c_uint8 * len(saved)).from_buffer_copy(saved)
        other = c_void_p()
        self.call("lgs_load", data, c_size_t(len(saved)), byref(self.options), byref(other), error=Error())
        self.library.lgs_free(self.world)
        self.world = other

    def listed(self, function, kind, error=None):
        """What a function gives as a list: it is asked for the length first."""
        count = c_size_t()
        self.call(function, self.world, None, c_size_t(0), byref(count), error=error)
        out = (kind * count.value)()
        self.call(function, self.world, out, count, byref(count), error=error)
        return list(out)


def array(kind, values):
    return (kind * len(values))(*[kind(*value) for value in values])


def lists(changes):
    return (changes.removed[:changes.removed_count], changes.added[:changes.added_count],
            changes.relinked[:changes.relinked_count])
