// Bodies as convex parts, as they lie, and as bytes.
#include "body.h"

#include <lgs/falling.h>
#include <lgs/ground_parts.h>
#include <lgs/lgs_falling.h>

using namespace lgs::c;

namespace {

lgs::Placing placingOf(const lgs_placing& p) { return {fromC(p.origin), p.cosine, p.sine}; }

}  // namespace

lgs_status lgs_body_parts(const lgs_body* body, size_t max_vertices, lgs_part_fn visit, void* user,
                          lgs_error* error) noexcept {
  if (!body || !visit || max_vertices < 3 || max_vertices > lgs::kMaxVerticesPerCell)
    return refuse(LGS_BAD_ARGUMENT, error);
  const auto parts = lgs::convexParts(body->body, max_vertices);
  if (!parts) return refuse(parts.error(), error);
  std::vector<lgs_point> vertices;
  for (const lgs::ConvexPart& part : *parts) {
    vertices.clear();
    for (const lgs::Point v : part.vertices) vertices.push_back(toC(v));
    visit(user, part.block, vertices.data(), vertices.size());
  }
  return LGS_OK;
}

lgs_status lgs_put_as_it_lies(lgs_world* world, const lgs_body* body, const lgs_placing* placing,
                              lgs_error* error) noexcept {
  // The origin may be anywhere: it may be out of reach.
  if (!world || !body || !placing || !lgs::isSound({{}, {{}, placing->cosine, placing->sine}, {}, 0}))
    return refuse(LGS_BAD_ARGUMENT, error);
  const auto done = lgs::putAsItLies(world->world, body->body, placingOf(*placing));
  return done ? LGS_OK : refuse(done.error(), error);
}

lgs_status lgs_rock_save(const lgs_body* body, const lgs_rock* rock, uint8_t* bytes, size_t capacity,
                         size_t* count) noexcept {
  if (!body || !rock) return LGS_BAD_ARGUMENT;
  const lgs::Rock value{body->body, placingOf(rock->placing), fromC(rock->velocity), rock->spin};
  if (!lgs::isSound(value)) return LGS_BAD_ARGUMENT;
  std::vector<std::byte> out;
  lgs::putRock(out, value);
  return putList(out, bytes, capacity, count, [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
}

lgs_status lgs_rock_load(const uint8_t* bytes, size_t count, lgs_body** body, lgs_rock* rock) noexcept {
  if (!body || !isArray(bytes, count)) return LGS_BAD_ARGUMENT;
  std::span<const std::byte> rest = std::as_bytes(std::span(bytes, count));
  auto loaded = lgs::takeRock(rest);
  if (!loaded || !rest.empty()) return LGS_SAVE_DAMAGED;
  put(rock, {{toC(loaded->placing.origin), loaded->placing.cosine, loaded->placing.sine},
             toC(loaded->velocity),
             loaded->spin});
  *body = new lgs_body(std::move(loaded->ground));
  return LGS_OK;
}
