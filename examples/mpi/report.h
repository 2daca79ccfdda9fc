// All own segments of a rank as a message, and whether those of all ranks are the segments of one world.
#pragma once

#include "../regions/region.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mpi {

regions::Message reportOf(const regions::Region& region);

struct Verdict {
  std::optional<std::string> wrong;  ///< nothing if all is right
  std::size_t segments = 0;
  std::size_t linksAcross = 0;  ///< links from one rank to another one
};

/// reports[r] is that of rank r.
Verdict compare(const lgs::World& one, const std::vector<regions::Message>& reports);

}  // namespace mpi
