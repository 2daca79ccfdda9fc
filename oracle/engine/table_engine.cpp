#include "oracle/engine/table_engine.h"

#include "oracle/engine/answer.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <span>

namespace lgs::oracle {
namespace {

struct Answer {
  Capabilities can;
  std::vector<RefusedEdit> refused;
  Outline outline;
  SegmentChanges changes;
  std::string fault;  // of the first bad segment

  void take(const lgs_engine_segment& segment, OutlineSegment& to);
};

void takeRefused(void* to, const char* name, const char* reason) {
  static_cast<Answer*>(to)->refused.push_back({name, reason});
}

Point pointOf(const std::int64_t (&p)[2]) { return {p[0], p[1]}; }

void Answer::take(const lgs_engine_segment& s, OutlineSegment& to) {
  to = {pointOf(s.start), pointOf(s.end), s.block, {}, {}};
  if ((s.missing & 1U) == 0) to.ghost1 = pointOf(s.ghost1);
  if ((s.missing & 2U) == 0) to.ghost2 = pointOf(s.ghost2);
  if (fault.empty()) fault = faultOf(to, can);
  keepDeclared(to, can);
}

void takeSegments(void* to, const lgs_engine_segment* segments, std::size_t count) {
  Answer& answer = *static_cast<Answer*>(to);
  if (answer.can.delta) answer.fault = "segments, and declares 'delta'";
  for (const lgs_engine_segment& s : std::span(segments, count)) answer.take(s, answer.outline.emplace_back());
}

void takeChange(void* to, char sign, std::uint64_t id, const lgs_engine_segment* segment) {
  Answer& answer = *static_cast<Answer*>(to);
  OutlineSegment& taken = answer.changes.emplace_back(SegmentChange{sign, std::to_string(id)}).segment;
  if (!answer.can.delta) answer.fault = "a change, and does not declare 'delta'";
  if (sign != '-' && sign != '+' && sign != '~') answer.fault = "a change that is not '-', '+' or '~'";
  if (sign == '-') return;
  if (segment == nullptr)
    answer.fault = "a change without its segment";
  else
    answer.take(*segment, taken);
}

}  // namespace

tl::expected<std::unique_ptr<TableEngine>, std::string> TableEngine::make(const lgs_engine_table* table) {
  if (table == nullptr) return tl::unexpected<std::string>("lgs_engine() returns null");
  if (table->version != LGS_ENGINE_VERSION)
    return tl::unexpected(fmt::format("it is of version {}; there is only {}", table->version, LGS_ENGINE_VERSION));
  const bool isWhole = table->name && table->capabilities && table->create && table->destroy && table->reset &&
                       table->preserve && table->add && table->remove && table->commit;
  if (!isWhole) return tl::unexpected<std::string>("a pointer of its table is null");
  const auto can = parseCapabilities(table->capabilities);
  if (!can) return tl::unexpected(can.error());
  if (can->islands || can->time || can->regions)
    return tl::unexpected<std::string>("'islands', 'time' and 'regions': only the protocol has lines for them");
  std::unique_ptr<TableEngine> engine(new TableEngine(table));
  engine->introduce(table->name, *can);
  return engine;
}

tl::expected<std::unique_ptr<TableEngine>, std::string> TableEngine::load(const std::string& file) {
  const bool isPath = file.find('/') != std::string::npos;
  void* const library = dlopen((isPath ? file : "./" + file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return tl::unexpected<std::string>(dlerror());
  using Function = const lgs_engine_table*();
  void* const symbol = dlsym(library, "lgs_engine");
  if (symbol == nullptr) return tl::unexpected(file + ": it does not export lgs_engine()");
  auto engine = make(std::bit_cast<Function*>(symbol)());
  return engine ? std::move(engine) : tl::unexpected(file + ": " + engine.error());
}

void TableEngine::restart() {
  if (self_ != nullptr) table_->destroy(self_);
  self_ = nullptr;
}

void TableEngine::reset(const PreservePairs& preserve) {
  outline_.clear();
  delta_.clear();
  if (self_ == nullptr) self_ = table_->create();
  if (self_ == nullptr) return;  // commit() says so
  table_->reset(self_);
  for (const auto& [a, b] : preserve.pairs()) table_->preserve(self_, a, b);
}

void TableEngine::add(const std::string& name, const ScenePolygon& polygon) {
  if (self_ == nullptr) return;
  const auto& [cell, block, vertices] = polygon;
  xy_.clear();
  for (const LocalPoint v : vertices) xy_.insert(xy_.end(), {v.x, v.y});
  table_->add(self_, name.c_str(), cell.i, cell.j, block, xy_.data(), vertices.size());
}

void TableEngine::remove(const std::string& name) {
  if (self_ != nullptr) table_->remove(self_, name.c_str());
}

Engine::Refusals TableEngine::commit() {
  if (self_ == nullptr) return tl::unexpected(Failure{Failure::Kind::crash, "can not be created"});
  Answer answer{can(), {}, {}, {}, {}};
  const lgs_engine_answer taking{&answer, takeRefused, takeSegments, takeChange};
  table_->commit(self_, &taking);
  if (!answer.fault.empty()) return tl::unexpected(Failure{Failure::Kind::protocol, "put out " + answer.fault});
  outline_ = std::move(answer.outline);
  std::sort(outline_.begin(), outline_.end());
  delta_.take(std::move(answer.changes));
  return std::move(answer.refused);
}

}  // namespace lgs::oracle
