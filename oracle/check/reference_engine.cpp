#include "oracle/check/reference_engine.h"

#include "oracle/cgal/cgal_union.h"
#include "oracle/reference/compare.h"

#include <utility>

namespace lgs::oracle {

ReferenceEngine::ReferenceEngine(bool naive, bool cgal) : isNaive_(naive), isCgal_(cgal) {
  Capabilities can = Capabilities::all();
  can.preserve = naive;
  introduce("oracle", can);
}

void ReferenceEngine::reset(const PreservePairs& preserve) {
  model_ = {};
  preserve_ = isNaive_ ? preserve : PreservePairs();
  outline_.clear();
  refused_.clear();
}

void ReferenceEngine::add(const std::string& name, const ScenePolygon& polygon) {
  const Call call = Call::add(name, polygon);
  if (accepts(call)) model_.play(call);
}

void ReferenceEngine::remove(const std::string& name) {
  const Call call = Call::remove(name);
  if (accepts(call)) model_.play(call);
}

// Notes the refusal, if the edit must be refused.
bool ReferenceEngine::accepts(const Call& call) {
  const Verdict verdict = model_.judge(call);
  if (verdict.accepted) return true;
  const char* const ofName = call.kind == Call::Kind::add ? "name in use" : "unknown name";
  refused_.push_back({call.name(), verdict.code ? lgs::name(*verdict.code) : ofName});
  return false;
}

Engine::Refusals ReferenceEngine::commit() {
  if (isNaive_) outline_ = naive_(model_.scene(preserve_)).outline;
  if (isCgal_) {
    if (auto failure = unite()) return tl::unexpected(std::move(*failure));
  }
  return std::exchange(refused_, {});
}

std::optional<Failure> ReferenceEngine::unite() {
  auto united = cgalUnion(model_.scene(preserve_));
  if (!isNaive_) {  // then there is no preserve relation, so CGAL knows everything
    outline_ = std::move(united->outline);
    return std::nullopt;
  }
  if (!united) return std::nullopt;  // a preserve relation that is no partition: CGAL has no say
  const Outline expected = withUnknownLinksOf(outline_, std::move(united->outline), united->known);
  if (expected == outline_) return std::nullopt;
  return Failure{Failure::Kind::protocol,
                 "the naive reference's outline differs from CGAL's:\n" + describe(compare(expected, outline_))};
}

}  // namespace lgs::oracle
