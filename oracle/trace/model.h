// The model: what must come of a call, and what stands afterwards. It knows the rules of edits, the limits of
// <lgs/world.h>, the marks of a world and which of its chunks are in memory, and nothing of segments. Where the headers
// leave open whether a call is accepted, the engine decides (Verdict::isOpen).
//
// No trace can reach two of the limits: 2^28 polygons placed in one cell, and 2^23 contents. An engine that refuses an
// edit for one of them is wrong.
#pragma once

#include "oracle/calls/caller.h"
#include "oracle/calls/timeline.h"
#include "oracle/trace/standing.h"
#include "oracle/trace/trace.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace lgs::oracle {

PreserveRelation relationOf(const PreservePairs& pairs);

/// Whether a rectangle that is not empty reaches far more chunks of 32×32 cells than a world has room for: a fill of it
/// is refused, whatever the world. Random calls make none that is near that.
bool isTooLarge(const CellRect& r);

/// What a call must be refused for; nothing if it must be accepted.
struct Verdict {
  bool accepted = true;
  std::optional<ErrorCode> code = {};  ///< none if the name is to blame, or where several things are wrong
  Cell cell = Error::kNoCell;          ///< the one that the refusal must name
  int index = -1;                      ///< the entry to blame, of a call that takes many
  bool isOfName = false;               ///< a name is to blame: there is nothing to call
  bool isOpen = false;                 ///< it may as well be refused, for this reason
};

class Model {
 public:
  /// The same call with what goes as handles and names, as they are now, and with what comes of a body.
  Call resolved(const Call& call) const;

  /// Of a call that is no group, and is not repeated. Where two things are wrong with an exchange, either may be told.
  Verdict judge(const Call& call) const { return judgeResolved(resolved(call)); }
  Verdict judgeResolved(const Call& call) const;

  /// Makes a call that was accepted; not a brush. What it places gets the handles of the outcome. `world` is as after
  /// the call: only of it is known as what chunks that were forgotten came back.
  void apply(const Call& call, const Outcome* outcome = nullptr, const World* world = nullptr);

  /// Makes any call but of a brush, if it must be accepted. Whether it must.
  bool play(const Call& call);

  /// What is wrong with the answer to a call that was judged, if anything is. `world` is as after the call, the model as
  /// before.
  std::string wrongAnswer(const Call& call, const Verdict& verdict, const Outcome& outcome, const World& world) const;

  /// By whoever makes edits beside the calls: a brush.
  void add(const std::string& name, ScenePolygon polygon, PolygonHandle handle = {});
  void remove(const std::string& name) {
    now_.pending = Pending::sure;
    now_.standing.remove(name);
  }
  void recolour(const std::string& name, Block block) { now_.standing.recolour(name, block); }
  std::string freshName() { return "#" + std::to_string(++names_); }  ///< that no text can say

  /// A call was refused: it may have made a shape.
  void tried() { timeline_.happened(Redo::maybe); }

  const Standing& standing() const { return now_.standing; }  ///< what is in memory
  bool isAlive(const std::string& name) const { return standing().isAlive(name); }
  Scene scene(PreservePairs preserve) const;  ///< all there is, also in chunks that are not in memory
  bool isLoaded(Cell cell) const { return now_.away.empty() || !now_.away.contains(chunkOf(cell)); }
  bool isWhole() const { return now_.away.empty(); }
  std::set<Cell> chunksAway() const;
  std::size_t chunks() const { return now_.chunks.size(); }  ///< of 32×32 cells, ever edited and not forgotten
  bool hasMarks() const { return timeline_.hasMarks(); }
  std::size_t marks() const { return timeline_.marks(); }
  bool hasAhead() const { return timeline_.hasAhead(); }
  /// Whether what an unloaded chunk holds is not what its bytes say, because edits of it were undone or redone since.
  enum class Owed : std::uint8_t { no, maybe, sure };
  /// Of the unloaded chunks that forgetChunks() would take, those that therefore stay.
  std::size_t owing(const CellRect& cells, Owed least) const;

