// The header in C++: that it compiles there, that nothing is thrown out of it, and that its values are plain data
// without padding. So they lie the same with every compiler whose machine has pointers of the same size.
#include <lgs/lgs.h>

#include <cstdio>
#include <type_traits>

namespace {

template <class... Values>
constexpr bool arePlain() {
  return (... && (std::is_standard_layout_v<Values> && std::is_trivially_copyable_v<Values>));
}

template <class... Values>
constexpr bool haveNoPadding() {
  return (... && std::has_unique_object_representations_v<Values>);
}

static_assert(
    arePlain<lgs_error, lgs_placement, lgs_changes, lgs_segment, lgs_segment_float, lgs_segment_double, lgs_polygon,
             lgs_loop, lgs_spot, lgs_nearest_segment, lgs_ray_hit, lgs_stats, lgs_world_options>());
static_assert(haveNoPadding<lgs_shape_id, lgs_polygon_id, lgs_segment_id, lgs_mark, lgs_cell, lgs_cell_rect,
                            lgs_local_point, lgs_local_box, lgs_point, lgs_error, lgs_placement, lgs_changes,
                            lgs_segment, lgs_polygon, lgs_loop, lgs_spot, lgs_stats, lgs_world_options>());
static_assert(sizeof(lgs_segment_float) == 64 && sizeof(lgs_segment_double) == 96 && sizeof(lgs_ray_hit) == 48 &&
              sizeof(lgs_nearest_segment) == 32);
static_assert(noexcept(lgs_new(nullptr, nullptr)) && noexcept(lgs_commit(nullptr, nullptr)));

}  // namespace

int main() {
  lgs_world* world = nullptr;
  if (lgs_new(nullptr, &world) != LGS_OK || lgs_commit(world, nullptr) != LGS_OK) return 1;
  lgs_free(world);
  std::puts("c.header: fine");
}
