// Plays calls into a World. Beside the world it keeps the model (model.h), and holds each answer against it.
//
// An error says whether the engine is wrong, or the call was rightly refused. A name that is taken, or unknown, is
// refused without a call.
#pragma once

#include "oracle/trace/model.h"

#include <lgs/world.h>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace lgs::oracle {

/// What a brush did, as edits by hand.
struct Brushed {
  std::vector<Call> edits;  ///< removes of what it changed in any way, then adds of what is there now
  std::map<std::string, ScenePolygon> removed;                   ///< what these removed
  std::vector<std::pair<std::string, std::string>> became = {};  ///< of these, and of those that are there now
  std::vector<std::string> rounded;  ///< of those that are removed: what it is said to have bent against law 9
};

/// The engine is wrong.
inline tl::unexpected<TraceError> wrong(std::string text) {
  return tl::unexpected(TraceError{0, std::move(text), {}, true});
}

/// A call with what it names, and what must come of it.
struct Judged {
  Call call;
  Verdict verdict;
};

/// A call that was made, and what it gave; or that leads to the same as one that was made.
struct Told {
  Call call;
  Outcome outcome;
  bool isOther = false;
};
using Past = std::vector<std::shared_ptr<const Told>>;

class Player {
 public:
  explicit Player(PreservePairs preserve);

  /// Makes any call. If it is refused, everything stays as it was.
  tl::expected<void, TraceError> apply(const Call& call);
  Judged judge(const Call& call) const;
  tl::expected<void, TraceError> make(const Judged& judged);  ///< of no group, and not of what is repeated

  /// Commits, by the executor of this number, or without.
  const Changes& commit(std::uint32_t executor = 0);

  World& world() { return caller_.world; }
  const World& world() const { return caller_.world; }
  const Model& model() const { return model_; }
  const Standing& standing() const { return model_.standing(); }  ///< uncommitted edits included
  Scene scene() const { return model_.scene(preserve_); }
  const PreservePairs& preserve() const { return preserve_; }
  bool pending() const { return now_.pending; }  ///< edits since the last commit
  bool isAlive(const std::string& name) const { return standing().isAlive(name); }
  PolygonHandle handleOf(const std::string& name) const { return standing().handleOf(name); }  ///< of a name alive
  const auto& timeline() const { return caller_.timeline(); }
  std::set<Cell> takeEdited() { return std::exchange(edited_, {}); }  ///< that were edited since it was asked last
  const Caller& caller() const { return caller_; }
  const Outcome& foreseen() const { return foreseen_; }      ///< what was foreseen last
  const Brushed& brushed() const { return brushed_; }        ///< by the last call; empty if that was none of a brush
  std::size_t shapes() const { return now_.shapes.size(); }  ///< the number of different ones that the world has made

  /// The calls that led here, without those that were undone (law 12), refused (law 7), lead back, copy or save, and
  /// with chunks that come back in the other order. In a new world they give what they gave, and the same ids.
  const Past& past() const { return now_.past; }
  bool hasLeft() const { return hasLeft_; }          ///< whether any were left out, refused or turned around
  bool isOfOnePast() const { return isOfOnePast_; }  ///< false where chunks came or went that no calls could

 private:
  using Done = tl::expected<void, TraceError>;

  Done makeGroup(const Call& call);
  Done foresee(const Call& call);
  Done makeCall(const Judged& judged);
  Done brush(const Judged& judged);
  Done readBack(const Call& call, const BrushResult& result);
  Done checkShapes(const Call& call, const Outcome& outcome);
  void keepMoment(const Call& call);
  void noteEdited(const Call& call, const Outcome& outcome);
  void turn(const std::set<Cell>& away);
  std::string badName(const Call& call) const;
  tl::unexpected<TraceError> refused(const Error& error) const;

  struct Moment {
    Past past;
    std::map<Shape, ShapeId> shapes;
    bool pending = false;
    std::set<Cell> away, chunks;  // as in the model
  };

  Caller caller_;
  Outcome foreseen_;
  PreservePairs preserve_;
  Model model_;
  Moment now_;
  Timeline<Moment> moments_;
  Brushed brushed_;
  std::set<Cell> edited_;
  std::map<std::string, std::size_t> lost_;  // names that brushes have taken away, and the lines of these
  bool hasLeft_ = false;
  bool hasStreamed_ = false;
  bool isOfOnePast_ = true;
  bool hasTravelled_ = false;
};

/// Called after each commit; false stops the play.
using CommitCallback = std::function<bool(Player&, const Changes&)>;

/// Plays all of a trace, and commits what is pending at its end. Stops at the first edit that is refused, if the trace
/// may have none.
tl::expected<void, TraceError> play(const Trace& trace, Player& player, const CommitCallback& afterCommit = {});

}  // namespace lgs::oracle
