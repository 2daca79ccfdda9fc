#include "proptests/support/rapid.h"

#include <algorithm>
#include <limits>

namespace lgs::test::rapid {
namespace {

using rc::detail::CaseDescription;
using rc::detail::CaseResult;

class Quiet : public rc::detail::TestListener {
  void onTestCaseFinished(const CaseDescription&) override {}
  void onShrinkTried(const CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

}  // namespace

void tryCases(const Effort& effort, const rc::Gen<Case>& cases, bool shrinks,
              const std::function<bool(const Case&)>& holds) {
  const rc::detail::Property property = rc::gen::map(cases, [&](const Case& theCase) {
    CaseDescription description;
    description.result.type = holds(theCase) ? CaseResult::Type::Success : CaseResult::Type::Failure;
    description.example = [] { return rc::detail::Example(); };
    return description;
  });
  rc::detail::TestParams params;
  params.seed = effort.seed;
  params.maxSuccess = static_cast<int>(std::min<std::int64_t>(effort.cases, std::numeric_limits<int>::max()));
  params.disableShrinking = !shrinks;
  Quiet quiet;
  // No map of what is to be reproduced: RapidCheck then leaves its own settings (RC_PARAMS) alone.
  rc::detail::checkProperty(property, {}, params, quiet, {});
}

std::optional<std::string> failedAssertion(const std::function<void()>& work) {
  try {
    work();
  } catch (const CaseResult& result) {
    if (result.type != CaseResult::Type::Success) return result.description;
  }
  return std::nullopt;
}

void fail(const std::string& text) { throw CaseResult(CaseResult::Type::Failure, text); }

}  // namespace lgs::test::rapid
