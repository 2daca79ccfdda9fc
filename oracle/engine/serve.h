// The other side of the protocol (process_engine.h): an engine of this process answers in a process of its own, so that
// it may crash and hang there.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/engine/guard.h"

#include <cstdio>
#include <memory>

namespace lgs::oracle {

/// Answers what is asked, until the input ends. It does not judge what it is asked: the harness does the asking.
void serve(Engine& engine, std::FILE* input, std::FILE* output) noexcept;

/// A program that serves on its standard files. What the engine itself prints there goes to its log.
Guard::Program serving(std::shared_ptr<Engine> engine);

}  // namespace lgs::oracle
