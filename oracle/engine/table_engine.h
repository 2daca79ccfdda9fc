// An engine that is a table of functions (lgs/lgs_engine.h): linked in, or loaded from a shared object.
#pragma once

#include "oracle/engine/engine.h"

#include <lgs/lgs_engine.h>
#include <cstdint>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace lgs::oracle {

class TableEngine : public Engine {
 public:
  /// Makes an engine of a table; or says what is wrong with the table.
  static tl::expected<std::unique_ptr<TableEngine>, std::string> make(const lgs_engine_table* table);

  /// Loads a shared object, which then stays loaded.
  static tl::expected<std::unique_ptr<TableEngine>, std::string> load(const std::string& file);

  ~TableEngine() override { restart(); }
  TableEngine(const TableEngine&) = delete;
  TableEngine& operator=(const TableEngine&) = delete;

  void reset(const PreservePairs& preserve) override;
  void add(const std::string& name, const ScenePolygon& polygon) override;
  void remove(const std::string& name) override;
  Refusals commit() override;
  Outline outline() const override { return can().delta ? delta_.outline() : outline_; }
  const Delta* delta() const override { return can().delta ? &delta_ : nullptr; }
  void restart() override;

 private:
  explicit TableEngine(const lgs_engine_table* table) : table_(table) {}

  const lgs_engine_table* table_;
  void* self_ = nullptr;          // null: to be made by the next reset()
  std::vector<std::int32_t> xy_;  // of the polygon that is being added
  Outline outline_;
  Delta delta_;
};

}  // namespace lgs::oracle
