// Random calls in one world, good and bad ones (oracle/calls), and all that they give out.
#pragma once

#include "hash.h"

#include "oracle/calls/draw.h"
#include "oracle/calls/random.h"

namespace platform {

using oracle::Random;

class Editor {
 public:
  /// The editor keeps the reference. Cells are counted from the origin: as a rule across the corner of four chunks.
  Editor(Hash& hash, std::uint64_t seed, lgs::World world = lgs::World(), oracle::Habits habits = kHabits,
         lgs::Cell origin = {-4, -4});

  lgs::World& world() { return caller_.world; }

  /// One call: no commit, as a rule.
  void edit();
  void edits(int count) {
    for (int k = 0; k < count; ++k) edit();
  }
  /// The three lists, and what is new in full.
  void commit();
  /// Everything that can be read, as of the last commit.
  void readAll();

  static const oracle::Habits kHabits;  ///< cells in plenty, and commit() by itself

 private:
  Hash& hash_;
  Random choices_;
  oracle::Habits habits_;
  oracle::Caller caller_;
  lgs::Cell origin_;
};

}  // namespace platform
