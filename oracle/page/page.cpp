#include "oracle/page/page.h"

#include "oracle/draw/svg.h"
#include "oracle/page/story.h"
#include "oracle/page/template.h"

#include <algorithm>

namespace lgs::oracle {
namespace {

using paging::Json;

// What is no UTF-8 becomes a sign that says so.
std::string dumped(const Json& data) { return data.dump(-1, ' ', false, Json::error_handler_t::replace); }

// JSON that stands in a script element: nothing in it may end the element, or begin a comment.
std::string inScript(const Json& data) {
  std::string out;
  for (const char c : dumped(data))
    out += c == '<' ? "\\u003c" : std::string(1, c);  // outside of strings JSON has none
  return out;
}

}  // namespace

std::string readable(std::string_view any) {
  auto text = Json::parse(dumped(any)).get<std::string>();
  std::ranges::replace_if(
      text, [](unsigned char c) { return (c < 0x20 && c != '\n') || c == 0x7f; }, ' ');
  return text;
}

// Lines stay lines.
std::string inElement(std::string_view any) {
  const std::string text = readable(any);
  std::string out;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find('\n', begin);
    out += drawing::escape(std::string_view(text).substr(begin, end - begin));
    if (end == std::string::npos) return out;
    out += '\n';
    begin = end + 1;
  }
}

std::string writePage(const Trace& trace, const PageOptions& options) {
  std::string page;
  const std::string_view all = paging::kTemplate;
  std::size_t done = 0;
  // What is put in is not looked through for places again.
  const auto fill = [&](std::string_view place, const std::string& text) {
    const std::size_t at = all.find(place);
    page.append(all.substr(done, at - done)).append(text);
    done = at + place.size();
  };
  fill("{{title}}", inElement(options.title));
  fill("{{report}}", inElement(options.report));
  fill("{{data}}", inScript(paging::storyOf(trace, options)));
  return page.append(all.substr(done));
}

}  // namespace lgs::oracle
