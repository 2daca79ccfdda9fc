// The XML files of a map as Tiled would save them in JSON.
#pragma once

#include <lgs/tiled/import.h>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace lgs::tiled {

/// One file; nothing if it says what JSON can not say, or is damaged.
std::optional<std::string> asJson(const std::string& xml);

/// Each file for which `chosen` says so, under its old name; nothing if one of them has no form in JSON.
std::optional<std::map<std::string, std::string>> asJson(const std::map<std::string, std::string>& files,
                                                         const std::function<bool(const std::string&)>& chosen);

/// Expects two imports to be alike: placement by placement, and in their reports.
void expectAlike(const ImportedMap& a, const ImportedMap& b);

}  // namespace lgs::tiled
