#include "exchange.h"

#include <mpi.h>

namespace mpi {

using regions::Message;

std::vector<Message> exchange(const regions::Outbox& out) {
  const std::size_t ranks = out.size();
  std::vector<int> sent(ranks), received(ranks), sentAt(ranks + 1), receivedAt(ranks + 1);
  for (std::size_t k = 0; k < ranks; ++k) sent[k] = static_cast<int>(out[k].size());
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, MPI_COMM_WORLD);
  Message all;
  for (std::size_t k = 0; k < ranks; ++k) {
    all.insert(all.end(), out[k].begin(), out[k].end());
    sentAt[k + 1] = sentAt[k] + sent[k];
    receivedAt[k + 1] = receivedAt[k] + received[k];
  }
  Message come(static_cast<std::size_t>(receivedAt[ranks]));
  MPI_Alltoallv(all.data(), sent.data(), sentAt.data(), MPI_INT64_T, come.data(), received.data(), receivedAt.data(),
                MPI_INT64_T, MPI_COMM_WORLD);
  std::vector<Message> in(ranks);
  for (std::size_t k = 0; k < ranks; ++k) in[k].assign(come.begin() + receivedAt[k], come.begin() + receivedAt[k + 1]);
  return in;
}

}  // namespace mpi
