// What kind of fault of an engine a mismatch shows: for a report that counts them.
#pragma once

#include "oracle/check/checker.h"

#include <string>

namespace lgs::oracle {

/// In a few words: "missing cut", "uncancelled edge", "lost preserve", "wrong link", "stale ghost", "wrong block",
/// "order of edits matters", "other segments", "wrong id", "needless change", "wrong island", "refusal", "crash", "hang" or "protocol". To find out whether the past
/// matters the engine builds the world anew, so whatever it holds is gone.
std::string kindOfFinding(const Mismatch& mismatch, Engine& engine);

}  // namespace lgs::oracle
