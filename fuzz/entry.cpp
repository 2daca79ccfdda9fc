// The entry points of libFuzzer, and of all that speak its language: AFL++, Honggfuzz, ClusterFuzz. One program a
// target.
//   LGS_FUZZ_OUT     folder for a finding's trace, picture and input; default: where the program runs
//   LGS_FUZZ_SHRINK  seconds to spend on shrinking; default 10
#include "fuzz/finding.h"
#include "fuzz/mutate.h"
#include "oracle/check/shell.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

// libFuzzer's own mutations; not there under other engines.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t maxSize);

namespace {

const lgs::fuzz::Target& kTarget = lgs::fuzz::LGS_FUZZ_TARGET;

std::string program;  // as a shell takes it

std::string environment(const char* name, const char* fallback) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : fallback;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** argv) {
  program = lgs::oracle::thisProgram((*argv)[0]);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lgs::oracle::CheckStats stats;
  const lgs::fuzz::Bytes input(data, size);
  if (const auto finding = kTarget.check(input, stats)) {
    const auto seconds = std::strtoll(environment("LGS_FUZZ_SHRINK", "10").c_str(), nullptr, 10);
    lgs::fuzz::report(kTarget, input, *finding,
                      {environment("LGS_FUZZ_OUT", "."), std::chrono::seconds(seconds), program});
    std::fflush(nullptr);  // which std::abort() does not
    std::abort();          // the engine saves the input
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  lgs::oracle::Random random(seed);
  const bool hasOwn = LLVMFuzzerMutate != nullptr;
  if (hasOwn && random.chance(kTarget.words.empty() ? 25 : 60)) {
    return LLVMFuzzerMutate(data, size, maxSize);
  }
  lgs::fuzz::Buffer input(data, data + size);
  lgs::fuzz::mutate(kTarget, input, maxSize, random);
  std::copy(input.begin(), input.end(), data);
  return input.size();
}
