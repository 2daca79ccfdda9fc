// The smallest game: two blocks side by side, a hole dug, and the segments counted after each commit. Built against the
// installed package (packaging/tests/consumer) and as a subproject (packaging/tests/subproject), without exceptions and RTTI.
#include <lgs/version.h>
#include <lgs/world.h>
#include <cstdio>

namespace {

int failures = 0;

void expect(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "consumer: expected %s\n", what);
  ++failures;
}

}  // namespace

int main() {
  expect(lgs::version() == lgs::kVersion, "the library to be that of the headers");

  lgs::World world;
  const auto square = world.shape(lgs::kUnitSquare);
  expect(square.has_value(), "the unit square to be a shape");
  if (!square) return 1;

  const auto left = world.add({0, 0}, *square, 1);
  const auto right = world.add({1, 0}, *square, 2);
  expect(left.has_value() && right.has_value(), "both blocks to be placed");
  if (!left || !right) return 1;
  expect(world.commit().added.size() == 6, "6 segments around two blocks: the seam is cancelled");

  const auto overlap = world.add({1, 0}, *square, 3);
  expect(!overlap && overlap.error().code == lgs::ErrorCode::overlap, "a block on a block to be refused");
  if (!overlap) expect(!lgs::message(overlap.error()).empty(), "a refusal to say why");

  expect(world.remove(*right).has_value(), "the right block to go");
  expect(!world.remove(*right).has_value(), "a stale handle to be refused");
  const lgs::Changes& changes = world.commit();
  expect(changes.removed.size() == 3 && changes.added.size() == 1, "3 segments to go and 1 to come");
  expect(world.loops().size() == 1 && world.loops()[0].segments.size() == 4, "one loop of 4 segments to be left");

  if (failures == 0) std::puts("consumer: fine");
  return failures == 0 ? 0 : 1;
}
