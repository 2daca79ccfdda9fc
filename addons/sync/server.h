// The end of a line that has the world. It knows nothing of its clients: it reports to all of them what each commit
// changed, and answers each question. How messages travel is up to others.
//
// Chunks of the world may be unloaded: they are not gone. Their hashes are kept, no client takes them for empty, and
// questions about what is in them are answered once they are back. Commit before you unload. Forgotten chunks
// (World::forgetChunks()) count as empty, and clients empty them: leave them unloaded.
//
// Clients end with their server: one that starts again counts its turns from 1, and nobody who heard a later turn
// listens to it.
#pragma once

#include "message.h"

#include <optional>
#include <set>
#include <vector>

namespace in_step {

class Server {
 public:
  /// Of a world that follows its cells and has no edits that are not committed, nor unloaded chunks. It must outlive
  /// this. While it does not follow its cells, each update reads all of it.
  explicit Server(const lgs::World& world) : Server(world, lgs::GroundHashes(world)) {}
  /// The same of one that may have unloaded chunks, with the hashes of all its ground, whether loaded or not.
  Server(const lgs::World& world, lgs::GroundHashes hashes);

  /// To be called with what each commit, roll-back and redo changed: returns what to send to all clients. What
  /// changed more than kMaxCells cells, or holds more than kMaxVertices vertices there, is reported without them:
  /// clients find out. So it is if one was missed; then all that is loaded is read again, and chunks that are not count
  /// as they were reported last. A commit that changed nothing makes no turn: the message is a sign of life.
  Bytes update(const lgs::Changes& changes);

  /// To be sent to all clients now and then: so one that lost the last message learns of it.
  Bytes signOfLife() const;

  /// What to send back; nothing, if it is no question, or one about cells that are unloaded. Best while no edit is
  /// pending: one that is will be reported, though it may come to nothing yet. Cost: that of the chunk in question; or
  /// O(1).
  std::optional<Bytes> answer(std::span<const std::byte> question) const;

 private:
  News news(News::Kind kind, const Square& square) const;
  std::vector<lgs::CellChange> edits();
  bool readWhatCameBack();
  void beginAgain();

  const lgs::World& world_;
  lgs::GroundHashes hashes_;
  std::set<lgs::Cell> away_;  ///< unloaded chunks, by their lower-left cells
  std::uint64_t version_;     ///< of the world, as it was reported last
  std::uint64_t turn_ = 1;
};

}  // namespace in_step
