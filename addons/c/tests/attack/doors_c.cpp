// Doors of the C interface: what C++ refuses is refused there as well, and so is each NULL that must not be. Pointers
// lead to as much memory as they should: nobody checks that.
#include "c_values.h"

namespace lgs::test {
namespace {

void addShapes(Doors& door) {
  door("lgs_shape", [](Scene& s, Given w, const Ring<lgs_local_point>& p, Out<lgs_shape_id> out, Out<lgs_error> e) {
    return checked(lgs_shape(worldOf(s, w), p.data(), p.size(), out, e), w && p.isThere());
  });
  door("lgs_shape_floats",
       [](Scene& s, Given w, const Ring<lgs_float_point>& p, Out<lgs_shape_id> out, Out<lgs_error> e) {
         return checked(lgs_shape_floats(worldOf(s, w), p.data(), p.size(), out, e), w && p.isThere());
       });
  door("lgs_shape_doubles",
       [](Scene& s, Given w, const Ring<lgs_double_point>& p, Out<lgs_shape_id> out, Out<lgs_error> e) {
         return checked(lgs_shape_doubles(worldOf(s, w), p.data(), p.size(), out, e), w && p.isThere());
       });
  door("lgs_shape_of_several",
       [](Scene& s, Given w, const std::vector<Points>& all, Given counted, Out<lgs_shape_id> out, Out<lgs_error> e) {
         std::vector<lgs_local_point> points;
         std::vector<std::uint32_t> counts;
         for (const Points& p : all) {
           counts.push_back(static_cast<std::uint32_t>(p.size()));
           for (const LocalPoint v : p) points.push_back({v.x, v.y});
         }
         return checked(lgs_shape_of_several(worldOf(s, w), points.data(), counted.of(counts), counts.size(), out, e),
                        w && counted.hasAll(counts));
       });
  door("lgs_shape_polygons", [](Scene& s, Given w, ShapeId id, Out<std::size_t> out) {
    return checked(lgs_shape_polygons(worldOf(s, w), toC(id), out), w);
  });
  door("lgs_shape_vertices",
       [](Scene& s, Given w, ShapeId id, std::uint64_t index, Space<lgs_local_point> vertices, Out<std::size_t> out) {
         return checked(lgs_shape_vertices(worldOf(s, w), toC(id), index, vertices.data(), vertices.size(), out), w);
       });
  door("lgs_shape_box", [](Scene& s, Given w, ShapeId id, Out<lgs_local_box> out) {
    return checked(lgs_shape_box(worldOf(s, w), toC(id), out), w);
  });
}

void addEdits(Doors& door) {
  door("lgs_add", [](Scene& s, Given w, Cell c, ShapeId id, std::uint32_t b, Out<lgs_polygon_id> out,
                     Out<lgs_error> e) { return checked(lgs_add(worldOf(s, w), toC(c), toC(id), b, out, e), w); });
  door("lgs_add_several", [](Scene& s, Given w, Cell c, ShapeId id, Space<lgs_polygon_id> ids, Out<lgs_error> e) {
    return checked(lgs_add_several(worldOf(s, w), toC(c), toC(id), 1, ids.data(), ids.size(), e), w && ids.isThere());
  });
  door("lgs_add_points",
       [](Scene& s, Given w, Cell c, const Ring<lgs_local_point>& p, std::uint32_t b, Out<lgs_polygon_id> out) {
         return checked(lgs_add_points(worldOf(s, w), toC(c), p.data(), p.size(), b, out, nullptr), w && p.isThere());
       });
  door("lgs_add_floats",
       [](Scene& s, Given w, Cell c, const Ring<lgs_float_point>& p, std::uint32_t b, Out<lgs_polygon_id> out) {
         return checked(lgs_add_floats(worldOf(s, w), toC(c), p.data(), p.size(), b, out, nullptr), w && p.isThere());
       });
  door("lgs_add_doubles",
       [](Scene& s, Given w, Cell c, const Ring<lgs_double_point>& p, std::uint32_t b, Out<lgs_polygon_id> out) {
         return checked(lgs_add_doubles(worldOf(s, w), toC(c), p.data(), p.size(), b, out, nullptr), w && p.isThere());
       });
  door("lgs_add_many",
       [](Scene& s, Given w, const std::vector<Placement>& all, Given list, Given out, Out<lgs_error> e) {
         std::vector<lgs_placement> placements;
         for (const Placement& p : all) placements.push_back({toC(p.cell), toC(p.shape), p.block});
         std::vector<lgs_polygon_id> ids(all.size());
         return checked(lgs_add_many(worldOf(s, w), list.of(placements), placements.size(), out.of(ids), e),
                        w && list.hasAll(all));
       });
  door("lgs_remove", [](Scene& s, Given w, PolygonHandle h, Out<lgs_error> e) {
    return checked(lgs_remove(worldOf(s, w), toC(h), e), w);
  });
  door("lgs_remove_many", [](Scene& s, Given w, const std::vector<PolygonHandle>& all, Given list, Out<lgs_error> e) {
    const auto ids = idsOf<lgs_polygon_id>(all);
    return checked(lgs_remove_many(worldOf(s, w), list.of(ids), ids.size(), e), w && list.hasAll(ids));
  });
  door("lgs_replace", [](Scene& s, Given w, Cell c, ShapeId id, std::uint32_t b, Space<lgs_polygon_id> ids) {
    return checked(lgs_replace(worldOf(s, w), toC(c), toC(id), b, ids.data(), ids.size(), nullptr), w && ids.isThere());
  });
  door("lgs_exchange", [](Scene& s, Given w, Cell c, const std::vector<PolygonHandle>& gone,
                          const std::vector<Points>& come, Given vertices, Given list, Out<lgs_error> e) {
    const auto removed = idsOf<lgs_polygon_id>(gone);
    std::vector<std::vector<lgs_local_point>> points;
    std::vector<lgs_new_polygon> added;
    for (const Points& p : come) points.push_back(listOf<lgs_local_point>(p));
    for (const auto& p : points) added.push_back({vertices.of(p), p.size(), 1, 0});
    std::vector<lgs_polygon_id> ids(added.size());
    return checked(lgs_exchange(worldOf(s, w), toC(c), list.of(removed), removed.size(), added.data(), added.size(),
                                list.of(ids), e),
                   w && list.hasAll(removed));
  });
  door("lgs_set_block", [](Scene& s, Given w, PolygonHandle h, std::uint32_t b, Out<lgs_error> e) {
    return checked(lgs_set_block(worldOf(s, w), toC(h), b, e), w);
  });
  door("lgs_fill", [](Scene& s, Given w, const CellRect& r, ShapeId id, std::uint32_t b, Out<std::uint64_t> out,
                      Out<lgs_error> e) { return checked(lgs_fill(worldOf(s, w), toC(r), toC(id), b, out, e), w); });
  door("lgs_clear", [](Scene& s, Given w, const CellRect& r, Out<std::uint64_t> out, Out<lgs_error> e) {
    return checked(lgs_clear(worldOf(s, w), toC(r), out, e), w);
  });
  door("lgs_begin", [](Scene& s, Given w, Given out, Cell c) {
    lgs_group* group = nullptr;
    const lgs_status status = checked(lgs_begin(worldOf(s, w), out(group)), w && out);
    if (status != LGS_OK) return status;
    const Seen before = seenOf(s.c.get());
    static_cast<void>(lgs_add(s.c.get(), toC(c), toC(s.shapes[0]), 1, nullptr, nullptr));
    lgs_undo(group);
    EXPECT_EQ(before, seenOf(s.c.get()));
    return status;
  });
  door("lgs_undo", [](Scene&) { lgs_undo(nullptr); });
  door("lgs_keep", [](Scene& s, Cell c, bool commits) {
    lgs_keep(nullptr);
    lgs_group* group = nullptr;
    EXPECT_EQ(lgs_begin(s.c.get(), &group), LGS_OK);
    static_cast<void>(lgs_add(s.c.get(), toC(c), toC(s.shapes[0]), 1, nullptr, nullptr));
    if (commits) static_cast<void>(lgs_commit(s.c.get(), nullptr));
    lgs_keep(group);
  });
  door("lgs_commit",
       [](Scene& s, Given w, Out<lgs_changes> out) { return checked(lgs_commit(worldOf(s, w), out), w); });
  door("lgs_commit_with", [](Scene& s, Given w, Given function, Out<lgs_changes> out, bool isFirst) {
    const lgs_executor_fn inTurn = [](void*, std::size_t count, lgs_job_fn run, void* job) {
      for (std::size_t k = 2 * count; k-- > 0;) run(job, k);
    };
    lgs_world* fresh = nullptr;
    EXPECT_EQ(lgs_new(nullptr, &fresh), LGS_OK);
    const CWorld owner(fresh);
    lgs_world* const world = isFirst && w ? fresh : worldOf(s, w);
    return checked(lgs_commit_with(world, function ? inTurn : nullptr, nullptr, out), w && function);
  });
  door("lgs_set_mark",
       [](Scene& s, Given w, Out<lgs_mark> out) { return checked(lgs_set_mark(worldOf(s, w), out), w && out); });
  door("lgs_roll_back", [](Scene& s, Given w, const lgs_mark& mark, Out<lgs_changes> out, Out<lgs_error> e) {
    return checked(lgs_roll_back(worldOf(s, w), mark, out, e), w);
  });
  door("lgs_roll_back_keeping", [](Scene& s, Given w, const lgs_mark& mark, Out<lgs_changes> out, Out<lgs_error> e) {
    return checked(lgs_roll_back_keeping(worldOf(s, w), mark, out, e), w);
  });
  door("lgs_redo", [](Scene& s, Given w, const lgs_mark& mark, Out<lgs_changes> out, Out<lgs_error> e) {
    return checked(lgs_redo(worldOf(s, w), mark, out, e), w);
  });
  door("lgs_forget", [](Scene& s, Given w, const lgs_mark& mark, Out<lgs_error> e) {
    return checked(lgs_forget(worldOf(s, w), mark, e), w);
  });
  door("lgs_forget_chunks", [](Scene& s, Given w, const CellRect& r, Out<std::uint64_t> out, Out<lgs_error> e) {
    return checked(lgs_forget_chunks(worldOf(s, w), toC(r), out, e), w);
  });
  // These are of a copy: what is unloaded would be missing to all others.
  door("lgs_unload",
       [](Scene& s, Given w, const CellRect& r, Given function, Out<std::uint64_t> out, Out<lgs_error> e) {
         lgs_world* copy = nullptr;
         EXPECT_EQ(lgs_copy(s.c.get(), &copy), LGS_OK);
         const lgs_chunk_fn take = [](void* user, lgs_cell, const std::uint8_t*, std::size_t) {
           static_cast<void>(lgs_count(static_cast<const lgs_world*>(user), nullptr));
         };
         const lgs_status status = lgs_unload(w ? copy : nullptr, toC(r), function ? take : nullptr, copy, out, e);
         lgs_free(copy);
         return checked(status, w);
       });
  door("lgs_reload",
       [](Scene& s, Given w, const std::vector<std::byte>& file, Given list, Out<lgs_cell> out, Out<lgs_error> e) {
         return checked(lgs_reload(worldOf(s, w), list ? reinterpret_cast<const std::uint8_t*>(file.data()) : nullptr,
                                   file.size(), out, e),
                        w && list.hasAll(file));
       });
  door("lgs_reload_empty", [](Scene& s, Given w, const CellRect& r, Out<std::uint64_t> out, Out<lgs_error> e) {
    return checked(lgs_reload_empty(worldOf(s, w), toC(r), out, e), w);
  });
  door("lgs_first_unloaded", [](Scene& s, Given w, const CellRect& r, Out<std::int32_t> out, Out<lgs_cell> cell) {
    return checked(lgs_first_unloaded(worldOf(s, w), toC(r), out, cell), w);
  });
}

void addReading(Doors& door) {
  door("lgs_segments",
       [](Scene& s, Given w, const std::vector<SegmentId>& all, Given list, Given out, Out<lgs_error> e) {
         const auto ids = idsOf<lgs_segment_id>(all);
         std::vector<lgs_segment> segments(ids.size());
         return checked(lgs_segments(worldOf(s, w), list.of(ids), ids.size(), out.of(segments), e),
                        w && ((list && out) || ids.empty()));
       });
  door("lgs_segments_float",
       [](Scene& s, Given w, const std::vector<SegmentId>& all, Point origin, Given out, Out<lgs_error> e) {
         const auto ids = idsOf<lgs_segment_id>(all);
         std::vector<lgs_segment_float> segments(ids.size());
         return checked(lgs_segments_float(worldOf(s, w), ids.data(), ids.size(), toC(origin), out.of(segments), e),
                        w && out.hasAll(ids));
       });
  door("lgs_segments_double",
       [](Scene& s, Given w, const std::vector<SegmentId>& all, Point origin, Given out, Out<lgs_error> e) {
         const auto ids = idsOf<lgs_segment_id>(all);
         std::vector<lgs_segment_double> segments(ids.size());
         return checked(lgs_segments_double(worldOf(s, w), ids.data(), ids.size(), toC(origin), out.of(segments), e),
                        w && out.hasAll(ids));
       });
  door("lgs_all_segments", [](Scene& s, Given w, Space<lgs_segment_id> ids, Out<std::size_t> out) {
    return checked(lgs_all_segments(worldOf(s, w), ids.data(), ids.size(), out), w && ids.isThere());
  });
  door("lgs_segments_in", [](Scene& s, Given w, const CellRect& r, Space<lgs_segment_id> ids, Out<std::size_t> out) {
    return checked(lgs_segments_in(worldOf(s, w), toC(r), ids.data(), ids.size(), out), w && ids.isThere());
  });
  door("lgs_polygon_of", [](Scene& s, Given w, PolygonHandle h, Out<lgs_polygon> out, Out<lgs_error> e) {
    return checked(lgs_polygon_of(worldOf(s, w), toC(h), out, e), w);
  });
  door("lgs_polygon_vertices",
       [](Scene& s, Given w, PolygonHandle h, Space<lgs_local_point> vertices, Out<std::size_t> out, Out<lgs_error> e) {
         return checked(lgs_polygon_vertices(worldOf(s, w), toC(h), vertices.data(), vertices.size(), out, e), w);
       });
  door("lgs_owner", [](Scene& s, Given w, SegmentId id, Out<lgs_polygon> out, Out<lgs_error> e) {
    return checked(lgs_owner(worldOf(s, w), toC(id), out, e), w);
  });
  door("lgs_polygons_in", [](Scene& s, Given w, Cell c, Space<lgs_polygon> polygons, Out<std::size_t> out) {
    return checked(lgs_polygons_in(worldOf(s, w), toC(c), polygons.data(), polygons.size(), out),
                   w && polygons.isThere());
  });
  door("lgs_is_empty", [](Scene& s, Given w, Cell c, Out<std::int32_t> out) {
    return checked(lgs_is_empty(worldOf(s, w), toC(c), out), w);
  });
  door("lgs_visit_polygons", [](Scene& s, Given w, const CellRect& r, Given function) {
    const lgs_polygon_fn visit = [](void* user, const lgs_polygon* p, const lgs_local_point*) {
      static_cast<void>(lgs_polygon_of(static_cast<const lgs_world*>(user), p->id, nullptr, nullptr));
    };
    return checked(lgs_visit_polygons(worldOf(s, w), toC(r), function ? visit : nullptr, s.c.get()), w && function);
  });
  door("lgs_follow_cells", [](Scene& s, Given w, int follow, Out<lgs_error> e) {
    return checked(lgs_follow_cells(worldOf(s, w), follow, e), w);
  });
  door("lgs_visit_cell_changes", [](Scene& s, Given w, Given function) {
    const lgs_cell_change_fn visit = [](void* user, const lgs_cell_change* change) {
      static_cast<void>(lgs_is_empty(static_cast<const lgs_world*>(user), change->cell, nullptr));
    };
    return checked(lgs_visit_cell_changes(worldOf(s, w), function ? visit : nullptr, s.c.get()), w && function);
  });
  door("lgs_bounds",
       [](Scene& s, Given w, Out<lgs_cell_rect> out) { return checked(lgs_bounds(worldOf(s, w), out), w); });
  door("lgs_loops_new", [](Scene& s, Given w, int collinear, Given out) {
    lgs_loops* loops = nullptr;
    const lgs_status status = lgs_loops_new(worldOf(s, w), collinear, out(loops));
    lgs_loops_free(loops);
    return checked(status, w && out && (collinear == 0 || collinear == 1));
  });
  door("lgs_loops_count", [](Scene&) { return lgs_loops_count(nullptr); });
  door("lgs_loops_get", [](Scene& s, Given list, std::uint64_t index, Out<lgs_loop> out) {
    lgs_loops* loops = nullptr;
    EXPECT_EQ(lgs_loops_new(s.c.get(), LGS_MERGE, &loops), LGS_OK);
    const bool isThere = index < lgs_loops_count(loops);
    const lgs_status status = lgs_loops_get(list ? loops : nullptr, index, out);
    lgs_loops_free(loops);
    return checked(status, list && isThere);
  });
  door("lgs_loops_free", [](Scene&) { lgs_loops_free(nullptr); });
  door("lgs_at",
       [](Scene& s, Given w, Point p, Out<lgs_spot> out) { return checked(lgs_at(worldOf(s, w), toC(p), out), w); });
  door("lgs_nearest", [](Scene& s, Given w, Point p, double radius, Out<lgs_nearest_segment> out, Out<lgs_error> e) {
    return checked(lgs_nearest(worldOf(s, w), toC(p), radius, out, e), w);
  });
  door("lgs_ray_cast", [](Scene& s, Given w, Point from, Point to, Out<lgs_ray_hit> out, Out<lgs_error> e) {
    return checked(lgs_ray_cast(worldOf(s, w), toC(from), toC(to), out, e), w);
  });
}

void addWorlds(Doors& door) {
  door("lgs_default_world_options", [](Scene&, Given out, Said size) {
    struct {
      lgs_world_options options;
      std::array<unsigned char, 300> after;
    } memory{};
    memory.after.fill(0xa5);
    lgs_default_world_options(out(memory.options), std::min(size.count, sizeof memory.options));
    EXPECT_EQ(memory.after[0], 0xa5);
  });
  door("lgs_new", [](Scene&, Given o, std::uint32_t size, std::uint32_t reserved, Given out) {
    lgs_world_options options{};
    lgs_default_world_options(&options, sizeof options);
    options.size = size == 1 ? options.size : size;
    options.reserved = reserved - 1;  // the plain value is 1
    lgs_world* made = nullptr;
    const lgs_status status = lgs_new(o ? &options : nullptr, out(made));
    EXPECT_EQ(status == LGS_OK, made != nullptr);
    lgs_free(made);
    return checked(status, out);
  });
  door("lgs_free", [](Scene&) { lgs_free(nullptr); });
  door("lgs_copy", [](Scene& s, Given w, Given out) {
    lgs_world* copy = nullptr;
    const lgs_status status = lgs_copy(worldOf(s, w), out(copy));
    EXPECT_TRUE(!copy || seenOf(copy) == seenOf(s.c.get()));
    lgs_free(copy);
    return checked(status, w && out);
  });
  door("lgs_same_polygons", [](Scene& s, Given a, Given b, Out<std::int32_t> out) {
    return checked(lgs_same_polygons(worldOf(s, a), worldOf(s, b), out), a && b);
  });
  door("lgs_preserves", [](Scene& s, Given w, std::uint32_t a, std::uint32_t b, Out<std::int32_t> out) {
    return checked(lgs_preserves(worldOf(s, w), a, b, out), w);
  });
  door("lgs_save", [](Scene& s, Given w, Given function, Out<lgs_error> e) {
    const lgs_write_fn write = [](void* user, const std::uint8_t*, std::size_t) {
      static_cast<void>(lgs_count(static_cast<const lgs_world*>(user), nullptr));
    };
    return checked(lgs_save(worldOf(s, w), function ? write : nullptr, s.c.get(), e), w && function);
  });
  door("lgs_save_to_buffer", [](Scene& s, Given w, Space<std::uint8_t> bytes, Out<std::size_t> out, Out<lgs_error> e) {
    return checked(lgs_save_to_buffer(worldOf(s, w), bytes.data(), bytes.size(), out, e), w && bytes.isThere());
  });
  door("lgs_load", [](Scene&, const std::vector<std::byte>& file, Given list, Given out, Out<lgs_error> e) {
    lgs_world* loaded = nullptr;
    const lgs_status status = lgs_load(list ? reinterpret_cast<const std::uint8_t*>(file.data()) : nullptr, file.size(),
                                       nullptr, out(loaded), e);
    EXPECT_EQ(status == LGS_OK, loaded != nullptr);
    lgs_free(loaded);
    return checked(status, out && list.hasAll(file));
  });
  door("lgs_count", [](Scene& s, Given w, Out<lgs_stats> out) { return checked(lgs_count(worldOf(s, w), out), w); });
  door("lgs_world_version", [](Scene& s, Given w) { return lgs_world_version(worldOf(s, w)); });
  door("lgs_max_segment_id", [](Scene& s, Given w) { return lgs_max_segment_id(worldOf(s, w)); });
}

void addValues(Doors& door) {
  door("lgs_store_shape",
       [](Scene&, ShapeId id) { EXPECT_EQ(lgs_load_shape(lgs_store_shape(toC(id))).value, id.value); });
  door("lgs_store_polygon",
       [](Scene&, PolygonHandle h) { EXPECT_EQ(lgs_load_polygon(lgs_store_polygon(toC(h))).serial, h.serial); });
  door("lgs_store_segment",
       [](Scene&, SegmentId id) { EXPECT_EQ(lgs_load_segment(lgs_store_segment(toC(id))).value, id.value); });
  door("lgs_store_mark",
       [](Scene&, const lgs_mark& mark) { EXPECT_EQ(lgs_load_mark(lgs_store_mark(mark)).value, mark.value); });
  // A number that no id was stored as names nothing.
  door("lgs_load_shape",
       [](Scene&, std::uint64_t v) { EXPECT_EQ(lgs_store_shape(lgs_load_shape(v)), v > UINT32_MAX ? 0 : v); });
  door("lgs_load_segment",
       [](Scene&, std::uint64_t v) { EXPECT_EQ(lgs_store_segment(lgs_load_segment(v)), v > UINT32_MAX ? 0 : v); });
  door("lgs_load_polygon", [](Scene&, std::uint64_t v) { EXPECT_EQ(lgs_store_polygon(lgs_load_polygon(v)), v); });
  door("lgs_load_mark", [](Scene&, std::uint64_t v) { EXPECT_EQ(lgs_store_mark(lgs_load_mark(v)), v); });
  door("lgs_lattice_point", [](Scene&, DoublePoint p) {
    const lgs_point q = lgs_lattice_point({p.x, p.y});
    EXPECT_EQ(latticePoint(p), (Point{q.x, q.y}));
  });
  door("lgs_cell_at", [](Scene&, Point p) {
    const lgs_cell cell = lgs_cell_at(toC(p));
    EXPECT_EQ(cellAt(p), (Cell{cell.i, cell.j}));
  });
  door("lgs_status_name", [](Scene&, int status) { EXPECT_NE(lgs_status_name(status), nullptr); });
  door("lgs_message", [](Scene&, const lgs_error& error, Given e, Room room, Given list, Out<std::size_t> out) {
    std::vector<char> text(room.size + 1, 'x');
    const lgs_status status = lgs_message(e ? &error : nullptr, list.of(text), room.size, out);
    EXPECT_EQ(text.back(), 'x');
    return checked(status, e && (list || room.size == 0));
  });
  door("lgs_version", [](Scene&) { return lgs_version(); });
}

}  // namespace

void addDoorsOfC(Doors& door) {
  addValues(door);
  addWorlds(door);
  addShapes(door);
  addEdits(door);
  addReading(door);
}

}  // namespace lgs::test
