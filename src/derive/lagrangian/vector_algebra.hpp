// Vectors in three dimensions over definitions: every component of a result is a definition, so
// that no expression is written twice.
#pragma once

#include <array>
#include <string>

#include "derive/formulate/chain_rule.hpp"
#include "derive/formulate/name_scope.hpp"

namespace elgen {

using ExMatrix3 = std::array<GiNaC::ex, 9>;  ///< row-major

/// A cyclic permutation of the three axes.
struct CyclicAxes {
  std::size_t i;
  std::size_t j;
  std::size_t k;
};
inline constexpr std::array<CyclicAxes, 3> cyclic_axes{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};

[[nodiscard]] inline ExMatrix3 transposed(const ExMatrix3& a) {
  return {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
}

class VectorAlgebra {
 public:
  explicit VectorAlgebra(Definitions& definitions) : definitions_(definitions) {}

  [[nodiscard]] GiNaC::ex define(const GiNaC::ex& value) {
    return elgen::define(definitions_, value);
  }

  /// Defines each component and returns the symbols. New definitions are named name_x, name_y,
  /// name_z, unless `name` is empty.
  [[nodiscard]] ExVector3 define(const ExVector3& value, const std::string& name = {},
                                 Entity origin = {}) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    ExVector3 result;
    for (std::size_t i = 0; i < 3; ++i) {
      definitions_.meaning.axis = axes[i];
      const std::string own = name.empty() ? name : name + "_" + axes[i];
      result[i] = elgen::define(definitions_, value[i], {own, origin});
    }
    definitions_.meaning.axis.clear();
    return result;
  }

  [[nodiscard]] NameScope name_scope(const std::string& kind, const std::string& frame = {}) {
    return {definitions_, kind, frame};
  }

  /// dx/ds along the direction `along`.
  [[nodiscard]] ExVector3 rate(const ExVector3& x, Tangent& along) {
    return {define(along(x[0])), define(along(x[1])), define(along(x[2]))};
  }

  [[nodiscard]] ExVector3 add(const ExVector3& a, const ExVector3& b) {
    return define(ExVector3{a[0] + b[0], a[1] + b[1], a[2] + b[2]});
  }

  [[nodiscard]] ExVector3 scale(const GiNaC::ex& factor, const ExVector3& a) {
    return define(ExVector3{factor * a[0], factor * a[1], factor * a[2]});
  }

  [[nodiscard]] ExVector3 cross(const ExVector3& a, const ExVector3& b) {
    return define(
        ExVector3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
  }

  /// A x; A is row-major.
  [[nodiscard]] ExVector3 product(const ExMatrix3& a, const ExVector3& x) {
    ExVector3 result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
    }
    return define(result);
  }

  [[nodiscard]] GiNaC::ex dot(const ExVector3& a, const ExVector3& b) {
    return define(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  }

 private:
  Definitions& definitions_;
};

[[nodiscard]] inline bool is_zero(const ExVector3& a) {
  return a[0].is_zero() && a[1].is_zero() && a[2].is_zero();
}

}  // namespace elgen
