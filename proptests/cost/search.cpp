#include "search.h"

#include "oracle/calls/draw.h"

#include <lgs/tiled/import.h>

namespace lgs::cost_test {

Calls drawCalls(Random& random) {
  Calls calls;
  for (int k = 0; k < 20; ++k) calls.push_back(drawCall(random, oracle::Habits()));
  return calls;
}

void changeCalls(Calls& calls, Random& random) {
  const std::size_t at = random.below(calls.size());
  if (random.chance(30) && calls.size() > 1) calls.erase(calls.begin() + static_cast<std::ptrdiff_t>(at));
  const Calls more = drawCalls(random);
  calls.insert(calls.begin() + static_cast<std::ptrdiff_t>(random.below(calls.size() + 1)), more[0]);
}

World worldOf(const Calls& calls) {
  oracle::Caller caller;
  for (const oracle::Call& call : calls) caller.make(call);
  caller.world.commit();
  return std::move(caller.world);
}

constexpr std::size_t kMaxWork = 1 << 20;

double costOfImport(const std::string& map) {
  tiled::Options options;
  options.maxWork = kMaxWork;
  options.maxObjectCells = 1 << 12;
  const auto reader = [&](const std::string&) -> tl::expected<std::string, std::string> { return map; };
  return static_cast<double>(visitsOf([&] { static_cast<void>(tiled::importMap("a", options, reader)); }));
}

double shareOfLimit(const std::string& map) {
  return costOfImport(map) / static_cast<double>(tiled::kWorkPerByte * map.size() + kMaxWork);
}

}  // namespace lgs::cost_test
