#include "oracle/engine/play.h"

namespace lgs::oracle {

tl::expected<Outline, Failure> play(const Trace& trace, Engine& engine) {
  engine.reset(trace.preserve);
  for (const Call& edit : trace.calls) {
    if (edit.kind == Call::Kind::add) {
      engine.add(edit.name(), edit.polygon());
    } else if (edit.kind == Call::Kind::remove) {
      engine.remove(edit.name());
    } else if (edit.kind == Call::Kind::brush) {
      engine.stroke(edit.brush);
    } else if (const auto done = engine.commit(); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (const auto done = engine.commit(); !done) return tl::unexpected(done.error());
  return engine.outline();
}

}  // namespace lgs::oracle
