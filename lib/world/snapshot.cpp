#include "world/snapshot.h"

#include "ground/snapshot.h"
#include "outline/snapshot.h"

#include <algorithm>
#include <array>
#include <string>

namespace lgs::detail {
namespace {

using What = SnapshotError::What;

constexpr std::size_t kHead = kSnapshotMagic.size() + 1;  // letters, version
constexpr std::size_t kTail = 4;                          // checksum

std::uint8_t versionOf(std::span<const std::byte> bytes) {
  return std::to_integer<std::uint8_t>(bytes[kSnapshotMagic.size()]);
}

/// What can be told before anything is made of the bytes: whether they are a snapshot, whole and undamaged.
std::optional<SnapshotError> lookAt(std::span<const std::byte> bytes, const Magic& letters, std::uint8_t newest) {
  const std::size_t compared = std::min(bytes.size(), letters.size());
  for (std::size_t k = 0; k < compared; ++k)
    if (bytes[k] != std::byte{letters[k]}) return SnapshotError{.what = What::notASnapshot, .offset = k};
  if (bytes.size() < kHead + kTail) return SnapshotError{.what = What::cut, .offset = bytes.size()};
  if (const std::uint8_t version = versionOf(bytes); version < 1 || version > newest)
    return SnapshotError{What::unknownVersion, letters.size(), version, newest};
  Checksum sum;
  for (const std::byte byte : bytes.first(bytes.size() - kTail)) sum.add(byte);
  if (sum.value() != checksumOf(bytes)) return SnapshotError{.what = What::damaged, .offset = bytes.size() - kTail};
  return std::nullopt;
}

/// What is between head and checksum.
SnapshotReader reader(std::span<const std::byte> bytes) {
  return SnapshotReader(bytes.subspan(kHead, bytes.size() - kHead - kTail));
}

SnapshotError errorOf(const SnapshotReader& in) {
  return {.what = in.error().what, .offset = in.error().offset + kHead};
}

void writeHead(SnapshotWriter& out, const Magic& letters, std::uint8_t version) {
  for (const std::uint8_t letter : letters) out.byte(letter);
  out.byte(version);
}

}  // namespace

void save(const Ground& ground, const Outline& outline, const ByteSink& sink) {
  SnapshotWriter out(sink);
  writeHead(out, kSnapshotMagic, hasFreeNumbers(ground) ? kSnapshotWithFreeNumbers : kSnapshotVersion);
  save(ground, out);
  save(ground, outline, out);
  out.end();
}

std::optional<SnapshotError> load(std::span<const std::byte> bytes, Ground& ground, Outline& outline) {
  if (const auto error = lookAt(bytes, kSnapshotMagic, kSnapshotWithFreeNumbers)) return error;
  SnapshotReader in = reader(bytes);
  load(ground, in, versionOf(bytes) == kSnapshotWithFreeNumbers);
  load(ground, outline, in);
  if (in.left() != 0) in.fail(What::tooLong);
  if (in.failed()) return errorOf(in);
  outline.linkAll(ground);
  ground.endCommit();
  return std::nullopt;
}

std::vector<std::byte> saveChunk(const Ground& ground, const Chunk& chunk) {
  std::vector<std::byte> bytes;
  const ByteSink sink = [&](std::span<const std::byte> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
  };
  SnapshotWriter out(sink);
  writeHead(out, kChunkMagic, kChunkVersion);
  save(ground, chunk, out);
  out.end();
  return bytes;
}

std::uint32_t checksumOf(std::span<const std::byte> bytes) {
  std::uint32_t sum = 0;
  for (std::size_t k = 0; k < kTail; ++k)
    sum |= std::to_integer<std::uint32_t>(bytes[bytes.size() - kTail + k]) << 8 * k;
  return sum;
}

tl::expected<Cell, SnapshotError> loadChunk(std::span<const std::byte> bytes, Ground& ground) {
  if (const auto error = lookAt(bytes, kChunkMagic, kChunkVersion)) return tl::unexpected(*error);
  SnapshotReader in = reader(bytes);
  const Cell corner = loadChunk(ground, in, checksumOf(bytes));
  if (in.failed()) return tl::unexpected(errorOf(in));
  return corner;
}

}  // namespace lgs::detail

namespace lgs {

std::string message(const SnapshotError& error) {
  static constexpr std::array kWords{"this is no snapshot of a world",
                                     "the snapshot has version ",
                                     "the snapshot ends too early",
                                     "the snapshot is damaged, or cut: its checksum does not fit",
                                     "bytes follow the end of the snapshot",
                                     "the world was saved with another preserve relation than it is loaded with",
                                     "a number is out of its range",
                                     "a polygon is not valid, or overlaps another one of its cell",
                                     "the ids of the segments do not fit this world",
                                     "more than a world can hold",
                                     "the chunk is there, and not unloaded",
                                     "the chunk was unloaded with other bytes than these since"};
  static_assert(kWords.size() == static_cast<std::size_t>(SnapshotError::What::otherBytes) + 1);
  const auto number = static_cast<std::size_t>(error.what);
  std::string text = "byte " + std::to_string(error.offset) + ": ";
  text += number < kWords.size() ? kWords[number] : "unknown error";
  if (error.what == SnapshotError::What::unknownVersion)
    text += std::to_string(error.version) + " of its format, and this library reads versions from 1 to " +
            std::to_string(error.newest);
  return text;
}

}  // namespace lgs
