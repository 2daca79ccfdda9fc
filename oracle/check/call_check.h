// Makes calls of the alphabet in a world, and holds each against the model: the answer, and after each commit the
// polygons and the outline.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/reference/scene.h"
#include "oracle/trace/call_model.h"

#include <functional>
#include <optional>
#include <string>

namespace lgs::oracle {

class CallCheck {
 public:
  CallCheck(Cell corner, PreservePairs preserve);

  /// What is wrong, if anything is: then the world is not to be used any more.
  std::optional<std::string> make(const Call& call);

  bool triesRefused = true;  ///< if false, what must be refused is left out, but for the shapes that it makes
  std::function<void(const Call&, const Outcome&)> afterAccepted;  ///< no groups, but their parts

  const World& world() const { return caller_.world; }
  World& world() { return caller_.world; }  ///< for what is done beside the calls, of which they may notice nothing

 private:
  std::string makeOne(const Call& call, bool& isAccepted);
  std::string makeGroup(const Call& call);
  std::string look() const;

  PreservePairs preserve_;
  Caller caller_;
  CallModel model_;
};

}  // namespace lgs::oracle
