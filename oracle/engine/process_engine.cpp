#include "oracle/engine/process_engine.h"

#include "oracle/engine/answer.h"
#include "oracle/trace/coordinate.h"

#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>

namespace lgs::oracle {

Guard::Program shell(std::string command) {
  return [command = std::move(command)] { execl("/bin/sh", "sh", "-c", command.c_str(), nullptr); };
}

tl::expected<std::unique_ptr<ProcessEngine>, Failure> ProcessEngine::start(const ProcessOptions& options) {
  std::unique_ptr<ProcessEngine> engine(new ProcessEngine(options));
  if (auto failure = engine->begin()) return tl::unexpected(std::move(*failure));
  return engine;
}

std::optional<Failure> ProcessEngine::begin() {
  child_.emplace(options_.program, options_.verbose);
  const bool isFirst = name().empty();
  const auto take = [&](std::string_view line) -> tl::expected<bool, std::string> {
    auto hello = parseHello(line);
    if (!hello) return tl::unexpected(hello.error());
    if (isFirst) introduce(hello->name, hello->can);
    return true;
  };
  return ask("lgs-engine 1\n", take, std::chrono::duration_cast<Clock::duration>(options_.timeout));
}

std::optional<Failure> ProcessEngine::ask(std::string_view text, const Child::Take& take, Clock::duration patience) {
  auto failure = child_->ask(text, take, patience);
  if (failure) child_.reset();
  return failure;
}

// A hang is shrunk by trial, and each trial waits in vain.
Child::Clock::duration ProcessEngine::patience() const {
  using namespace std::chrono_literals;
  constexpr int kTimes = 5, kParts = 8;
  const auto timeout = std::chrono::duration_cast<Clock::duration>(options_.timeout);
  if (haste_ == Haste::none) return timeout;
  const auto enough = haste_ == Haste::some ? kTimes * slowest_ : std::min(timeout / kParts, kTimes * slowest_);
  return std::min(timeout, std::max<Clock::duration>(200ms, enough));
}

void ProcessEngine::reset(const PreservePairs& preserve) {
  failure_.reset();
  if (!child_) failure_ = begin();
  unsent_ = "reset\n";
  for (const auto& [a, b] : preserve.pairs()) unsent_ += fmt::format("preserve {} {}\n", a, b);
  outline_.clear();
  islands_.clear();
  delta_.clear();
}

void ProcessEngine::add(const std::string& name, const ScenePolygon& polygon) {
  unsent_ += fmt::format("add {} {} {} {}", name, polygon.cell.i, polygon.cell.j, polygon.block);
  for (const LocalPoint& p : polygon.vertices) {
    unsent_ += ' ';
    printDecimal(p.x, unsent_);
    unsent_ += ' ';
    printDecimal(p.y, unsent_);
  }
  unsent_ += '\n';
}

void ProcessEngine::remove(const std::string& name) { unsent_ += fmt::format("remove {}\n", name); }

void ProcessEngine::stroke(const BrushEdit& brush) {
  const bool carves = brush.deed == BrushEdit::Deed::carve;
  unsent_ += carves ? "carve"
                    : fmt::format("paint {} {}", brush.block, brush.deed == BrushEdit::Deed::fill ? "fill" : "replace");
  for (std::size_t k = 0; k < brush.rings.size(); ++k) {
    if (k != 0) unsent_ += " |";
    for (const Point p : brush.rings[k]) {
      unsent_ += ' ';
      printDecimal(p.x, unsent_);
      unsent_ += ' ';
      printDecimal(p.y, unsent_);
    }
  }
  unsent_ += '\n';
}

Engine::Refusals ProcessEngine::commit() {
  if (failure_) return tl::unexpected(*failure_);
  unsent_ += "commit\n";
  AnswerReader reader(can());
  const Clock::time_point begin = Clock::now();
  auto failure = ask(
      unsent_, [&](std::string_view line) { return reader.take(line); }, patience());
  unsent_.clear();
  if (failure) {
    constexpr int kSlow = 4;
    if (failure->kind == Failure::Kind::hang && slowest_ * kSlow > patience())
      failure->text += fmt::format(" (perhaps it is slow, and not stuck: it needed {:.1f} s before)",
                                   std::chrono::duration<double>(slowest_).count());
    failure_ = failure;
    return tl::unexpected(std::move(*failure));
  }
  slowest_ = std::max(slowest_, Clock::now() - begin);
  outline_ = std::move(reader.outline);
  std::sort(outline_.begin(), outline_.end());
  islands_ = std::move(reader.islands);
  std::sort(islands_.begin(), islands_.end());
  delta_.take(std::move(reader.changes));
  time_ = reader.time;
  return std::move(reader.refused);
}

std::optional<Failure> ProcessEngine::finish() {
  if (!child_) return std::nullopt;
  auto failure = child_->finish(patience());
  child_.reset();
  return failure;
}

}  // namespace lgs::oracle
