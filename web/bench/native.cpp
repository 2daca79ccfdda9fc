// The native engine, for bench.mjs beside it: the same edits as in scenario.mjs, and a sum of everything that was read.
// For each line of input, `edits KIND COUNT` or `build KIND`, it prints nanoseconds of the processor an edit or a world,
// and the sum.
#include <lgs/world.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr unsigned kSide = 100;
constexpr unsigned kCells = kSide * kSide;
constexpr unsigned kHoles = 100;
constexpr lgs::Block kBlock = 7;

double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

void must(const lgs::Expected<void>& done) {
  if (!done) std::abort();
}

lgs::Cell cellOf(unsigned cell) { return {static_cast<int>(cell % kSide), static_cast<int>(cell / kSide)}; }

class Scenario {
 public:
  explicit Scenario(bool isFull) : isFull_(isFull) {
    for (unsigned cell = 0; cell < kCells; ++cell) shapes_.push_back(isFull ? 0 : random(4));
    makeWorld();
  }

  void makeWorld() {
    world_ = std::make_unique<lgs::World>();
    constexpr std::array<lgs::DoublePoint, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::vector<lgs::ShapeId> ids;
    for (std::size_t left = 0; left < (isFull_ ? 1U : 4U); ++left) {
      std::vector<lgs::DoublePoint> vertices(square.begin(), square.end());
      if (!isFull_) vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(left));
      ids.push_back(*world_->shape(vertices));
    }
    placements_.clear();
    for (unsigned cell = 0; cell < kCells; ++cell) placements_.push_back({cellOf(cell), ids[shapes_[cell]], kBlock});
    handles_.resize(kCells);
    must(world_->addMany(placements_, handles_));
    read(world_->commit());
  }

  void edit(unsigned count) {
    for (; dug_ < kHoles; ++dug_) dig();
    for (unsigned k = 0; k < count; k += 2) {
      const unsigned cell = order_[next_];
      isHole_[cell] = false;
      handles_[cell] = *world_->add(placements_[cell].cell, placements_[cell].shape, kBlock);
      read(world_->commit());
      dig();
    }
  }

  double sum() const { return sum_; }

 private:
  unsigned random(unsigned below) { return static_cast<unsigned>(random_()) % below; }

  void dig() {
    unsigned cell = random(kCells);
    while (isHole_[cell]) cell = random(kCells);
    isHole_[cell] = true;
    order_[next_] = cell;
    next_ = (next_ + 1) % kHoles;
    must(world_->remove(handles_[cell]));
    read(world_->commit());
  }

  void read(const lgs::Changes& changes) {
    for (const lgs::SegmentId id : changes.removed) sum_ += id.value;
    readSegments(changes.added);
    readSegments(changes.relinked);
  }

  void readSegments(const std::vector<lgs::SegmentId>& ids) {
    segments_.resize(ids.size());
    must(world_->segments(ids, lgs::Point{}, std::span(segments_)));
    for (const auto& s : segments_) {
      for (const lgs::DoublePoint p : {s.start, s.end, s.ghost1, s.ghost2}) sum_ += p.x + 2 * p.y;
      sum_ += s.id.value + s.block + s.cell.i + s.cell.j + s.predecessor.value + s.successor.value;
      owners_ += s.polygon.cellRef;
    }
  }

  bool isFull_;
  std::minstd_rand random_;
  std::vector<unsigned> shapes_;
  std::unique_ptr<lgs::World> world_;
  std::vector<lgs::Placement> placements_;
  std::vector<lgs::PolygonHandle> handles_;
  std::vector<lgs::DoubleSegment> segments_;
  std::array<bool, kCells> isHole_{};
  std::array<unsigned, kHoles> order_{};
  unsigned next_ = 0;
  unsigned dug_ = 0;
  double sum_ = 0;
  double owners_ = 0;  // of handles, which differ in JavaScript
};

}  // namespace

int main() {
  std::array<Scenario, 4> scenarios{Scenario(true), Scenario(false), Scenario(true), Scenario(false)};
  std::string task;
  std::string kind;
  while (std::cin >> task >> kind) {
    const std::size_t k = kind == "full" ? 0 : 1;
    unsigned count = 1;
    if (task == "edits") std::cin >> count;
    Scenario& scenario = scenarios[task == "edits" ? k : 2 + k];
    const double start = now();
    task == "edits" ? scenario.edit(count) : scenario.makeWorld();
    std::cout << static_cast<long long>((now() - start) / count) << ' ' << static_cast<long long>(scenario.sum())
              << std::endl;
  }
}
