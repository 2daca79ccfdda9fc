// A Ground of JavaScript as bytes: the same that lgs::Ground saves and loads.
#include "bodies.h"

#include <lgs/ground_parts.h>
#include <lgs/unloaded.h>

#include <iterator>
#include <map>

namespace lgs::web {
namespace {

/// Reads numbers one after the other.
class Numbers {
 public:
  explicit Numbers(std::span<const double> in) : in_(in) {}
  double next() {
    const double number = in_.front();
    in_ = in_.subspan(1);
    return number;
  }
  std::size_t count() { return static_cast<std::size_t>(next()); }
  Cell cell() {
    const auto i = static_cast<std::int32_t>(next());
    return {i, static_cast<std::int32_t>(next())};
  }
  std::span<const double> next(std::size_t count) {
    const auto numbers = in_.first(count);
    in_ = in_.subspan(count);
    return numbers;
  }

 private:
  std::span<const double> in_;
};

void putCell(Cell cell) { answer().insert(answer().end(), {static_cast<double>(cell.i), static_cast<double>(cell.j)}); }

Rock rockIn(Numbers& in) {
  Rock rock;
  rock.placing.origin = {in.next(), in.next()};
  rock.placing.cosine = in.next();
  rock.placing.sine = in.next();
  rock.velocity = {in.next(), in.next()};
  rock.spin = in.next();
  const Cell origin = in.cell();
  rock.ground = bodyOf(in.next(in.count()));
  rock.ground.origin = origin;
  return rock;
}

void putRock(const Rock& rock) {
  const auto& [origin, cosine, sine] = rock.placing;
  answer().insert(answer().end(), {origin.x, origin.y, cosine, sine, rock.velocity.x, rock.velocity.y, rock.spin});
  putBody(rock.ground);
}

}  // namespace

/// i, j of the lower-left cell of each chunk that is unloaded.
LGS_EXPORT("unloadedChunks") std::size_t unloadedChunksOf(const Bridge* bridge) {
  answer().clear();
  for (const CellRect& chunk : unloadedChunks(bridge->world)) putCell(chunk.min);
  return answer().size();
}

/// In the input: how many chunks have land, and these; how many rocks, and of each its place, cosine, sine, velocity,
/// spin, origin, the number of its numbers and these; how many chunks are on the shelf, and of each its place and size.
/// Behind these `numbers` the bytes of those chunks. Returns the number of bytes in the answer.
LGS_EXPORT("saveGround") double saveGroundOf(const Bridge* bridge, std::size_t numbers, std::size_t bytes) {
  auto shelved = input<std::byte>(numbers * sizeof(double) + bytes).subspan(numbers * sizeof(double));
  Numbers in(input<double>(numbers));
  std::vector<Cell> land;
  for (std::size_t count = in.count(); count > 0; --count) land.push_back(in.cell());
  std::vector<Rock> rocks;
  for (std::size_t count = in.count(); count > 0; --count) rocks.push_back(rockIn(in));
  std::map<Cell, std::span<const std::byte>> chunks;
  for (std::size_t count = in.count(); count > 0; --count) {
    const Cell corner = in.cell();
    const std::size_t size = in.count();
    chunks[corner] = shelved.first(size);
    shelved = shelved.subspan(size);
  }
  const Shelf shelf{.put = {}, .get = [&](Cell corner) -> std::optional<std::vector<std::byte>> {
                      const auto found = chunks.find(corner);
                      if (found == chunks.end()) return std::nullopt;
                      return std::vector(found->second.begin(), found->second.end());
                    }};
  auto& out = answerBytes();
  out.clear();
  const auto done = saveGround(bridge->world, shelf, rocks, land, [&out](std::span<const std::byte> part) {
    out.insert(out.end(), part.begin(), part.end());
  });
  if (!done) return refused(done.error(), -1.0);
  return static_cast<double>(out.size());
}

/// The bytes are in the input; chunks with a corner out of the window go onto the shelf. The answer has how many numbers
/// and how many bytes it has; how many chunks have land, and these; how many rocks, and of each its place, cosine, sine,
/// velocity, spin, and it as putBody() writes it; and how many chunks go onto the shelf, and of each its place and size.
/// The bytes of the answer are these chunks.
LGS_EXPORT("loadGround")
Bridge* loadGroundOf(std::size_t bytes, std::uint32_t relationNumber, std::int32_t isFloat, std::int32_t i0,
                     std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  std::vector<double> shelved;
  auto& out = answerBytes();
  out.clear();
  const Shelf shelf{.put =
                        [&](Cell corner, std::span<const std::byte> chunk) {
                          shelved.insert(shelved.end(), {static_cast<double>(corner.i), static_cast<double>(corner.j),
                                                         static_cast<double>(chunk.size())});
                          out.insert(out.end(), chunk.begin(), chunk.end());
                        },
                    .get = {}};
  auto loaded = loadGround(input<std::byte>(bytes), relation(relationNumber), {{i0, j0}, {i1, j1}}, shelf);
  if (!loaded) {
    keepFailure(SnapshotError{.what = SnapshotError::What::notASnapshot, .offset = 0});
    return nullptr;
  }
  auto& numbers = answer();
  numbers = {0, static_cast<double>(out.size()), static_cast<double>(loaded->land.size())};
  for (const Cell corner : loaded->land) putCell(corner);
  numbers.push_back(static_cast<double>(loaded->rocks.size()));
  for (const Rock& rock : loaded->rocks) putRock(rock);
  numbers.push_back(static_cast<double>(shelved.size() / 3));
  numbers.insert(numbers.end(), shelved.begin(), shelved.end());
  numbers.front() = static_cast<double>(numbers.size());
  return new Bridge{
      .world = std::move(loaded->world), .shapes = ShapeNumbers::ofLoadedWorld(), .isFloat = isFloat != 0};
}

}  // namespace lgs::web
