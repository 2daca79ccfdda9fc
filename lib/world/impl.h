// What a World is made of: the ground, its outline, and how far both can roll back.
#pragma once

#include "ground/edit.h"
#include "ground/ground.h"
#include "outline/outline.h"
#include "world/history.h"

#include <lgs/world.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace lgs {

struct World::Impl {
  explicit Impl(PreserveRelation relation) : ground(std::move(relation)), edit(ground), history(ground, outline) {}
  Impl(const Impl& other)
      : ground(other.ground),
        outline(other.outline),
        edit(ground),
        history(other.history, ground, outline),
        changesOfRollBack(other.changesOfRollBack) {}
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;

  detail::Ground ground;
  detail::Outline outline;
  detail::Edit edit;
  detail::History history;
  Changes changesOfRollBack;
  std::uint64_t commits = 0;        ///< counted in Debug alone
  std::vector<LocalPoint> rounded;  ///< working memory: the polygon that is added
};

}  // namespace lgs
