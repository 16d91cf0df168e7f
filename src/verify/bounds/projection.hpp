// Projections: one exact number per field and state, contracted with random rational directions,
// that program and oracle both give at small cost.
#pragma once

#include "sample/points.hpp"
#include "verify/bounds/exact_run.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// Without words where the contraction of the field's exact entries is the oracle's, to 50 digits
/// of sum |w_i y_j| E_ij, or where the oracle has none; otherwise both numbers. The program may be
/// undefined. Solutions are put into the equation that they solve, which needs no solution:
///
///     every field:                  w.x, w.X y
///     accelerations:                w.(M a + bias) = w.B u
///     derivatives X of them:        w.M (X y) = -w.(slope of M a + bias - B u along y)
///     derivatives by the inputs:    w.M (X y) = w.B y
///     relative pivots:              each
[[nodiscard]] Mismatch compare_projection(const Subject& subject, const FieldPlace& place,
                                          const ExactRun& run, OracleCache& oracle, Sampler& draw);

}  // namespace elgen
