// Whether a step is answered as it must be: accepted or refused, and for the right reason, with what is to blame named.
#pragma once

#include "oracle/trace/model.h"
#include "oracle/trace/step.h"
#include "oracle/trace/trace.h"

#include <lgs/world.h>
#include <string>
#include <tl/expected.hpp>

namespace lgs::oracle {

/// "fill of 'p1' to 'p6'".
std::string inWords(const Step& step);

/// What is wrong with a player's answer to a step; empty if nothing is. `model` is as after the step.
std::string wrongAnswer(const Step& step, const tl::expected<void, TraceError>& done, const Model& model,
                        const World& world);

}  // namespace lgs::oracle
