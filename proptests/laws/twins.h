// Law 12 needs twins: two worlds in which the same calls are made. One of them leaves now and then: it goes back to a
// mark, is saved and loaded, or is copied. Nobody must be able to tell them apart.
#pragma once

#include "calls.h"

#include <cstddef>

namespace lgs::test {

/// Makes the same calls in both worlds, which must answer the same, report the same and be saved as the same bytes.
void expectNoDifference(Caller& stayed, Caller& left, const Calls& calls);

/// The edits among these calls.
Call groupOf(const Calls& calls, Call::Keeps keeps);

/// Segments that follow the change lists alone.
class Follower {
 public:
  explicit Follower(const World& world);
  void follow(const World& world, const ChangeLists& changes);
  bool agrees(const World& world) const;

 private:
  std::map<SegmentId, SegmentFields> segments_;
};

/// Gives the bytes of a world or a chunk the checksum that they should have.
void seal(std::vector<std::byte>& bytes);

}  // namespace lgs::test
