// EquationsOfMotion: the wanted outputs in recursive form: entries over one ordered list of
// definitions.
//
//     M(q,t) a + C(q,v,t) v + drift + g + dD/dv = B u + Q
//     tau = M a + bias,   bias = C v + drift + g + dD/dv - Q
//
// Derived only as far as the scene's outputs need it.
#pragma once

#include "elgen/lagrangian.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct FieldEquations {
  std::string name = {};  ///< "" for outputs of one field
  std::uint32_t rows = 1;
  std::uint32_t columns = 1;
  std::vector<GiNaC::ex> entries = {};  ///< row-major
};

struct OutputEquations {
  OutputRequest request = {};
  std::vector<FieldEquations> fields = {};
};

struct EquationsOfMotion {
  Symbols symbols = {};
  LeafNames leaves = {};
  Definitions definitions = {};
  std::vector<OutputEquations> outputs = {};  ///< in the order of the scene; without `dynamics`
};

/// Derives every requested output (mechanics: see the headers of src/derive/).
[[nodiscard]] Result<EquationsOfMotion> derive(const Lagrangian& lagrangian,
                                               const std::vector<OutputRequest>& outputs,
                                               const Limits& limits);

[[nodiscard]] std::string dump(const EquationsOfMotion& equations);

}  // namespace elgen
