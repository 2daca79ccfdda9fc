#include "oracle/draw/svg.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <utility>

namespace lgs::oracle::drawing {

double length(Vec v) { return std::hypot(v.x, v.y); }

Vec unit(Vec v) {
  const double l = length(v);
  return l > 0 ? v * (1 / l) : Vec{};
}

std::string number(double value) {
  const double rounded = std::round(value * 100) / 100;
  return fmt::format("{}", rounded == 0 ? 0 : rounded);  // not -0
}

std::string escape(std::string_view text) {
  constexpr std::string_view kSpecial = "&<>\"";
  constexpr std::array kEntities{"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string out;
  for (const char c : text) {
    const std::size_t k = kSpecial.find(c);
    if (k != std::string_view::npos)
      out += kEntities[k];
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

Path& Path::command(char letter, Vec p) {
  data_ += letter;
  data_ += number(p.x);
  data_ += ' ';
  data_ += number(p.y);
  return *this;
}

Path& Path::rect(Vec corner, double width, double height) {
  moveTo(corner);
  data_ += "h" + number(width) + "v" + number(height) + "h" + number(-width) + "z";
  return *this;
}

Path& Path::circle(Vec centre, double radius) {
  moveTo({centre.x - radius, centre.y});
  arcTo({centre.x + radius, centre.y}, radius, false, true);
  return arcTo({centre.x - radius, centre.y}, radius, false, true).close();
}

Path& Path::arcTo(Vec end, double radius, bool large, bool clockwise) {
  data_ += "A" + number(radius) + " " + number(radius) + " 0 " + (large ? "1 " : "0 ") + (clockwise ? "1 " : "0 ");
  data_ += number(end.x) + " " + number(end.y);
  return *this;
}

Path& Path::close() {
  data_ += 'z';
  return *this;
}

Svg::Svg(double width, double height, std::string_view title, std::string_view description,
         std::string_view background) {
  width = std::ceil(width);
  height = std::ceil(height);
  open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
               {"width", width},
               {"height", height},
               {"viewBox", "0 0 " + number(width) + " " + number(height)},
               {"role", "img"},
               {"font-family", "system-ui, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', sans-serif"}});
  element("title", title);
  element("desc", description);
  leaf("rect", {{"width", width}, {"height", height}, {"fill", background}});
}

void Svg::start(std::string_view tag, Attributes attributes) {
  out_ += '<';
  out_ += tag;
  addAttributes(attributes);
}

void Svg::addAttributes(Attributes attributes) {
  for (const Attribute& a : attributes) {
    out_ += ' ';
    out_ += a.name;
    out_ += "=\"" + escape(a.value) + '"';
  }
}

void Svg::element(std::string_view tag, std::string_view content) {
  out_ += '<';
  out_ += tag;
  out_ += '>' + escape(content) + "</";
  out_ += tag;
  out_ += ">\n";
}

void Svg::open(std::string_view tag, Attributes attributes) {
  start(tag, attributes);
  out_ += ">\n";
  open_.emplace_back(tag);
}

void Svg::close() {
  out_ += "</" + open_.back() + ">\n";
  open_.pop_back();
}

void Svg::leaf(std::string_view tag, Attributes attributes) {
  start(tag, attributes);
  out_ += "/>\n";
}

void Svg::path(const Path& path, Attributes attributes) {
  if (path.empty()) return;
  out_ += "<path d=\"" + path.data() + '"';
  addAttributes(attributes);
  out_ += "/>\n";
}

void Svg::text(Vec at, std::string_view content, Attributes attributes) {
  start("text", attributes);
  out_ += " x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\">" + escape(content) + "</text>\n";
}

void Svg::tooltip(const Path& path, std::string_view content) {
  out_ += "<path d=\"" + path.data() + "\"><title>" + escape(content) + "</title></path>\n";
}

std::string Svg::finish() && {
  while (!open_.empty()) close();
  return std::move(out_);
}

}  // namespace lgs::oracle::drawing
