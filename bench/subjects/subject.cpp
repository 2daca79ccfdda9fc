#include "bench/subjects/subject.h"

#include "bench/subjects/engine.h"
#include "bench/subjects/libraries.h"

#include <algorithm>
#include <functional>

namespace lgs::bench {
namespace {

[[maybe_unused]] Made without(const char* what) { return tl::unexpected(std::string("built without ") + what); }

struct Entry {
  SubjectInfo info;
  std::function<Made()> make;
};

std::vector<Entry>& entries() {
  static std::vector<Entry> all{
      {{"published-port", true}, makePublishedPort},
      {{"published-port-new-sets", true}, makePublishedPortWithNewSets},
      {{"published-arrays", true}, makePublishedArrays},
      {{"engine-polygons", true}, []() -> Made { return std::make_unique<Engine>(Engine::By::polygons); }},
      {{"engine-shapes", true}, []() -> Made { return std::make_unique<Engine>(Engine::By::shapes); }},
      {{"engine-bulk", true}, []() -> Made { return std::make_unique<Engine>(Engine::By::bulk); }},
      {{"engine-fill", true}, []() -> Made { return std::make_unique<Engine>(Engine::By::fill); }},
#ifdef LGS_BENCH_GEOS
      {{"geos-coverage", false}, makeGeosCoverageUnion},
      {{"geos", false}, makeGeosUnaryUnion},
#else
      {{"geos-coverage", false}, [] { return without("GEOS (libgeos-dev)"); }},
      {{"geos", false}, [] { return without("GEOS (libgeos-dev)"); }},
#endif
#ifdef LGS_BENCH_CLIPPER
      {{"clipper", false}, makeClipper},
#else
      {{"clipper", false}, [] { return without("Clipper (libpolyclipping-dev)"); }},
#endif
#ifdef LGS_BENCH_BOOST
      {{"boost", false}, makeBoost},
#else
      {{"boost", false}, [] { return without("Boost.Geometry"); }},
#endif
      {{"cgal", false}, makeCgal},
      {{"polygon-clipping", false}, makePolygonClipping},
  };
  return all;
}

}  // namespace

std::vector<SubjectInfo> subjects() {
  std::vector<SubjectInfo> infos;
  for (const Entry& entry : entries()) infos.push_back(entry.info);
  return infos;
}

void addSubject(std::string_view name, std::function<std::unique_ptr<Subject>()> make) {
  entries().push_back({{name, true, true}, [make = std::move(make)]() -> Made { return make(); }});
}

tl::expected<std::unique_ptr<Subject>, std::string> makeSubject(std::string_view name) {
  const auto& all = entries();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.info.name == name; });
  return found == all.end() ? tl::unexpected(std::string("there is no such subject")) : found->make();
}

}  // namespace lgs::bench
