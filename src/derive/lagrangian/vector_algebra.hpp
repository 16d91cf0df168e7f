// Vectors in three dimensions over definitions: every component of every result is one, so that
// nothing is ever written out twice.
#pragma once

#include <string>

#include "elgen/lagrangian.hpp"

namespace elgen {

class VectorAlgebra {
 public:
  explicit VectorAlgebra(Definitions& definitions) : definitions_(definitions) {}

  [[nodiscard]] GiNaC::ex define(const GiNaC::ex& value) {
    return elgen::define(definitions_, value);
  }

  [[nodiscard]] ExVector3 define(const ExVector3& value) {
    return {define(value[0]), define(value[1]), define(value[2])};
  }

  /// The components are called name_x, name_y, name_z, where they have no name yet.
  [[nodiscard]] ExVector3 define(const ExVector3& value, const std::string& name, Entity origin) {
    static constexpr const char* axes[] = {"_x", "_y", "_z"};
    ExVector3 result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = elgen::define(definitions_, value[i], {name + axes[i], origin});
    }
    return result;
  }

  [[nodiscard]] ExVector3 add(const ExVector3& a, const ExVector3& b) {
    return define(ExVector3{a[0] + b[0], a[1] + b[1], a[2] + b[2]});
  }

  [[nodiscard]] ExVector3 scaled(const GiNaC::ex& factor, const ExVector3& a) {
    return define(ExVector3{factor * a[0], factor * a[1], factor * a[2]});
  }

  [[nodiscard]] ExVector3 cross(const ExVector3& a, const ExVector3& b) {
    return define(
        ExVector3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
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
