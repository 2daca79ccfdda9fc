// Polygons and coordinates as arguments of laws.
#pragma once

#include "oracle/reference/validity.h"

#include <rapidcheck.h>

#include <iosfwd>
#include <vector>

namespace lgs::test {

/// A good polygon: of a degenerate shape, or what random edits leave.
struct AnyPolygon {
  oracle::LocalPolygon vertices;
};
void showValue(const AnyPolygon& polygon, std::ostream& out);

/// A coordinate in cells that rounds to a lattice point of the cell, often one where rounding is easily wrong.
template <class Real>
struct AnyReal {
  Real value;
};
void showValue(const AnyReal<float>& real, std::ostream& out);
void showValue(const AnyReal<double>& real, std::ostream& out);

}  // namespace lgs::test

namespace rc {

template <>
struct Arbitrary<lgs::test::AnyPolygon> {
  static Gen<lgs::test::AnyPolygon> arbitrary();
};
template <>
struct Arbitrary<lgs::test::AnyReal<float>> {
  static Gen<lgs::test::AnyReal<float>> arbitrary();
};
template <>
struct Arbitrary<lgs::test::AnyReal<double>> {
  static Gen<lgs::test::AnyReal<double>> arbitrary();
};

}  // namespace rc
