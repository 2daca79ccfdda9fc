// A door: a public function, how many hostile values there are for each of its arguments, and how it is called with
// some of them. To add one is one line, in the file of its library:
//
//   door("World::setBlock(PolygonHandle, Block)",
//        [](Scene& s, PolygonHandle h, Block b) { return s.world.setBlock(h, b); });
//
// The name is the one that table.py reads in the header, and the arguments of the function are drawn by their types:
// kinds.h.
#pragma once

#include "kinds.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lgs::test {

/// Which value each argument gets, modulo how many there are. 0 is the plain one.
using Picks = std::array<std::uint32_t, 8>;

/// A type of arguments: how many values it has, and each in words.
struct Kind {
  template <class T>
  static Kind of() {
    return {[](Scene& scene) { return Hostile<T>::values(scene).size(); },
            [](Scene& scene, std::uint32_t number) { return Hostile<T>::told(pick<T>(scene, number)); }};
  }
  template <class T>
  static std::conditional_t<std::is_same_v<T, bool>, bool, const T&> pick(Scene& scene, std::uint32_t number) {
    const auto& values = Hostile<T>::values(scene);
    return values[number % values.size()];
  }

  std::size_t (*count)(Scene&);
  std::string (*told)(Scene&, std::uint32_t number);
};

struct Door {
  std::string name;
  std::vector<Kind> arguments;
  std::function<bool(Scene&, const Picks&)> isRefused;  ///< makes the call
  /// Whether the documents say that it is refused, where they are simple enough to be asked.
  std::function<bool(Scene&, const Picks&)> mustBeRefused;

  std::string told(Scene& scene, const Picks& picks) const {  ///< its arguments in words
    std::string text;
    for (std::size_t k = 0; k < arguments.size(); ++k)
      text += (k == 0 ? "" : ", ") + arguments[k].told(scene, picks[k]);
    return text;
  }
};

/// All of them, by library.
const std::vector<Door>& doors();

class Doors {
 public:
  void operator()(const char* name, auto call) { add(name, +call, {}); }
  void operator()(const char* name, auto call, auto says) { add(name, +call, drawn(+says, std::identity{})); }

  std::vector<Door> all;

 private:
  template <class Result, class... Args>
  void add(const char* name, Result (*call)(Scene&, Args...), std::function<bool(Scene&, const Picks&)> says) {
    static_assert(sizeof...(Args) <= std::tuple_size_v<Picks>);
    all.push_back({name, {Kind::of<std::decay_t<Args>>()...}, drawn(call, IsRefusal{}), std::move(says)});
  }

  struct IsRefusal {
    bool operator()(lgs_status status) const { return status != LGS_OK; }
    bool operator()(const auto& result) const {
      if constexpr (requires {
                      result.has_value();
                      result.error();
                    })
        return !result.has_value();
      else
        return false;
    }
  };

  /// The call with the values that are picked, and what is made of its result.
  template <class Result, class... Args>
  static std::function<bool(Scene&, const Picks&)> drawn(Result (*call)(Scene&, Args...), auto judge) {
    return [=](Scene& scene, const Picks& picks) {
      return [&]<std::size_t... I>(std::index_sequence<I...>) {
        if constexpr (std::is_void_v<Result>) {
          call(scene, Kind::pick<std::decay_t<Args>>(scene, picks[I])...);
          return false;
        } else {
          return judge(call(scene, Kind::pick<std::decay_t<Args>>(scene, picks[I])...));
        }
      }
      (std::index_sequence_for<Args...>());
    };
  }
};

/// A call that the documents refuse, whatever else is so, if `isBad`.
template <class Result>
Result refusedIf(bool isBad, Result result) {
  if (isBad) {
    EXPECT_FALSE(result.has_value());
  }
  return result;
}

void addDoorsOfValues(Doors& door);
void addDoorsOfWorlds(Doors& door);
void addDoorsOfReading(Doors& door);
void addDoorsOfBrushes(Doors& door);
void addDoorsOfC(Doors& door);
void addDoorsOfViews(Doors& door);
void addDoorsOfHashes(Doors& door);
void addDoorsOfViewsInC(Doors& door);
void addDoorsOfBox2d(Doors& door);

}  // namespace lgs::test
