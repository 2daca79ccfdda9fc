// The published algorithm as an engine for the harness, like any engine of others.
#pragma once

#include <lgs/lgs_engine.h>

namespace lgs::bench {

/// It can do all but refuse. The article says nothing of bad edits.
const lgs_engine_table* publishedEngine();

}  // namespace lgs::bench
