// What must come of a call: the naive world (model.h) judges it and makes it.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/trace/model.h"

#include <span>
#include <string>
#include <vector>

namespace lgs::oracle {

PreserveRelation relationOf(const PreservePairs& pairs);

class CallModel {
 public:
  /// Of a resolved call (caller.h) that is no group. Where two things are wrong with an exchange, either may be told.
  Verdict judge(const Call& call) const;

  /// Makes a call that was accepted. What it places has these handles, and these names; without names, any.
  void apply(const Call& call, std::span<const PolygonHandle> handles, std::span<const std::string> names = {});

  /// The same for an edit by itself, whoever made it.
  void apply(const Edit& edit, PolygonHandle handle = {}) { standing_.apply(edit, handle); }

  /// What is wrong with the answer to a call that was judged, if anything is. `world` is as after the call, the model as
  /// before.
  std::string wrongAnswer(const Call& call, Verdict verdict, const Outcome& outcome, const World& world) const;

  const Model& standing() const { return standing_; }

 private:
  Verdict judgeParts(const Call& call) const;
  bool isAlive(PolygonHandle handle) const { return standing_.nameOf(handle) != nullptr; }
  std::string wrongHandles(const Call& call, const Outcome& outcome) const;
  void clear(const CellRect& cells);

  Model standing_;
  std::vector<Model> marks_;
};

}  // namespace lgs::oracle
