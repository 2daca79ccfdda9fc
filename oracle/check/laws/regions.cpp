// Law 8 of an engine that takes strokes: after each commit its outline is that of the exact result, or so near to it as
// the engine says. An engine may go on from what it has put out, or keep all strokes: so it is right if it is near to
// what the strokes since the last commit make of its own last outline, so many units for each of them; or to what all
// strokes make of nothing, so many units.
#include "oracle/cgal/brushed.h"
#include "oracle/check/comparable.h"
#include "oracle/check/laws/list.h"
#include "oracle/reference/naive.h"
#include "oracle/reference/words.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace lgs::oracle {
namespace {

class RegionsLaw : public Law {
 public:
  void begin(Seen&) override {
    before_.clear();
    done_ = 0;
  }

  Found afterCommit(Seen& seen) override {
    const Capabilities& can = seen.engine.can();
    Outline now = seen.shown();
    std::vector<BrushEdit> strokes = seen.strokes;
    if (!can.blocks) {
      for (OutlineSegment& s : now) s.block = 0;
      for (BrushEdit& stroke : strokes) stroke.block = 0;
    }
    if (std::string open = openAt(now); !open.empty()) return seen.mismatch(Mismatch::Kind::loops, std::move(open));
    if (seen.options.cgal) {
      ++seen.stats.cgal;
      ++seen.stats.whole;
      seen.stats.brushed += strokes.size() - done_;
      seen.stats.segments += now.size();
      const auto since = std::span(strokes).subspan(done_);
      const std::int64_t units = can.round * std::max<std::int64_t>(std::ssize(since), 1);
      auto far = farFromExact(before_, since, now, units);
      if (far && (can.round == 0 || farFromExact({}, strokes, now, can.round)))
        return tooFar(seen, std::move(*far), now);
    }
    done_ = strokes.size();
    before_ = now;
    constexpr std::int64_t kLong = std::int64_t{1} << 30;
    const auto isLong = [](const OutlineSegment& s) {
      return std::max(std::abs(s.end.x - s.start.x), std::abs(s.end.y - s.start.y)) >= kLong;
    };
    if (!seen.options.naive || !can.ghosts || std::ranges::any_of(now, isLong)) return std::nullopt;
    ++seen.stats.naive;
    const Outline expected = linked(now);
    return expected == now ? std::nullopt : seen.differing(Mismatch::Kind::naive, seen.scene(), expected, now);
  }

 private:
  // Where more segments of a block leave a vertex than arrive there, or fewer.
  static std::string openAt(const Outline& outline) {
    std::map<std::pair<Block, Point>, int> leaving;
    for (const OutlineSegment& s : outline) {
      ++leaving[{s.block, s.start}];
      --leaving[{s.block, s.end}];
    }
    const auto open = std::ranges::find_if(leaving, [](const auto& entry) { return entry.second != 0; });
    if (open == leaving.end()) return "";
    return "open outline: at " + inWords(open->first.second) +
           (open->second > 0 ? " more segments begin than end" : " more segments end than begin");
  }

  static Found tooFar(Seen& seen, FarOff far, const Outline& now) {
    Mismatch found = seen.mismatch(Mismatch::Kind::rounding, std::move(far.text));
    found.can.merged = true;
    found.can.ghosts = false;
    found.expected = comparable(std::move(far.exact), found.can);
    found.actual = comparable(now, found.can);
    return found;
  }

  Outline before_;
  std::size_t done_ = 0;  // strokes that made it
};

}  // namespace

std::unique_ptr<Law> laws::regions() { return std::make_unique<RegionsLaw>(); }

}  // namespace lgs::oracle
