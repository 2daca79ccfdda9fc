// The end of a line that follows. Each of its cells holds what the server's held at some turn, and never goes back to
// an earlier one: what is older than anything received is left out. So whatever was lost, or came twice or late, both
// ends are equal once the server's last turn got through.
//
// Edits that follow each other are made as they come. Where the hashes of both worlds differ then, for whatever reason,
// the client requests the hashes of the squares inside the one that differs, and so on, down to chunks that it has
// nothing of, or to leaves: only these are sent. A client that begins with nothing comes to all ground in the same way.
#pragma once

#include "message.h"

#include <set>
#include <vector>

namespace in_step {

class Client {
 public:
  /// Of a world that follows its cells and has no edits that are not committed, nor unloaded chunks, now or later: they
  /// would count as empty. It must outlive this. It ends with the server: make a new one for a server that starts again.
  explicit Client(lgs::World& world);

  /// To be called with each message. Returns what to send to the server. No edit of the world may be pending.
  std::vector<Bytes> receive(std::span<const std::byte> message);

  /// To be called now and then, more seldom than an answer takes: returns what to send, if both ends differed at the
  /// last message; once more if there was no answer, as that may have been lost.
  std::vector<Bytes> tick();

  /// To be called with what the game has committed in the world, say a guess. The server's version will replace it. No
  /// edit may be pending.
  void update(const lgs::Changes& changes) {
    if (!hashes_.update(world_, changes)) hashes_ = lgs::GroundHashes(world_);  // one was missed
  }

  /// Whether the worlds were equal, as of the last message.
  bool isInStep() const { return turn_ != 0 && theirHash_ == hashes_.hash(); }

 private:
  void set(const Ground& ground, const lgs::CellRect& cells);
  std::vector<Bytes> compare(const News& news);
  void ask(const Question& question, std::vector<Bytes>& out);

  lgs::World& world_;
  lgs::GroundHashes hashes_;
  std::uint64_t turn_ = 0;  ///< the latest that was received; 0: none
  std::uint64_t theirHash_ = 0;
  Square theirWhole_;
  std::set<Question> open_;  ///< what was sent, and not answered yet
};

}  // namespace in_step
