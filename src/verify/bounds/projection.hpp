// Projections: one exact number per field and state, contracted with random rational directions.
// Program and oracle both compute it at small cost.
#pragma once

#include "sample/points.hpp"
#include "verify/bounds/exact_run.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// Compares the contraction of a field's exact entries with the oracle's, to 50 digits of
/// sum |w_i y_j| E_ij. The text is empty if they agree or the oracle has no value. The program's
/// entries may be undefined. Solutions are inserted into their equation, which needs no solving:
///
///     every field:                  w.x, w.X y
///     accelerations:                w.(M a + bias) = w.B u
///     derivatives X of them:        w.M (X y) = -w.(slope of M a + bias - B u along y)
///     derivatives by the inputs:    w.M (X y) = w.B y
///     relative pivots:              each
[[nodiscard]] Mismatch compare_projection(const Subject& subject, const FieldPlace& place,
                                          const ExactRun& run, OracleCache& oracle, Sampler& draw);

}  // namespace elgen
