#include "xml.h"

#include "json.h"
#include "text/words.h"
#include "words.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

namespace lgs::tiled {
namespace {

/// What std::from_chars() takes: no blanks around it, and no plus.
std::string_view bare(std::string_view number) {
  number = trimmed(number);
  return number.starts_with('+') ? number.substr(1) : number;
}

std::string describe(pugi::xml_node node, bool mayQuote) {
  if (!node) return {};
  const std::string_view path = node.attribute(kPathAttribute).value();  // it comes from JSON
  std::string result = path.empty() ? "<" + std::string(node.name()) + ">" : std::string(path);
  for (const char* attribute : {"name", "id", "source"}) {
    if (!mayQuote) break;
    const auto value = node.attribute(attribute);
    if (value && !(*value.value() == '\0' && !path.empty())) return result + " " + inQuotes(value.value());
  }
  return result;
}

/// Why a file is not read that a map names, which may come from a stranger; or nothing.
std::string whyNotToRead(std::string named, std::string_view kind) {
  std::replace(named.begin(), named.end(), '\\', '/');
  const std::filesystem::path path(named);
  if (path.has_root_directory() || path.has_root_name())
    return "its path is absolute. If the map can be trusted, files may lie anywhere: Options::filesAnywhere";
  if (kind == "map" && path.parent_path().empty()) return {};  // as all maps of a world mostly lie: in its folder
  const std::string ofXml = kind == "tileset" ? ".tsx" : kind == "template" ? ".tx" : ".tmx";
  const std::string ofJson = ofXml.substr(0, ofXml.size() - 1) + "j";
  if (isOneOf(lower(path.extension().string()), {ofXml, ofJson, ".json", ".xml"})) return {};
  return concat("it has not the extension of a ", kind, ", such as ", ofXml,
                ". If the map can be trusted: Options::filesAnywhere");
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts{text.substr(0, text.find_first_of(separators))};
  for (std::size_t at = parts[0].size(); at < text.size(); at += parts.back().size() + 1)
    parts.push_back(text.substr(at + 1, text.find_first_of(separators, at + 1) - at - 1));
  return parts;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
  text = bare(text);
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// By fast_float, since std::from_chars() of LLVM's library reads no reals. A number too small for a double is 0.
std::optional<double> parseReal(std::string_view text) {
  text = bare(text);
  double value = 0;
  const auto [end, status] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc::invalid_argument || end != text.data() + text.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

XmlFile::XmlFile(std::string name, const FileReader& reader, std::optional<ImportError>& error, bool isTrusted)
    : name_(std::move(name)), isTrusted_(isTrusted), reader_(reader), error_(error) {
  read("map", "");
}

XmlFile::XmlFile(const XmlFile& by, const std::string& named, const char* rootName, std::optional<ImportError>& error)
    : name_(by.pathTo(named)), isTrusted_(by.isTrusted_), mayQuote_(by.isTrusted_), reader_(by.reader_), error_(error) {
  read(rootName, isTrusted_ ? "" : whyNotToRead(named, rootName));
}

/// A refusal says why it is not read.
void XmlFile::read(const char* rootName, const std::string& refusal) {
  if (failed()) return;
  auto text = refusal.empty() ? reader_(name_) : tl::unexpected(refusal);
  wasRead_ = text.has_value();
  if (wasRead_) {
    text_ = std::move(*text);
    parse();
    if (!failed()) expectRoot(rootName);
  } else {
    isMissing_ = text.error().starts_with(kNoSuchFile);
    isRefused_ = !refusal.empty() || text.error().starts_with(kNotInFolder);
    error_ = ImportError{name_, 0, "", "cannot be read: " + text.error()};
  }
}

void XmlFile::parse() {
  if (text_.empty()) return fail({}, isForeign("empty"));
  const std::string other = foreign(Sign::text, [&](auto sign) { return text_.starts_with(sign); });
  if (!other.empty()) return fail({}, other);
  const std::string_view start =
      trimmed(std::string_view(text_).substr(text_.starts_with("\xEF\xBB\xBF") ? 3 : 0, 256));
  if (start.starts_with('{') || start.starts_with('[')) return readJson(*this, text_, document_);
  const auto result = document_.load_buffer(text_.data(), text_.size());
  if (result.encoding != pugi::encoding_utf8) text_.clear();  // places are those of the UTF-8 that it became
  if (result.status == pugi::status_no_document_element) return fail({}, isForeign("neither XML nor JSON"));
  if (!result)
    error_ = ImportError{name_, lineAt(result.offset), "", concat("is not well-formed XML: ", result.description())};
}

/// Nothing of Tiled's is nearer to a map than a world, which names maps.
void XmlFile::expectRoot(std::string_view rootName) const {
  const std::string_view found = root().name();
  if (found == rootName) return;
  if (rootName == "map" && found == "world" && root().attribute(kPathAttribute)) return;  // there are none in XML
  const std::string other = foreign(Sign::xml, [&](auto sign) { return found == sign; });
  if (!other.empty()) return fail(root(), other);
  const std::string should = concat("should be <", rootName, ">: this is not the kind of file expected here");
  if (mayQuote_) return fail(root(), should);
  fail({}, "its root " + should);
}

std::string XmlFile::quoted(const char* before, std::string_view text) const {
  return mayQuote_ ? before + inQuotes(text) : "";
}

std::string XmlFile::takeReason(const char* kind) const {
  if (!failed() || wasRead_) return {};
  std::string why = concat("the ", kind, "'s file ", error_->file, " ", error_->what);
  error_.reset();
  return why;
}

int XmlFile::line(pugi::xml_node node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  return offset < 0 ? 0 : lineAt(offset);
}

int XmlFile::lineAt(std::ptrdiff_t offset) const {
  if (text_.empty()) return 0;
  return static_cast<int>(1 + std::count(text_.begin(), text_.begin() + offset, '\n'));
}

void XmlFile::fail(pugi::xml_node node, std::string what, std::string option) const {
  if (!failed()) error_ = ImportError{name_, line(node), describe(node, mayQuote_), std::move(what), std::move(option)};
}

std::int64_t XmlFile::integer(pugi::xml_node node, const char* attribute, std::optional<std::int64_t> fallback,
                              std::int64_t min, std::int64_t max) const {
  const auto found = node.attribute(attribute);
  if (!found) {
    if (!fallback) fail(node, std::string("has no attribute '") + attribute + "'");
    return fallback.value_or(min);
  }
  const auto value = parseInteger(found.value());
  if (value && *value >= min && *value <= max) return *value;
  fail(node, concat(attribute, quoted("=", found.value()), " should be a whole number from ", min, " to ", max));
  return fallback.value_or(min);
}

double XmlFile::real(pugi::xml_node node, const char* attribute) const {
  const auto found = node.attribute(attribute);
  if (!found) return 0;
  const auto value = parseReal(found.value());
  if (!value) fail(node, attribute + quoted("=", found.value()) + " should be a finite number");
  return value.value_or(0);
}

std::vector<DoublePoint> XmlFile::points(pugi::xml_node node, const char* attribute) const {
  std::vector<DoublePoint> result;
  for (const std::string_view pair : split(node.attribute(attribute).value(), " \t\r\n")) {
    if (pair.empty()) continue;
    const std::size_t comma = std::min(pair.find(','), pair.size() - 1);
    const auto x = parseReal(pair.substr(0, comma)), y = parseReal(pair.substr(comma + 1));
    if (!x || !y) {
      fail(node, attribute + quoted(": ", pair) + " should be two finite numbers 'x,y'");
      return {};
    }
    result.push_back({*x, *y});
  }
  return result;
}

std::string inQuotes(std::string_view piece) {
  constexpr std::size_t kMost = 40;
  return "'" + text::withoutControls(piece.substr(0, kMost)) + (piece.size() > kMost ? "…'" : "'");
}

std::string pathBeside(const std::string& file, std::string named) {
  std::replace(named.begin(), named.end(), '\\', '/');
  return (std::filesystem::path(file).parent_path() / named).lexically_normal().generic_string();
}

namespace fs = std::filesystem;

std::string folderOf(const std::string& file) { return fs::path(file).parent_path().generic_string(); }

bool liesBelow(const std::string& folder, const std::string& path) {
  const fs::path root = fs::path(folder).lexically_normal(), to = fs::path(path).lexically_normal();
  const auto isUp = [](const fs::path& step) { return step == ".."; };
  const auto ups = [&](const fs::path& p) { return std::find_if_not(p.begin(), p.end(), isUp); };
  if (root == "." || ups(root) == root.end()) {  // "", ".", "..", "../..": what goes no further up lies below it
    const auto up = root == "." ? 0 : std::distance(root.begin(), root.end());
    const auto its = std::distance(to.begin(), ups(to)), steps = std::distance(to.begin(), to.end());
    return !to.has_root_name() && !to.has_root_directory() && steps > its && to != "." && its <= up;
  }
  const fs::path from = to.lexically_relative(root);
  return !from.empty() && from != "." && !isUp(*from.begin());
}

std::string withoutSlash(const fs::path& folder) {
  const fs::path plain = folder.lexically_normal();
  return plain.empty() ? "." : (plain.has_filename() ? plain : plain.parent_path()).generic_string();
}

std::string folderOfBoth(const std::string& file, const std::string& other) {
  fs::path folder = fs::path(file).parent_path().lexically_normal();
  if (fs::path(other).has_root_directory() != folder.has_root_directory()) return folderOf(other);
  const fs::path in = fs::path(other) / "f";  // it may be the name of a folder, such as ".."
  auto most = std::distance(folder.begin(), folder.end()) + std::distance(in.begin(), in.end());
  for (; most > 0 && !liesBelow(folder.generic_string(), in.generic_string()); --most)
    folder = (folder / "..").lexically_normal();
  return withoutSlash(folder);
}

std::string classOf(pugi::xml_node node) {
  const auto found = node.attribute("class");
  return found ? found.value() : node.attribute("type").value();
}

}  // namespace lgs::tiled
