// A body as C sees it.
#pragma once

#include "inside.h"

#include <lgs/body.h>
#include <lgs/lgs_views.h>

struct lgs_body {
  explicit lgs_body(lgs::Body b) : body(std::move(b)) {
    for (const lgs::BodyPolygon& p : body.polygons) {
      firsts.push_back(vertices.size());
      for (const lgs::LocalPoint v : p.vertices) vertices.push_back(lgs::c::toC(v));
    }
  }
  lgs::Body body;
  std::vector<std::size_t> firsts;        ///< of each polygon: where its vertices begin
  std::vector<lgs_local_point> vertices;  ///< of all polygons, one after the other
};
