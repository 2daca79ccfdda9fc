// The part of the C interface: the calls of lgs/lgs.h, and hashes of the ground, with polygons as elsewhere
// (oracle/calls).
#include "parts.h"

#include "oracle/calls/draw.h"
#include "oracle/calls/random.h"

#include <lgs/lgs.h>
#include <lgs/lgs_views.h>

#include <vector>

namespace platform {
namespace {

/// Whether the relation of C is asked with the smaller block first.
std::int32_t keepsSomeOverlaps(void*, lgs_block smaller, lgs_block greater) {
  return smaller <= greater && (smaller + greater) % 3 == 0;
}

class CEditor {
 public:
  CEditor(lgs_world* world, Hash& hash, std::uint64_t seed) : world_(world), hash_(hash), choices_(seed) {}

  void edit();
  void commit();
  void read();

 private:
  lgs_cell cell() {
    const std::int32_t i = choices_.between(-3, 4), j = choices_.between(-3, 4);
    return {i, j};
  }
  std::vector<lgs_local_point> points() {
    std::vector<lgs_local_point> vertices;
    oracle::LocalPolygon polygon = drawPolygon(choices_);
    if (choices_.chance(10)) polygon = spoilt(choices_, polygon);
    for (const lgs::LocalPoint v : polygon) vertices.push_back({v.x, v.y});
    return vertices;
  }
  void put(lgs_status status);
  void put(lgs_polygon_id polygon) { hash_.number(lgs_store_polygon(polygon)); }
  void putIds(const lgs_segment_id* ids, std::size_t count) {
    hash_.number(count);
    for (std::size_t k = 0; k < count; ++k) hash_.number(ids[k].value);
  }
  lgs_polygon_id handle() { return handles_.empty() ? lgs_polygon_id{} : choices_.pick(handles_); }

  lgs_world* world_;
  Hash& hash_;
  oracle::Random choices_;
  lgs_error error_{};
  std::vector<lgs_shape_id> shapes_;
  std::vector<lgs_polygon_id> handles_;
};

void CEditor::put(lgs_status status) {
  hash_.sign(status);
  if (status == LGS_OK) return;
  for (const std::int32_t v : {error_.code, error_.cell.i, error_.cell.j, error_.polygon, error_.vertex, error_.vertex2,
                               error_.polygon2, error_.index, error_.index2})
    hash_.sign(v);
  put(error_.other);
  char sentence[300];
  std::size_t count = 0;
  lgs_message(&error_, sentence, sizeof sentence, &count);
  hash_.text(sentence);
}

void CEditor::edit() {
  const lgs_cell at = cell();
  const lgs_block block = choices_.below(5U);
  lgs_polygon_id polygon{};
  switch (choices_.below(8)) {
    case 0:
    case 1: {
      const auto vertices = points();
      put(lgs_add_points(world_, at, vertices.data(), vertices.size(), block, &polygon, &error_));
      handles_.push_back(polygon);
      break;
    }
    case 2: {
      const auto vertices = points();
      lgs_shape_id shape{};
      put(lgs_shape(world_, vertices.data(), vertices.size(), &shape, &error_));
      hash_.number(shape.value);
      shapes_.push_back(shape);
      break;
    }
    case 3: {
      std::vector<lgs_placement> placements;
      for (std::uint32_t k = shapes_.empty() ? 0 : choices_.below(4U); k > 0; --k) {
        const lgs_cell where = cell();
        placements.push_back({where, choices_.pick(shapes_), block});
      }
      std::vector<lgs_polygon_id> polygons(placements.size());
      put(lgs_add_many(world_, placements.data(), placements.size(), polygons.data(), &error_));
      handles_.insert(handles_.end(), polygons.begin(), polygons.end());
      break;
    }
    case 4:
      if (shapes_.empty()) break;
      put(lgs_replace(world_, at, choices_.pick(shapes_), block, &polygon, 1, &error_));
      handles_.push_back(polygon);
      break;
    case 5:
      put(lgs_set_block(world_, handle(), block, &error_));
      break;
    case 6: {
      const lgs_polygon_id both[2] = {handle(), handle()};
      put(lgs_remove_many(world_, both, 2, &error_));
      break;
    }
    default:
      put(lgs_remove(world_, handle(), &error_));
  }
  put(polygon);
}

void CEditor::commit() {
  lgs_changes changes{};
  put(lgs_commit(world_, &changes));
  putIds(changes.removed, changes.removed_count);
  putIds(changes.added, changes.added_count);
  putIds(changes.relinked, changes.relinked_count);
  std::vector<lgs_segment> added(changes.added_count);
  put(lgs_segments(world_, changes.added, added.size(), added.data(), &error_));
  for (const lgs_segment& s : added)
    for (const std::int64_t v : {s.start.x, s.start.y, s.end.x, s.end.y, std::int64_t{s.predecessor.value}})
      hash_.sign(v);
  hash_.step();
}

void CEditor::read() {
  lgs_loops* loops = nullptr;
  put(lgs_loops_new(world_, LGS_MERGE, &loops));
  for (std::size_t k = 0; k < lgs_loops_count(loops); ++k) {
    lgs_loop loop{};
    put(lgs_loops_get(loops, k, &loop));
    for (std::size_t v = 0; v < loop.count; ++v)
      platform::put(hash_, lgs::Point{loop.vertices[v].x, loop.vertices[v].y});
  }
  lgs_loops_free(loops);
  lgs_hashes* hashes = nullptr;
  put(lgs_hashes_new(world_, &hashes));
  lgs_hashed_square square{};
  put(lgs_hashes_whole(hashes, &square));
  hash_.number(square.hash);
  hash_.sign(square.level);
  lgs_hashes_free(hashes);
  std::vector<std::uint8_t> bytes(1u << 16);
  std::size_t count = 0;
  put(lgs_save_to_buffer(world_, bytes.data(), bytes.size(), &count, &error_));
  for (std::size_t k = 0; k < count && k < bytes.size(); ++k) hash_.byte(bytes[k]);
  hash_.step();
}

}  // namespace

void c(Hash& hash) {
  lgs_world_options options;
  lgs_default_world_options(&options, sizeof options);
  for (const lgs_preserve_fn relation : {lgs_preserve_fn{nullptr}, lgs_preserve_fn{keepsSomeOverlaps}}) {
    options.preserve = relation;
    lgs_world* world = nullptr;
    if (lgs_new(&options, &world) != LGS_OK) return;
    CEditor editor(world, hash, relation ? 900 : 901);
    for (int k = 0; k < 600; ++k) {
      for (int e = 0; e < 6; ++e) editor.edit();
      editor.commit();
      if (k % 60 == 59) editor.read();
    }
    lgs_free(world);
  }
}

}  // namespace platform
