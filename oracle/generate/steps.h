// Goes through a trace in steps. Edits in a row may be one call, and the names choose among the doors:
//
//   several  adds of one block to one cell
//   fill     adds of the same polygons and one block to each cell of a rectangle
//   clear    removes that leave nothing in a rectangle
//   replace  removes that leave nothing in a cell, then adds of one block to it; or such adds to an empty cell
//   setBlock a remove, then an add of the same polygon
//
// If one add of a row must be refused, so must the call that makes them all. The call is tried, and then the edits of
// the row come one by one.
//
// Nobody but the engine knows what a brush does. So whoever makes such a step tells the model of it.
#pragma once

#include "oracle/trace/model.h"
#include "oracle/trace/step.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace lgs::oracle {

class Steps {
 public:
  /// The trace must stay as it is.
  explicit Steps(const Trace& trace) : edits_(trace.edits) {}

  /// The next step, which the model has then made if it is accepted; nothing at the end of the trace.
  std::optional<Step> next();

  /// The last step was a brush, and this is what it did.
  void brushed(std::span<const Edit> edits);

  const Model& model() const { return model_; }

  /// The cells of the edits that were accepted since the last call of this.
  std::set<Cell> takeEdited() { return std::exchange(edited_, {}); }

 private:
  void make(const Edit& edit);
  Step take(std::size_t count, Door door);
  Step addition();
  Step removal();
  Door orReplace(Door door) const;
  std::optional<Step> setBlock();
  std::optional<Step> replacement();
  Step taken(std::size_t count, Door door);
  std::optional<Step> together(Door door);
  std::size_t inOneCell() const;
  std::size_t inRectangle(std::size_t inCell, CellRect& cells) const;
  std::size_t emptying(CellRect& cells) const;
  bool makes(const Step& step);
  Verdict judgeTrial(const Step& step) const;
  void wear(Step& step) const;
  void widen(CellRect& cells, std::uint64_t chance) const;

  std::span<const Edit> edits_;  // of the trace
  std::size_t at_ = 0;           // the next one
  std::size_t oneByOne_ = 0;     // the edits before this one were tried together
  Model model_;
  std::set<Cell> edited_;
};

}  // namespace lgs::oracle
