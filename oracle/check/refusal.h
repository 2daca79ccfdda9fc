// Whether a refusal gives the right reason, and names what is to blame.
#pragma once

#include "oracle/trace/model.h"
#include "oracle/trace/step.h"

#include <lgs/world.h>
#include <string>

namespace lgs::oracle {

/// What is wrong with the refusal of a step that must be refused; empty if nothing is.
std::string wrongRefusal(const Error& error, const Step& step, const Model& model, const World& world);

}  // namespace lgs::oracle
