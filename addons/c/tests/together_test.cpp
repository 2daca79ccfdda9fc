// The C++ library and the static one of the C interface in one program. Each has the engine in it; the linker takes one
// of the two, and both interfaces go through it.
#include <lgs/lgs.h>
#include <lgs/world.h>

#include <cstdio>
#include <vector>

namespace {

constexpr lgs_local_point kRamp[] = {{0, 0}, {65536, 0}, {65536, 65536}};

/// A ramp, committed, as bytes; from C++.
std::vector<std::byte> savedByCpp() {
  lgs::World world;
  if (!world.add({3, 4}, {{0, 0}, {65536, 0}, {65536, 65536}}, 7)) return {};
  world.commit();
  std::vector<std::byte> bytes;
  if (!world.save([&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); }))
    return {};
  return bytes;
}

/// The same from C.
std::vector<std::byte> savedByC() {
  lgs_world* world = nullptr;
  std::vector<std::byte> bytes;
  const auto append = [](void* user, const std::uint8_t* piece, std::size_t count) {
    auto& all = *static_cast<std::vector<std::byte>*>(user);
    for (std::size_t k = 0; k < count; ++k) all.push_back(std::byte{piece[k]});
  };
  if (lgs_new(nullptr, &world) != LGS_OK) return {};
  if (lgs_add_points(world, {3, 4}, kRamp, 3, 7, nullptr, nullptr) != LGS_OK || lgs_commit(world, nullptr) != LGS_OK ||
      lgs_save(world, append, &bytes, nullptr) != LGS_OK)
    bytes.clear();
  lgs_free(world);
  return bytes;
}

}  // namespace

int main() {
  const std::vector<std::byte> one = savedByCpp(), other = savedByC();
  if (one.empty() || one != other) {
    std::fputs("C and C++ save the same world as other bytes\n", stderr);
    return 1;
  }
}
