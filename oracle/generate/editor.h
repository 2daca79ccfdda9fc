// Makes random calls, one operation at a time, with given habits: the one maker of traces. The model accepts them,
// except for those that it makes in order to be refused.
#pragma once

#include "oracle/calls/draw.h"
#include "oracle/calls/random.h"
#include "oracle/engine/capabilities.h"
#include "oracle/generate/strokes.h"
#include "oracle/trace/model.h"
#include "oracle/trace/trace.h"

#include <set>
#include <vector>

namespace lgs::oracle {

/// What an editor likes to do; the weights are relative to each other.
struct EditHabits {
  std::vector<std::vector<LocalPolygon>> shapes;  ///< at least one
  bool turnShapes = true;                         ///< by the symmetries of the cell
  std::vector<Block> blocks;                      ///< at least one
  std::vector<Cell> cells;                        ///< at least one
  bool wander = false;                            ///< the next cell is near the last one

  int place = 0;    ///< a shape, or some of its polygons
  int fill = 0;     ///< a shape in each cell of a rectangle
  int lean = 0;     ///< a triangle on an edge in the cell, or on a part of it
  int scatter = 0;  ///< a random polygon, on a coarse or a fine grid
  int restore = 0;  ///< what stood in the cell at the start
  int remove = 0;   ///< one polygon
  int clear = 0;    ///< the whole cell, or a rectangle
  int replace = 0;  ///< takes a polygon away and puts it back
  int refused = 0;  ///< something that must be refused
  int any = 0;      ///< any call of the alphabet (oracle/calls/draw.h), good or bad
  int stroke = 0;   ///< of a brush
  StrokeHabits strokes = {};
  int travel = 0;  ///< marks, back and forward; groups; copies, saves
  int carry = 0;   ///< islands are taken and put back, edits are foreseen
  int memory = 0;  ///< chunks leave memory, and come back; places are forgotten; cells are worn

  int commitPercent = 100;  ///< chance of a commit after an operation
  bool forms = false;       ///< edits are made by calls of all kinds that come to the same
  int hostilePercent = 0;   ///< of any calls: the ends of numbers

  Capabilities can = Capabilities::all();  ///< what edits must be fit for; the shapes must be, too
};

class Editor {
 public:
  /// Goes on where `start` ends. The trace must hold no refused edits.
  Editor(Trace start, EditHabits habits, Random random);

  /// One operation, and perhaps a commit.
  void operate();
  void operate(Random random) {
    random_ = random;
    operate();
  }

  /// Makes this many edits, the last ones committed. To be called once.
  void run(std::size_t edits);

  std::size_t edits() const { return edits_; }  ///< made so far, commits not counted

  Trace takeTrace() { return std::move(trace_); }

 private:
  using Operation = void (Editor::*)(Cell);
  using Edits = std::vector<Call>;
  Operation pickOperation();
  Cell pickCell();
  Cell anyCell();

  void place(Cell cell);
  void fill(Cell cell);
  void lean(Cell cell);
  void scatter(Cell cell);
  void restore(Cell cell);
  void remove(Cell cell);
  void clear(Cell cell);
  void replace(Cell cell);
  void tryRefused(Cell cell);
  void any(Cell cell);
  void stroke(Cell cell);
  void travel(Cell cell);
  void carry(Cell cell);
  void remember(Cell cell);
  void cutAtTheEdge(Cell cell);

  static Call squareAt(Cell cell);
  Call anyEdit(Cell cell);
  std::vector<Cell> rectangleAt(Cell cell);
  void empty(Cell cell);
  void look(Cell cell);
  void bringBack(Cell cell);
  void allComesBack(Cell cell);
  void turn(Call::Kind kind, Cell cell);
  bool isFit(const Call& add) const;
  bool isAlive(const std::string& name) const;
  bool addIfGood(Cell cell, Block block, LocalPolygon vertices);
  void removeNamed(std::string name);
  void edit(Call edit);  // of the operation: it is made at the end of it
  void make(Call call);  // now
  void makeEdits();
  void push(Call call);
  std::string freshName();
  LocalPolygon randomPolygon();
  LocalPolygon randomBox();
  LocalPolygon randomRange();
  LocalPolygon randomStar();
  LocalPoint randomPoint();

  Trace trace_;
  EditHabits habits_;
  Random random_;
  Model model_;
  Standing start_;
  Cell at_;
  std::int32_t step_ = 1;  // of the grid for random points
  std::size_t edits_ = 0;
  std::size_t names_ = 0;
  std::string lastRemoved_;
  Edits op_;                    // edits of the operation
  Standing near_;               // what stands where it edits, as after these
  std::set<Cell> brushed_;      // where brushes may have changed what stands, which the model does not know
  std::set<std::string> gone_;  // names that they have removed
};

}  // namespace lgs::oracle
