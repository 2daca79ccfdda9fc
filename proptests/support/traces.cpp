#include "proptests/support/traces.h"

#include "oracle/check/shrink.h"
#include "oracle/generate/generator.h"
#include "oracle/trace/model.h"
#include "proptests/support/time_limit.h"

#include <ostream>
#include <utility>

namespace lgs::test {
namespace {

using oracle::Call;
using oracle::Random;
using oracle::ShrinkWalk;
using oracle::Trace;
using MayBe = std::function<bool(const Trace&)>;

/// A trace, and RapidCheck's way from it to simpler ones: the walk of the project's shrinker. RapidCheck asks a
/// sequence for one candidate after the other; one that still fails is where it goes on.
class Simpler {
 public:
  Simpler(ShrinkWalk walk, MayBe mayBe) : walk_(std::move(walk)), mayBe_(std::move(mayBe)) {}

  Trace value() const { return walk_.best(); }
  rc::Seq<rc::Shrinkable<Trace>> shrinks() const { return rc::makeSeq<Candidates>(walk_, mayBe_); }

 private:
  struct Candidates {
    Candidates(ShrinkWalk w, MayBe m) : walk(std::move(w)), mayBe(std::move(m)) {}
    rc::Maybe<rc::Shrinkable<Trace>> operator()() {
      while (!isTimeUp()) {
        auto candidate = walk.next();
        if (!candidate) break;
        if (mayBe && !mayBe(*candidate)) continue;
        ShrinkWalk accepted = walk;
        accepted.accept(std::move(*candidate));
        return rc::makeShrinkable<Simpler>(std::move(accepted), mayBe);
      }
      return rc::Nothing;
    }
    ShrinkWalk walk;
    MayBe mayBe;
  };

  ShrinkWalk walk_;
  MayBe mayBe_;
};

Trace randomTrace(int size, Random random, oracle::GeneratorOptions options) {
  // A commit goes another way where a row has many dirty cells: so every third case is a wide and low one.
  const bool isWide = random.below(3) == 0;
  options.width = isWide ? 8 + random.below(12) : 1 + random.below(5);
  options.height = 1 + random.below(isWide ? 3 : 4);
  constexpr std::size_t kMostEdits = 60;
  options.edits = 1 + random.below(1 + kMostEdits * static_cast<std::size_t>(size) / 100);
  return oracle::randomCase(options, random.next());
}

Trace anyTrace(int size, Random random) { return randomTrace(size, random, {.isOfCalls = true}); }
Trace traceOfStrokes(int size, Random random) {
  return randomTrace(size, random, {.isOfCalls = true, .brushes = true});
}
Trace goodTrace(int size, Random random) { return withoutRefused(randomTrace(size, random, {})); }

Trace plainTrace(int size, Random random) {
  Trace trace = randomTrace(size, random, {});
  trace.preserve = {};
  return withoutRefused(trace);
}

template <class Kind>
rc::Gen<Kind> ofKind(rc::Gen<Trace> traces) {
  return rc::gen::map(std::move(traces), [](Trace&& trace) { return Kind{std::move(trace)}; });
}

}  // namespace

bool isGood(const Trace& trace) { return withoutRefused(trace).calls.size() == trace.calls.size(); }

rc::Gen<Trace> traces(const std::function<Trace(int, Random)>& make, const MayBe& mayBe) {
  return [=](rc::Random random, int size) {
    return rc::makeShrinkable<Simpler>(ShrinkWalk(make(size, Random(random.next()))), mayBe);
  };
}

std::map<std::string, Call> survivors(const Trace& trace) {
  std::map<std::string, Call> out;
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::add) out[edit.name()] = edit;
    if (edit.kind == Call::Kind::remove) out.erase(edit.name());
  }
  return out;
}

CellRect boundsOf(const Trace& trace) {
  CellRect r{{kMaxCell, kMaxCell}, {-kMaxCell, -kMaxCell}};
  for (const Call& edit : trace.calls) {
    if (edit.kind != Call::Kind::add) continue;
    const Cell c = edit.polygon().cell;
    r = {{std::min(r.min.i, c.i), std::min(r.min.j, c.j)}, {std::max(r.max.i, c.i), std::max(r.max.j, c.j)}};
  }
  return r;
}

Trace movedTo(Trace trace, Cell target) {
  const CellRect bounds = boundsOf(trace);
  for (Call& edit : trace.calls) {
    if (edit.kind != Call::Kind::add) continue;
    Cell& cell = edit.comes[0].cell;
    cell = {cell.i - bounds.min.i + target.i, cell.j - bounds.min.j + target.j};
  }
  return trace;
}

void showValue(const Chance& chance, std::ostream& out) {
  chance.seed ? out << "chance " << *chance.seed : out << "as it comes";
}

rc::Gen<AnyTrace> AnyTrace::arbitrary() { return ofKind<AnyTrace>(traces(anyTrace, {})); }
rc::Gen<TraceOfStrokes> TraceOfStrokes::arbitrary() { return ofKind<TraceOfStrokes>(traces(traceOfStrokes, {})); }
rc::Gen<GoodTrace> GoodTrace::arbitrary() { return ofKind<GoodTrace>(traces(goodTrace)); }
rc::Gen<PlainTrace> PlainTrace::arbitrary() {
  return ofKind<PlainTrace>(traces(plainTrace, [](const oracle::Trace& t) { return t.preserve.empty() && isGood(t); }));
}
rc::Gen<Chance> Chance::arbitrary() {
  return [](rc::Random random, int) {
    const auto simpler = [](const Chance& chance) { return chance.seed ? rc::seq::just(Chance()) : rc::Seq<Chance>(); };
    return rc::shrinkable::shrinkRecur(Chance(random.next()), simpler);
  };
}

}  // namespace lgs::test
