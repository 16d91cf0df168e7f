// drop: closed forms without their small terms, and all that is said of them.
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
#include "elgen/evaluate.hpp"
#include "elgen/model.hpp"
#include "elgen/oracle.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

struct ReducedForms {
  ClosedForms forms = {};
  Reduction reduction = {};
};

/// The outputs of a scene that drops terms, and the parts that they are made of, each once.
[[nodiscard]] std::vector<OutputRequest> with_parts(const Scene& scene);

/// The forms of `program`'s functions out of `forms`, those of `whole`, which has the parts too.
/// E608: a form that is needed was given up. E616: a term has no bound. E618: M without its terms
/// could be indefinite.
[[nodiscard]] Result<ReducedForms> drop_terms(const Program& program, const Program& whole,
                                              ClosedForms forms, const CheckedModel& checked);

/// How far an entry may be from the exact model, beside rounding, at a state inside the ranges,
/// which rounding may have left by one part in 2^20; 0 where the output is exact.
[[nodiscard]] Real stated_error(const Program& program, OutputKind output, std::size_t entry,
                                const State& state);

/// "3 terms below 0.001 of …"; empty where the program is that of the exact model.
[[nodiscard]] std::string dropped_summary(const Program& program);

/// The same, every term with its bound, and what every entry is off by at most.
[[nodiscard]] std::string dropped_page(const Model& model, const Program& program);

}  // namespace elgen