  static Cell chunkOf(Cell cell) { return {cell.i >> 5, cell.j >> 5}; }
  static CellRect cellsOfChunk(Cell chunk) {
    return {{32 * chunk.i, 32 * chunk.j}, {32 * chunk.i + 31, 32 * chunk.j + 31}};
  }
  static std::vector<Cell> cellsOf(const CellRect& rect);  ///< by rows

  using Content = std::map<Cell, std::vector<Standing::Placed>>;  ///< of a chunk
  struct Given {
    std::string name;
    PolygonHandle handle;
  };
  enum class Pending : std::uint8_t { no, maybe, sure };  ///< edits since the last commit
  struct State {
    Standing standing;
    std::map<Cell, Content> away;   ///< chunks that are not in memory
    std::set<Cell> chunks;          ///< all of them
    std::set<Cell> alone;           ///< of those not in memory: no loaded one was around it at the last commit
    std::vector<Given> given;       ///< all that was ever placed
    std::vector<Body> bodies = {};  ///< all that was taken; their mass is not known
    Pending pending{};              ///< *maybe* where what was done may change nothing
  };

  /// Undoes a group of edits: these are from when it began.
  const State& state() const { return now_; }
  Redo redo() const { return timeline_.redo(); }
  void restore(State before, Redo redo) {
    goTo(std::move(before));
    timeline_.isUndone(redo);
  }

 private:
  Verdict judgeParts(const Call& call) const;
  Verdict addingTo(const Standing& standing, Cell cell, const Coming& coming) const;
  Verdict goesWrong(const Named& named) const;
  std::optional<Cell> firstAway(const CellRect& cells) const;
  std::vector<Cell> chunksWithin(const CellRect& cells, bool areLoaded) const;
  std::string wrongHandles(const Call& call, const Outcome& outcome) const;
  std::string wrongChunks(const Call& call, const Outcome& outcome) const;
  std::string wrongBodies(const Call& call, const Outcome& outcome) const;
  std::vector<std::string> islandOf(const std::string& name, bool byEdges) const;
  std::vector<Body> bodiesOf(const Call& call) const;
  Verdict judgeTake(const Call& call) const;
  std::vector<Coming> comingOf(const Call& call) const;
  std::string nameOf(const Body& body, const BodyPolygon& polygon) const;
  void take(const Call& call, const Outcome* outcome);
  void isPending(Pending least) { now_.pending = std::max(now_.pending, least); }
  void place(Cell cell, const Coming& coming, std::span<const PolygonHandle> handles);
  void clear(const CellRect& cells);
  void unload(const CellRect& cells);
  void reload(Cell corner, const World* world);
  bool isBesideLoaded(Cell chunk, const std::set<Cell>& gone = {}) const;
  std::vector<Cell> leaving(const CellRect& cells) const;
  Owed owed(Cell chunk) const;
  bool stays(Cell chunk, const World* world) const;
  void takeAway(Cell chunk);
  void bringBack(const Content& content);
  void goTo(State state);
  void empty(Cell chunk);
  std::vector<Cell> comingBack(const CellRect& cells) const;

  State now_;
  Timeline<State> timeline_;
  std::map<Cell, std::vector<Content>> shelf_;  // what chunks were unloaded as
  std::map<Cell, Owed> owed_;                   // unloaded ones that the world rolled back or redid over since
  bool hasForgotten_ = false;                   // chunks: their handles may be given again
  std::uint64_t names_ = 0;
};

/// Why a shape that a call brings must be refused by itself; nothing if it is good. A single polygon may be given in
/// reals, and one of them may be none.
std::optional<ErrorCode> faultOf(const Call& call, const Shape& shape);

/// The trace without the edits that must be refused: what `lgs replay` takes.
Trace withoutRefused(const Trace& trace);

}  // namespace lgs::oracle
