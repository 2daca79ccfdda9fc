#include "oracle/check/law.h"

#include "oracle/check/comparable.h"
#include "oracle/check/failure.h"
#include "oracle/engine/answer.h"
#include "oracle/reference/compare.h"
#include "oracle/reference/words.h"
#include "oracle/trace/plain_edits.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

namespace lgs::oracle {

Seen::Seen(const Trace& checked, const CheckOptions& by, CheckStats& counts)
    : trace(checked),
      options(by),
      stats(counts),
      library(by.engine ? nullptr : &own),
      engine(by.engine ? *by.engine : own) {}

Scene Seen::scene() const {
  if (library != nullptr || !engine.can().regions) return model().scene(trace.preserve);
  Trace played{trace.preserve, {}};
  for (const BrushEdit& stroke : strokes) played.calls.push_back(Call::byBrush(stroke));
  return sceneOf(played);
}

Mismatch Seen::mismatch(Mismatch::Kind kind, std::string text, Outline marked) const {
  if (!text.ends_with('\n')) text += '\n';
  const Outline outline = engine.outline();
  return {kind,
          std::move(text),
          edits,
          commits,
          scene(),
          outline,
          outline,
          {edited.begin(), edited.end()},
          std::move(marked),
          engine.can()};
}

std::string Seen::told() const {
  const Delta* const delta = engine.delta();
  if (delta == nullptr) return "";
  constexpr std::size_t kMost = 10;
  const SegmentChanges& changes = delta->changes();
  std::string text = "in this commit the engine reported " +
                     (changes.empty() ? std::string("nothing\n") : counted(changes.size(), "change") + ":\n");
  for (std::size_t k = 0; k < std::min(kMost, changes.size()); ++k) {
    const auto& [sign, id, segment] = changes[k];
    text += fmt::format("  {} {}", sign, shortened(id));
    text += sign == '-' ? "\n" : fmt::format(": {}\n", inWords(segment.start, segment.end));
  }
  return changes.size() > kMost ? text + fmt::format("  ... and {} more\n", changes.size() - kMost) : text;
}

Mismatch Seen::noAnswer(const Failure& failure) {
  constexpr std::array kKinds{Mismatch::Kind::crash, Mismatch::Kind::hang, Mismatch::Kind::protocol};
  const std::string text = inWords(failure, fmt::format(" after edit {}", edits));
  Mismatch found = mismatch(kKinds[static_cast<std::size_t>(failure.kind)], text);
  found.expected = found.actual = comparable(naive(scene()).outline, engine.can());
  return found;
}

Found Seen::differing(Mismatch::Kind kind, const Scene& scene, const Outline& expected, const Outline& actual,
                      const Capabilities& can) const {
  stats.segments += expected.size();
  if (expected == actual) return std::nullopt;
  Mismatch found = mismatch(kind, "");
  found.expected = comparable(expected, can);
  found.actual = comparable(actual, can);
  found.can = can;
  if (found.expected == found.actual) return std::nullopt;
  found.text = describe(compare(found.expected, found.actual)) + told();
  found.scene = scene;
  return found;
}

}  // namespace lgs::oracle
