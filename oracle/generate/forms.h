// Which calls make some edits: the engine has many that mean the same.
#pragma once

#include "oracle/calls/random.h"
#include "oracle/trace/model.h"

#include <functional>
#include <span>

namespace lgs::oracle {

/// Makes adds, removes and commits in the model, by calls that come to the same, and puts these out. Of calls that take
/// many some try in vain what one of the edits may not do: then these come one by one. Where nothing is left to chance
/// the edits stay as they are.
void makeInForms(std::span<const Call> edits, Model& model, Random& random, const std::function<void(Call)>& put);

/// A call whose polygons no text can name, by where these stand.
Call withoutFreshNames(Call call, const Model& model);

}  // namespace lgs::oracle
