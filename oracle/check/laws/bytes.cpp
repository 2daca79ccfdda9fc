// Law 7 of saved worlds: bytes that are damaged are refused. Those of ill will, whose checksum is right, are refused, or
// they are a world like any other.
#include "oracle/calls/random.h"
#include "oracle/check/laws/list.h"
#include "oracle/trace/dump.h"
#include "oracle/views/recompute.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace lgs::oracle {
namespace {

// The last four bytes are the CRC-32 of those before.
void seal(std::span<std::byte> bytes) {
  std::uint32_t sum = ~0U;
  for (const std::byte byte : bytes.first(bytes.size() - 4)) {
    sum ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1U) != 0 ? 0xedb8'8320U : 0U);
  }
  for (std::size_t k = 0; k < 4; ++k) bytes[bytes.size() - 4 + k] = static_cast<std::byte>(~sum >> 8 * k);
}

class BytesLaw : public Law {
 public:
  Found atEnd(Seen& seen) override {
    std::vector<std::byte> bytes;
    const auto keep = [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); };
    if (!seen.world().save(keep)) return std::nullopt;
    constexpr int kTries = 8;
    Random random(bytes.size());
    for (int k = 0; k < kTries; ++k) {
      std::vector<std::byte> other = bytes;  // a byte becomes as another one is, or nearly so
      const std::byte now = static_cast<std::byte>(random.below(2)) ^ random.pick(bytes);
      std::byte& byte = other[random.below(other.size())];
      if (std::exchange(byte, now) == now) continue;
      if (World::load(other, relationOf(seen.trace.preserve)))
        return seen.mismatch(Mismatch::Kind::past, "damaged bytes are a world");
      seal(other);
      const auto loaded = World::load(other, relationOf(seen.trace.preserve));
      if (!loaded) continue;
      Scene scene = bareScene(*loaded);
      scene.preserve = seen.trace.preserve;
      if (outlineOf(*loaded) != seen.naive(scene).outline)
        return seen.mismatch(Mismatch::Kind::past, "bytes of ill will are a world with another outline");
    }
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<Law> laws::bytes() { return std::make_unique<BytesLaw>(); }

}  // namespace lgs::oracle
