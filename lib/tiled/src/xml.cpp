#include "xml.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

namespace lgs::tiled {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> parseReal(std::string_view text) {
  const auto value = parseNumber<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A piece of the file as a message quotes it: short, and without control characters.
std::string quoted(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string result(text.substr(0, kMost));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  return "'" + result + (text.size() > kMost ? "…'" : "'");
}

std::string describe(pugi::xml_node node) {
  if (!node) return {};
  std::string result = "<" + std::string(node.name()) + ">";
  for (const char* attribute : {"name", "id", "source"}) {
    if (const auto value = node.attribute(attribute)) return result + " " + quoted(value.value());
  }
  return result;
}

}  // namespace

XmlFile::XmlFile(std::string name, const FileReader& reader, const char* rootName, std::optional<ImportError>& error)
    : name_(std::move(name)), error_(error) {
  if (!failed()) parse(reader, rootName);
}

void XmlFile::parse(const FileReader& reader, const char* rootName) {
  auto text = reader(name_);
  if (!text) {
    error_ = ImportError{name_, 0, "", "cannot be read: " + text.error()};
    return;
  }
  text_ = std::move(*text);
  lineStarts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') lineStarts_.push_back(i + 1);
  }
  const auto result = document_.load_buffer(text_.data(), text_.size());
  if (!result) {
    const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), static_cast<std::size_t>(result.offset));
    error_ = ImportError{name_, static_cast<int>(next - lineStarts_.begin()), "",
                         std::string("is not well-formed XML: ") + result.description()};
  } else if (std::string_view(root().name()) != rootName) {
    fail(root(), std::string("should be <") + rootName + ">: this is not the kind of file expected here");
  }
}

int XmlFile::line(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset < 0) return 0;
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), static_cast<std::size_t>(offset));
  return static_cast<int>(next - lineStarts_.begin());
}

std::string XmlFile::pathTo(std::string named) const {
  std::replace(named.begin(), named.end(), '\\', '/');
  return (std::filesystem::path(name_).parent_path() / named).lexically_normal().generic_string();
}

void XmlFile::fail(pugi::xml_node node, std::string what) const {
  if (!failed()) error_ = ImportError{name_, line(node), describe(node), std::move(what)};
}

std::int64_t XmlFile::integer(pugi::xml_node node, const char* attribute, std::optional<std::int64_t> fallback,
                              std::int64_t min, std::int64_t max) const {
  const auto found = node.attribute(attribute);
  if (!found) {
    if (!fallback) fail(node, std::string("has no attribute '") + attribute + "'");
    return fallback.value_or(min);
  }
  const auto value = parseNumber<std::int64_t>(found.value());
  if (value && *value >= min && *value <= max) return *value;
  fail(node, std::string(attribute) + "=" + quoted(found.value()) + " should be a whole number from " +
                 std::to_string(min) + " to " + std::to_string(max));
  return fallback.value_or(min);
}

double XmlFile::real(pugi::xml_node node, const char* attribute) const {
  const auto found = node.attribute(attribute);
  if (!found) return 0;
  const auto value = parseReal(found.value());
  if (!value) fail(node, std::string(attribute) + "=" + quoted(found.value()) + " should be a finite number");
  return value.value_or(0);
}

std::vector<DoublePoint> XmlFile::points(pugi::xml_node node, const char* attribute) const {
  std::vector<DoublePoint> result;
  const std::string_view all = node.attribute(attribute).value();
  std::string_view rest = trimmed(all);
  while (!rest.empty()) {
    const auto blank = std::min(rest.find_first_of(" \t\r\n"), rest.size());
    const std::string_view pair = rest.substr(0, blank);
    const auto comma = std::min(pair.find(','), pair.size());
    const auto x = parseReal(pair.substr(0, comma));
    const auto y = comma < pair.size() ? parseReal(pair.substr(comma + 1)) : std::nullopt;
    if (!x || !y) {
      fail(node, std::string(attribute) + ": " + quoted(pair) + " should be two finite numbers 'x,y'");
      return {};
    }
    result.push_back({*x, *y});
    rest = trimmed(rest.substr(blank));
  }
  return result;
}

std::string classOf(pugi::xml_node node) {
  const auto found = node.attribute("class");
  return found ? found.value() : node.attribute("type").value();
}

}  // namespace lgs::tiled
