// Messages between ranks by MPI.
#pragma once

#include "../regions/message.h"

#include <vector>

namespace mpi {

/// Sends each rank what the outbox has for it. Returns what each rank has sent to this one, by rank. All ranks must
/// call it. A message has fewer than 2^31 words, and so have all from or to one rank together.
std::vector<regions::Message> exchange(const regions::Outbox& out);

}  // namespace mpi
