// Chunks that leave memory and come back.
#include "bridge.h"

namespace lgs::web {

/// The answer has three numbers for each chunk: i and j of its lower-left cell, and how many of the bytes are its.
LGS_EXPORT("unload") double unload(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  answer().clear();
  auto& bytes = answerBytes();
  bytes.clear();
  const auto count = bridge->world.unload({{i0, j0}, {i1, j1}}, [&](Cell corner, std::span<const std::byte> chunk) {
    for (const double number : {double(corner.i), double(corner.j), double(chunk.size())}) answer().push_back(number);
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
  });
  if (!count) return refused(count.error(), -1.0);
  bridge->isEdited |= *count != 0;
  return static_cast<double>(bytes.size());
}

/// The bytes of a chunk are in the input. The answer has its lower-left cell.
LGS_EXPORT("reload") std::int32_t reload(Bridge* bridge, std::size_t bytes) {
  const auto corner = bridge->world.reload(input<std::byte>(bytes));
  if (!corner) {
    keepFailure(corner.error());
    return 0;
  }
  bridge->isEdited = true;
  answer() = {static_cast<double>(corner->i), static_cast<double>(corner->j)};
  return 1;
}

LGS_EXPORT("reloadEmpty")
double reloadEmpty(Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  const auto count = bridge->world.reloadEmpty({{i0, j0}, {i1, j1}});
  if (!count) return refused(count.error(), -1.0);
  bridge->isEdited |= *count != 0;
  return static_cast<double>(*count);
}

/// 0 if there is none.
LGS_EXPORT("firstUnloaded")
std::int32_t firstUnloaded(const Bridge* bridge, std::int32_t i0, std::int32_t j0, std::int32_t i1, std::int32_t j1) {
  const auto cell = bridge->world.firstUnloaded({{i0, j0}, {i1, j1}});
  if (cell) answer() = {static_cast<double>(cell->i), static_cast<double>(cell->j)};
  return cell ? 1 : 0;
}

}  // namespace lgs::web
