// Worlds, buffers, and failures.
#include "bridge.h"

#include <cstring>

namespace lgs::web {

/// A function that JavaScript has.
__attribute__((import_module("lgs"), import_name("preserve"))) std::int32_t preserveInJavaScript(std::uint32_t relation,
                                                                                                 Block smaller,
                                                                                                 Block greater);

/// What a failure is, as numbers. Those of an Error come first, in its order.
struct Failure {
  double code = 0, i = 0, j = 0, polygon = 0, vertex = 0, vertex2 = 0, polygon2 = 0, other = 0, otherBlock = 0,
         segment = 0, index = 0, index2 = 0;
  double isSnapshot = 0, offset = 0;
  double text = 0, textLength = 0;
};

static_assert(sizeof(Failure) == 16 * sizeof(double));  // web/package/src/error.ts and engine.ts read it

namespace {

std::vector<double> inputBuffer;  // doubles: it is at a multiple of eight bytes
std::vector<DoublePoint> points;
std::string lastSentence;

Failure failureOfLastCall;

void keepText(std::string sentence) {
  lastSentence = std::move(sentence);
  failureOfLastCall.text = static_cast<double>(reinterpret_cast<std::uintptr_t>(lastSentence.data()));
  failureOfLastCall.textLength = static_cast<double>(lastSentence.size());
}

}  // namespace

std::vector<double>& answer() {
  static std::vector<double> numbers;
  return numbers;
}

std::vector<std::byte>& answerBytes() {
  static std::vector<std::byte> bytes;
  return bytes;
}

void keepFailure(const Error& e) {
  failureOfLastCall = {.code = static_cast<double>(e.code),
                       .i = static_cast<double>(e.cell.i),
                       .j = static_cast<double>(e.cell.j),
                       .polygon = static_cast<double>(e.polygon),
                       .vertex = static_cast<double>(e.vertex),
                       .vertex2 = static_cast<double>(e.vertex2),
                       .polygon2 = static_cast<double>(e.polygon2),
                       .other = toNumber(e.other),
                       .otherBlock = static_cast<double>(e.otherBlock),
                       .segment = static_cast<double>(e.segment.value),
                       .index = static_cast<double>(e.index),
                       .index2 = static_cast<double>(e.index2)};
  keepText(message(e));
}

void keepFailure(const SnapshotError& e) {
  failureOfLastCall = {.code = static_cast<double>(e.what), .isSnapshot = 1, .offset = static_cast<double>(e.offset)};
  keepText(message(e));
}

PreserveRelation relation(std::uint32_t number) {
  if (number == 0) return {};
  return [number](Block smaller, Block greater) { return preserveInJavaScript(number, smaller, greater) != 0; };
}

template <>
std::span<const double> input<double>(std::size_t count) {
  return {inputBuffer.data(), count};
}
template <>
std::span<const std::int32_t> input<std::int32_t>(std::size_t count) {
  return {reinterpret_cast<const std::int32_t*>(inputBuffer.data()), count};
}
template <>
std::span<const std::byte> input<std::byte>(std::size_t count) {
  return std::as_bytes(std::span(inputBuffer)).first(count);
}

std::span<const DoublePoint> inputPoints(std::size_t count) {
  points.clear();
  const auto numbers = input<double>(2 * count);
  for (std::size_t k = 0; k < count; ++k) points.push_back({numbers[2 * k], numbers[2 * k + 1]});
  return points;
}

// --- What JavaScript calls -------------------------------------------------------------------------------------------

LGS_EXPORT("input") double* inputAddress(std::size_t bytes) {
  const std::size_t numbers = (bytes + sizeof(double) - 1) / sizeof(double);
  if (inputBuffer.size() < numbers) inputBuffer.resize(numbers);
  return inputBuffer.data();
}
LGS_EXPORT("answer") const double* answerAddress() { return answer().data(); }
LGS_EXPORT("answerBytes") const std::byte* answerBytesAddress() { return answerBytes().data(); }
LGS_EXPORT("failure") const Failure* failureAddress() { return &failureOfLastCall; }

LGS_EXPORT("make") Bridge* make(std::uint32_t relationNumber, std::int32_t isFloat) {
  return new Bridge{
      .world = World(relation(relationNumber)), .shapes = ShapeNumbers::ofNewWorld(), .isFloat = isFloat != 0};
}
LGS_EXPORT("free") void release(Bridge* bridge) { delete bridge; }  // with its terrains

LGS_EXPORT("load") Bridge* load(std::size_t bytes, std::uint32_t relationNumber, std::int32_t isFloat) {
  auto world = World::load(input<std::byte>(bytes), relation(relationNumber));
  if (!world) {
    keepFailure(world.error());
    return nullptr;
  }
  return new Bridge{.world = std::move(*world), .shapes = ShapeNumbers::ofLoadedWorld(), .isFloat = isFloat != 0};
}
/// Returns the number of bytes in the answer.
LGS_EXPORT("save") double save(const Bridge* bridge) {
  auto& bytes = answerBytes();
  bytes.clear();
  const auto done = bridge->world.save(
      [&bytes](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  if (!done) return refused(done.error(), -1.0);
  return static_cast<double>(bytes.size());
}

}  // namespace lgs::web
