#include "unloaded.h"
#include "proptests/support/must.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lgs::test {

World rowOfChunks(std::int32_t chunks) {
  World world;
  fill(world, {{0, 0}, {32 * chunks - 1, 31}});
  world.commit();
  return world;
}

}  // namespace lgs::test
