// The references as an engine: it gives the answers that the laws demand. Nothing of this library's engine is in it.
#pragma once

#include "oracle/engine/engine.h"
#include "oracle/reference/naive.h"
#include "oracle/trace/model.h"

#include <optional>
#include <string>
#include <vector>

namespace lgs::oracle {

/// The model refuses. The naive reference or CGAL's union gives the outline. With both, the naive reference gives it,
/// and a commit fails if CGAL's is another one. CGAL alone knows no preserve relation.
class ReferenceEngine : public Engine {
 public:
  ReferenceEngine(bool naive, bool cgal);

  void reset(const PreservePairs& preserve) override;
  void add(const std::string& name, const ScenePolygon& polygon) override;
  void remove(const std::string& name) override;

  /// A reason is the short name of an ErrorCode, or "name in use", or "unknown name".
  Refusals commit() override;

  Outline outline() const override { return outline_; }

 private:
  bool accepts(const Call& edit);
  std::optional<Failure> unite();

  bool isNaive_;
  bool isCgal_;
  Model model_;
  PreservePairs preserve_;
  NaiveReference naive_;
  Outline outline_;                   // of the last commit
  std::vector<RefusedEdit> refused_;  // since then
};

}  // namespace lgs::oracle
