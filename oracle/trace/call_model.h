// What must come of a call: the naive world (model.h) judges it and makes it.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/trace/model.h"

#include <string>
#include <vector>

namespace lgs::oracle {

PreserveRelation relationOf(const PreservePairs& pairs);

class CallModel {
 public:
  /// Of a resolved call (caller.h) that is no group. Where two things are wrong with an exchange, either may be told.
  Verdict judge(const Call& call) const;

  /// Makes a call that was accepted.
  void apply(const Call& call, const Outcome& outcome);

  /// What is wrong with the answer to a call, if anything is. `world` is as after the call, the model as before.
  std::string wrongAnswer(const Call& call, const Outcome& outcome, const World& world) const;

  const Model& standing() const { return standing_; }  ///< its names are those of handles
  static std::string nameOf(PolygonHandle handle);

 private:
  Verdict judgeParts(const Call& call) const;
  bool isAlive(PolygonHandle handle) const;
  std::string wrongHandles(const Call& call, const Outcome& outcome) const;
  void remove(PolygonHandle handle);
  void clear(const CellRect& cells);
  void place(Cell cell, const Coming& coming, std::span<const PolygonHandle> handles);

  Model standing_;
  std::vector<Model> marks_;
};

}  // namespace lgs::oracle
