// A small SVG writer: balanced tags, escaped text, short numbers. Coordinates are pixels, y down.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace lgs::oracle::drawing {

struct Vec {
  double x = 0;
  double y = 0;
  friend constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec operator*(Vec a, double k) { return {a.x * k, a.y * k}; }
};

double length(Vec v);
Vec unit(Vec v);  ///< zero stays zero

/// At most two decimals, no trailing zeros: "3", "0.25", "-1.5".
std::string number(double value);

/// Text for an element or an attribute. Control characters become blanks, because XML can not hold them.
std::string escape(std::string_view text);

/// The `d` of a path.
class Path {
 public:
  Path& moveTo(Vec p) { return command('M', p); }
  Path& lineTo(Vec p) { return command('L', p); }
  Path& line(Vec from, Vec to) { return moveTo(from).lineTo(to); }
  Path& rect(Vec corner, double width, double height);
  Path& circle(Vec centre, double radius);
  Path& arcTo(Vec end, double radius, bool large, bool clockwise);  ///< clockwise as seen on the picture
  Path& close();
  bool empty() const { return data_.empty(); }
  const std::string& data() const { return data_; }

 private:
  Path& command(char letter, Vec p);
  std::string data_;
};

struct Attribute {
  Attribute(std::string_view n, std::string_view v) : name(n), value(v) {}
  Attribute(std::string_view n, const char* v) : name(n), value(v) {}
  Attribute(std::string_view n, double v) : name(n), value(number(v)) {}
  std::string_view name;
  std::string value;
};
using Attributes = std::initializer_list<Attribute>;

class Svg {
 public:
  /// A picture with its accessible title and description and an opaque background.
  Svg(double width, double height, std::string_view title, std::string_view description, std::string_view background);

  void open(std::string_view tag, Attributes attributes);
  void close();
  void leaf(std::string_view tag, Attributes attributes);
  void path(const Path& path, Attributes attributes);  ///< writes nothing for an empty path
  void text(Vec at, std::string_view content, Attributes attributes);
  void tooltip(const Path& path, std::string_view content);  ///< a path that shows text when the mouse is on it

  std::string finish() &&;

 private:
  void start(std::string_view tag, Attributes attributes);
  void addAttributes(Attributes attributes);
  void element(std::string_view tag, std::string_view content);

  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace lgs::oracle::drawing
