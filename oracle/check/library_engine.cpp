#include "oracle/check/library_engine.h"

#include <algorithm>
#include <utility>

namespace lgs::oracle {

void LibraryEngine::reset(const PreservePairs& preserve) {
  player_.emplace(preserve);
  refused_.clear();
}

void LibraryEngine::add(const std::string& name, const ScenePolygon& polygon) {
  static_cast<void>(apply(player_->judge(Call::add(name, polygon))));
}

void LibraryEngine::remove(const std::string& name) { static_cast<void>(apply(player_->judge(Call::remove(name)))); }

void LibraryEngine::stroke(const BrushEdit& brush) { static_cast<void>(apply(player_->judge(Call::byBrush(brush)))); }

Engine::Refusals LibraryEngine::commit() {
  changes_ = &player_->commit(std::exchange(executor_, 0));
  return std::exchange(refused_, {});
}

Outline LibraryEngine::outlineIn(const CellSet& cells) const {
  Outline outline;
  for (const Cell& cell : cells) {
    for (const SegmentId id : player_->world().segments(CellRect{cell, cell})) {
      if (const auto segment = player_->world().segment(id)) outline.push_back(outlineSegment(*segment));
    }
  }
  std::sort(outline.begin(), outline.end());
  return outline;
}

tl::expected<void, TraceError> LibraryEngine::apply(const Judged& judged) {
  const Call& call = judged.call;
  auto done = has(call.kind, KindOfCall::parts) ? player_->apply(call) : player_->make(judged);
  if (done && (call.kind == Call::Kind::rollBack || call.kind == Call::Kind::redo))
    changes_ = &player_->world().changesOfRollBack();
  if (!done && !done.error().isWrong) refused_.push_back({call.name(), done.error().text});
  return done;
}

}  // namespace lgs::oracle
