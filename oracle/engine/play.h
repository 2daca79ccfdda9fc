// Plays a trace into an engine, without judging anything.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/trace/trace.h"

#include <tl/expected.hpp>

namespace lgs::oracle {

/// The engine's outline at the end of a trace. What is pending there is committed.
tl::expected<Outline, Failure> play(const Trace& trace, Engine& engine);

}  // namespace lgs::oracle
