// Polygons and coordinates as arguments of laws.
#pragma once

#include "oracle/reference/validity.h"
#include "proptests/support/arbitrary.h"

#include <iosfwd>

namespace lgs::test {

/// A good polygon: of a degenerate shape, or what random edits leave.
struct AnyPolygon {
  oracle::LocalPolygon vertices;
  static rc::Gen<AnyPolygon> arbitrary();
};
void showValue(const AnyPolygon& polygon, std::ostream& out);

/// A coordinate in cells that rounds to a lattice point of the cell, often one where rounding is easily wrong.
template <class Real>
struct AnyReal {
  Real value;
  static rc::Gen<AnyReal> arbitrary();
};
template <>
rc::Gen<AnyReal<float>> AnyReal<float>::arbitrary();
template <>
rc::Gen<AnyReal<double>> AnyReal<double>::arbitrary();
void showValue(const AnyReal<float>& real, std::ostream& out);
void showValue(const AnyReal<double>& real, std::ostream& out);

}  // namespace lgs::test
