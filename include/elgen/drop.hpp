// drop: closed forms without their small terms.
//
//     M_11 = M + m + 1e-6 cos(2 q)     drop_below = 1e-3     ->     M_11 = M + m, off by 1e-6
//
// A term is small where its bound over the declared ranges is below a share of the bound of the
// largest term of its entry: largest, not their sum, so that an entry of many terms loses none of
// them for being one of many. Terms are those of the canonical sum: a product of leaves times the
// sine or cosine of one sum of angles.
//
// Dropped are terms of M, of V0, of dissipation, of applied forces and of B; everything else
// follows, so that the reduced outputs are those of one system:
//
//     C from the Christoffel symbols of the reduced M, p, T and E from M, g = dV0/dq, bias, tau.
//
// A term of V0 is dropped where its derivatives are small in every entry of g.
#pragma once

#include "elgen/closed_forms.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct ReducedForms {
  ClosedForms forms = {};
  Reduction reduction = {};
};

/// `forms` are those of `program`, which has the outputs and the parts of scene.dropping.
/// E608: a form that is needed was given up. E616: a term has no bound.
[[nodiscard]] Result<ReducedForms> drop_terms(const Program& program, ClosedForms forms,
                                              const Model& model, const Dropping& dropping);

}  // namespace elgen
