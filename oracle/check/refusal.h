// Whether a step is answered as it must be: accepted or refused, and for the right reason, with what is to blame named.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/trace/model.h"
#include "oracle/trace/step.h"
#include "oracle/trace/trace.h"

#include <lgs/world.h>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

/// "fill of 'p1' to 'p6'".
std::string inWords(const Step& step);

/// What is wrong with a player's answer to a step; empty if nothing is. `model` is as after the step.
std::string wrongAnswer(const Step& step, const tl::expected<void, TraceError>& done, const Model& model,
                        const World& world);

/// What is wrong with the refusals that an engine answers a commit with; empty if nothing is. Both are in the order of
/// the edits; the reasons are not compared.
std::string wrongRefusals(const std::vector<RefusedEdit>& expected, const std::vector<RefusedEdit>& actual);

}  // namespace lgs::oracle
