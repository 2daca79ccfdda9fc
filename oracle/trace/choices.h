// What a name decides in the player beside the door, in bits of chanceOf(). All 0 is the plain way. The lower half of
// the bits is that of steps.cpp.
#pragma once

#include "oracle/calls/notation.h"
#include "oracle/trace/step.h"

#include <array>
#include <cstdint>

namespace lgs::oracle {

inline unsigned offset(std::uint64_t chance) { return bitsOf(chance, 32, 2); }
inline unsigned roomForHandles(std::uint64_t chance) { return bitsOf(chance, 34, 2); }
inline Notation notationOf(std::uint64_t chance) {
  constexpr std::array kNotations{Notation::lattice, Notation::list, Notation::floats, Notation::doubles};
  return kNotations[bitsOf(chance, 36, 2)];
}
inline bool wantsOverload(std::uint64_t chance) { return bitsOf(chance, 38, 1) != 0; }
inline unsigned executor(std::uint64_t chance) { return bitsOf(chance, 40, 2); }
inline bool wantsOtherBlock(std::uint64_t chance) { return bitsOf(chance, 42, 3) == 7; }
inline bool wantsGroup(std::uint64_t chance) { return bitsOf(chance, 45, 4) == 15; }
inline bool wantsMark(std::uint64_t chance) { return bitsOf(chance, 45, 4) == 1; }
inline bool wantsSaving(std::uint64_t chance) { return bitsOf(chance, 49, 5) == 31; }
inline bool wantsDetour(std::uint64_t chance) { return bitsOf(chance, 54, 5) == 31; }
inline bool wantsUnloading(std::uint64_t chance) { return bitsOf(chance, 59, 5) == 31; }

}  // namespace lgs::oracle
