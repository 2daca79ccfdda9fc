// Which vertices an error may name. If several are to blame, it may be any of them, unless error.h says which. It is
// never another.
#include "oracle/reference/blame.h"

#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace lgs::oracle {
namespace {

using Pairs = std::set<std::pair<int, int>>;

// All that may be named, -1 and one past the end tried as well.
Pairs allowed(ErrorCode code, const LocalPolygon& polygon) {
  Pairs pairs;
  const int end = static_cast<int>(polygon.size());
  for (int a = -1; a <= end; ++a) {
    for (int b = -1; b <= end; ++b) {
      Error error;
      error.code = code;
      error.polygon = code == ErrorCode::cellOutOfRange ? -1 : 0;
      error.vertex = a;
      error.vertex2 = b;
      if (wrongBlame(error, {&polygon, 1}).empty()) pairs.emplace(a, b);
    }
  }
  return pairs;
}

const LocalPolygon kTriangle{{0, 0}, {8, 0}, {8, 8}};

TEST(FuzzBlame, AnyVertexOutside) {
  EXPECT_EQ(allowed(ErrorCode::outsideCell, {{0, 0}, {-1, 0}, {8, 8}, {0, kUnitsPerCell + 1}}),
            (Pairs{{1, -1}, {3, -1}}));
}

TEST(FuzzBlame, TheFirstVertexThatRepeatsAnother) {
  EXPECT_EQ(allowed(ErrorCode::repeatedVertex, {{0, 0}, {8, 0}, {0, 0}, {8, 8}, {8, 0}}), (Pairs{{0, 2}}));
}

TEST(FuzzBlame, TheFirstEdgesThatCross) {
  EXPECT_EQ(allowed(ErrorCode::selfIntersecting, {{0, 0}, {8, 0}, {1, 4}, {8, 8}}), (Pairs{{1, 3}}));
}

// The vertex (4, 0) is on the edge from vertex 0, and both its edges touch that one.
TEST(FuzzBlame, EdgesThatTouch) {
  EXPECT_EQ(allowed(ErrorCode::selfIntersecting, {{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}), (Pairs{{0, 2}}));
}

// Edge 1 runs back on edge 0, and edge 2 leaves in the midst of it.
TEST(FuzzBlame, EdgesThatFoldBack) {
  EXPECT_EQ(allowed(ErrorCode::selfIntersecting, {{0, 0}, {9, 0}, {5, 0}, {5, 5}}), (Pairs{{0, 1}}));
  EXPECT_EQ(allowed(ErrorCode::selfIntersecting, {{5, 0}, {5, 5}, {0, 0}, {9, 0}}), (Pairs{{0, 2}}));
}

TEST(FuzzBlame, NoEdgesOfASimplePolygon) { EXPECT_EQ(allowed(ErrorCode::selfIntersecting, kTriangle), Pairs{}); }

TEST(FuzzBlame, NoVertexWhereNoneApplies) {
  for (const ErrorCode code : {ErrorCode::cellOutOfRange, ErrorCode::tooFewVertices, ErrorCode::zeroArea,
                               ErrorCode::clockwise, ErrorCode::overlap}) {
    EXPECT_EQ(allowed(code, kTriangle), (Pairs{{-1, -1}})) << name(code);
  }
}

TEST(FuzzBlame, NoFieldThatDoesNotApply) {
  Error error;
  error.code = ErrorCode::clockwise;
  EXPECT_NE(wrongBlame(error, {&kTriangle, 1}), "");  // the only polygon of the call has the index 0
  error.polygon = 0;
  EXPECT_EQ(wrongBlame(error, {&kTriangle, 1}), "");
  error.other = {1, 1};
  EXPECT_NE(wrongBlame(error, {&kTriangle, 1}), "");
}

}  // namespace
}  // namespace lgs::oracle
