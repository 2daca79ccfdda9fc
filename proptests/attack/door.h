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
#include <type_traits>
#include <utility>

namespace lgs::test {

/// Which value each argument gets, modulo how many there are. 0 is the plain one.
using Picks = std::array<std::uint32_t, 8>;

struct Door {
  std::string name;
  std::vector<std::function<std::size_t(Scene&)>> counts;  ///< of the values of each argument
  std::function<bool(Scene&, const Picks&)> isRefused;     ///< makes the call
  std::function<std::string(Scene&, const Picks&)> told;   ///< its arguments in words
  /// Whether the documents say that it is refused, where they are simple enough to be asked.
  std::function<bool(Scene&, const Picks&)> mustBeRefused;
};

/// All of them, by library.
const std::vector<Door>& doors();

class Doors {
 public:
  template <class Call>
  void operator()(const char* name, Call call) {
    add(name, std::function{call});
  }
  template <class Call, class Says>
  void operator()(const char* name, Call call, Says says) {
    add(name, std::function{call});
    all.back().mustBeRefused = drawn(std::function{says});
  }

  std::vector<Door> all;

 private:
  template <class T>
  static std::conditional_t<std::is_same_v<T, bool>, bool, const std::decay_t<T>&> pick(Scene& scene,
                                                                                        std::uint32_t number) {
    const auto& values = Hostile<std::decay_t<T>>::values(scene);
    return values[number % values.size()];
  }

  template <class... Args>
  static std::function<bool(Scene&, const Picks&)> drawn(std::function<bool(Scene&, Args...)> function) {
    return [function = std::move(function)](Scene& scene, const Picks& picks) {
      return [&]<std::size_t... I>(std::index_sequence<I...>) {
        return function(scene, pick<Args>(scene, picks[I])...);
      }
      (std::index_sequence_for<Args...>());
    };
  }

  template <class Result, class... Args>
  void add(const char* name, std::function<Result(Scene&, Args...)> call) {
    static_assert(sizeof...(Args) <= std::tuple_size_v<Picks>);
    Door door{name, {}, {}, {}, {}};
    (door.counts.emplace_back([](Scene& scene) { return Hostile<std::decay_t<Args>>::values(scene).size(); }), ...);
    door.isRefused = drawn(std::function<bool(Scene&, Args...)>([call = std::move(call)](Scene& scene, Args... args) {
      if constexpr (std::is_same_v<Result, lgs_status>) {
        return call(scene, args...) != LGS_OK;
      } else if constexpr (requires(Result * r) {
                             r->has_value();
                             r->error();
                           }) {
        return !call(scene, args...).has_value();
      } else {
        static_cast<void>(call(scene, args...));
        return false;
      }
    }));
    door.told = [](Scene& scene, const Picks& picks) {
      return [&]<std::size_t... I>(std::index_sequence<I...>) {
        std::string text;
        ((text += (I == 0 ? "" : ", ") + Hostile<std::decay_t<Args>>::told(pick<Args>(scene, picks[I]))), ...);
        return text;
      }
      (std::index_sequence_for<Args...>());
    };
    all.push_back(std::move(door));
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
