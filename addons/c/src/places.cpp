// Loops, and questions about places.
#include "inside.h"

using namespace lgs::c;

static_assert(static_cast<int>(lgs::Spot::Where::outside) == LGS_OUTSIDE);
static_assert(static_cast<int>(lgs::Spot::Where::edge) == LGS_EDGE);
static_assert(static_cast<int>(lgs::Spot::Where::inside) == LGS_INSIDE);

// --- Loops -----------------------------------------------------------------------------------------------------------

struct lgs_loops {
  struct Loop {
    std::vector<lgs_point> vertices;
    std::vector<lgs_segment_id> segments;
  };
  std::vector<Loop> all;
};

lgs_status lgs_loops_new(const lgs_world* world, int32_t collinear, lgs_loops** loops) noexcept {
  if (!world || !loops || (collinear != LGS_KEEP && collinear != LGS_MERGE)) return LGS_BAD_ARGUMENT;
  auto* made = new lgs_loops;
  for (const lgs::Loop& loop : world->world.loops(lgs::Collinear{collinear == LGS_MERGE})) {
    lgs_loops::Loop& copy = made->all.emplace_back();
    copyBytes(loop.vertices.data(), loop.vertices.size(), copy.vertices);
    copyBytes(loop.segments.data(), loop.segments.size(), copy.segments);
  }
  *loops = made;
  return LGS_OK;
}

size_t lgs_loops_count(const lgs_loops* loops) noexcept { return loops ? loops->all.size() : 0; }

lgs_status lgs_loops_get(const lgs_loops* loops, size_t index, lgs_loop* loop) noexcept {
  if (!loops || index >= loops->all.size()) return LGS_BAD_ARGUMENT;
  const lgs_loops::Loop& found = loops->all[index];
  put(loop,
      lgs_loop{found.vertices.data(), found.segments.empty() ? nullptr : found.segments.data(), found.vertices.size()});
  return LGS_OK;
}

void lgs_loops_free(lgs_loops* loops) noexcept { delete loops; }

// --- Questions -------------------------------------------------------------------------------------------------------

lgs_status lgs_at(const lgs_world* world, lgs_point point, lgs_spot* spot) noexcept {
  if (!world) return LGS_BAD_ARGUMENT;
  const lgs::Spot s = world->world.at(fromC(point));
  put(spot, lgs_spot{static_cast<std::int32_t>(s.where), toC(s.polygon), s.block, toC(s.cell)});
  return LGS_OK;
}

lgs_status lgs_nearest(const lgs_world* world, lgs_point point, double radius, lgs_nearest_segment* nearest,
                       lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto found = world->world.nearest(fromC(point), radius);
  if (!found) return refuse(found.error(), error);
  put(nearest, lgs_nearest_segment{toC(found->segment), 0, toC(found->point), found->distance});
  return LGS_OK;
}

lgs_status lgs_ray_cast(const lgs_world* world, lgs_point from, lgs_point to, lgs_ray_hit* hit,
                        lgs_error* error) noexcept {
  if (!world) return refuse(LGS_BAD_ARGUMENT, error);
  const auto found = world->world.rayCast(fromC(from), fromC(to));
  if (!found) return refuse(found.error(), error);
  put(hit, lgs_ray_hit{toC(found->segment), 0, found->fraction, toC(found->point), toC(found->normal)});
  return LGS_OK;
}
