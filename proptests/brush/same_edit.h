// Edits of a cell, worked out in two ways.
#pragma once

#include "cell_edit.h"

#include <gtest/gtest.h>

namespace lgs::test {

inline void expectSame(const brush::CellEdit& quick, const brush::CellEdit& arranged) {
  EXPECT_EQ(quick.gone, arranged.gone);
  EXPECT_EQ(quick.rounded, arranged.rounded);
  EXPECT_FALSE(arranged.isTooMuch);
  ASSERT_EQ(quick.placed.size(), arranged.placed.size());
  for (std::size_t k = 0; k < quick.placed.size(); ++k) {
    EXPECT_EQ(quick.placed[k].ring, arranged.placed[k].ring);
    EXPECT_EQ(quick.placed[k].block, arranged.placed[k].block);
    EXPECT_EQ(quick.placed[k].from, arranged.placed[k].from);
  }
}

}  // namespace lgs::test
