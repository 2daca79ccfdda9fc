// The end of a line that has the world. It knows nothing of its clients: it tells all of them what each commit changed,
// and answers whoever asks. How messages travel is up to others.
#pragma once

#include "message.h"

#include <optional>

namespace in_step {

class Server {
 public:
  /// Of a world that follows its cells and has no edits that are not committed. It must outlive this.
  explicit Server(const lgs::World& world);

  /// To be called after each commit, roll-back and roll-forward: says what to tell all clients. What changed more than
  /// kMaxCells cells is told without them: clients find out.
  Bytes update();

  /// To be sent to all clients now and then: so one that lost the last message hears of it.
  Bytes signOfLife() const;

  /// What to send to who asked; nothing, if it is no question. Best while no edit is pending: one that is will be told,
  /// though it may come to nothing yet. Cost: that of the chunk asked for; or O(1).
  std::optional<Bytes> answer(std::span<const std::byte> question) const;

 private:
  News news(News::Kind kind, const Square& square) const;

  const lgs::World& world_;
  lgs::GroundHashes hashes_;
  std::uint64_t turn_ = 1;
};

}  // namespace in_step
