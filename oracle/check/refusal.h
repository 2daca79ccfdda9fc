// Whether an engine refuses what it must refuse.
#pragma once

#include "oracle/engine/engine.h"

#include <string>
#include <vector>

namespace lgs::oracle {

/// What is wrong with the refusals that an engine answers a commit with; empty if nothing is. Both are in the order of
/// the edits; the reasons are not compared.
std::string wrongRefusals(const std::vector<RefusedEdit>& expected, const std::vector<RefusedEdit>& actual);

}  // namespace lgs::oracle
