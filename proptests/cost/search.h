// A search for what costs most: from any input one climbs to one that costs more for its size, by small changes, as far
// as that goes. What is counted is basic blocks, not time. A bound holds for all that a search tries: it is two to three
// times what the search finds as it stands.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/calls/random.h"
#include "proptests/support/scale.h"
#include "visits.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lgs::cost_test {

using oracle::Random;

/// Climbs from inputs that `make` makes. Each step keeps the dearer one of two. Returns the greatest cost for its size.
template <class Input>
double dearest(const std::function<Input(Random&)>& make, const std::function<void(Input&, Random&)>& change,
               const std::function<double(const Input&)>& cost, int starts, int steps) {
  double most = 0;
  Random random(test::testSeed());
  for (int start = 0; start < starts; ++start) {
    Input best = make(random);
    double height = cost(best);
    for (std::int64_t step = 0; step < test::scaled(steps); ++step) {
      Input next = best;
      for (int k = 1 + random.below(3); k > 0; --k) change(next, random);
      const double reached = cost(next);
      if (reached < height) continue;
      best = std::move(next);
      height = reached;
    }
    most = std::max(most, height);
  }
  testing::Test::RecordProperty("most", std::to_string(most));
  return most;
}

/// Calls of the alphabet, for worlds that are searched.
using Calls = std::vector<oracle::Call>;
Calls drawCalls(Random& random);
void changeCalls(Calls& calls, Random& random);

/// The world that they lead to, committed.
World worldOf(const Calls& calls);

/// Of a map of any format, with low limits: in blocks, and as a share of what the documents allow for its bytes.
double costOfImport(const std::string& map);
double shareOfLimit(const std::string& map);

}  // namespace lgs::cost_test
