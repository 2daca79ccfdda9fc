// An engine of others as a subject: behind the protocol, or a shared object.
#pragma once

#include "bench/subjects/subject.h"
#include "oracle/engine/engine.h"

#include <string>
#include <vector>

namespace lgs::bench {

/// Each polygon is an add, and each edit ends with a commit. If the engine tells its own time, that is what counts;
/// otherwise all is in it: the pipe, what it prints, and reading that. An engine that gives no answer has no edges.
class OtherEngine final : public Incremental {
 public:
  explicit OtherEngine(oracle::Engine& engine) : engine_(engine) {}

  void prepare(const Tiles& tiles) override;
  bool build() override;
  Edges edges() const override;
  std::optional<Nanoseconds> ownTime() const override;

  void find(std::size_t) override {}
  void remove(std::size_t cell) override;
  void add(std::size_t cell, std::size_t kind) override;

 private:
  void addOnly(std::size_t cell, std::size_t kind);
  void removeOnly(std::size_t cell);
  void commit() { isAlive_ = isAlive_ && engine_.commit().has_value(); }

  oracle::Engine& engine_;
  const Tiles* tiles_ = nullptr;
  std::vector<std::size_t> count_;  // of polygons in each cell
  bool isAlive_ = true;
};

}  // namespace lgs::bench
