// Projections: contract the exact entries of a field with random rational directions to one number,
// which the oracle computes at small cost, too.
#pragma once

#include <cstddef>
#include <optional>

#include "sample/points.hpp"
#include "verify/bounds/exact_run.hpp"
#include "verify/bounds/field_place.hpp"
#include "verify/bounds/oracle_cache.hpp"

namespace elgen {

/// Contracts the exact entries of a field with random directions w, y, and compares the number with
/// the oracle's, to 50 digits relative to sum |w_i y_j| E_ij, E_ij the running error of entry ij.
/// The text of the result is empty if the numbers agree; there is no result if the oracle has no
/// value. An undefined entry of the program is a mismatch if the oracle has a value. Without
/// constraints, solutions are inserted into the equation that they solve:
///
///     accelerations a:              w.(M a + bias) = w.B u
///     derivatives X of a by u:      w.M (X y) = w.B y
///     other derivatives X of a:     w.M (X y) = -w.(slope of M a + bias - B u along y)
///     relative pivots:              not contracted; each pivot is compared
///     all other fields:             w.x or w.X y
[[nodiscard]] std::optional<Mismatch> compare_projection(const SystemUnderTest& subject,
                                                         const ComparedField& place,
                                                         const ExactRun& run, OracleCache& oracle,
                                                         Sampler& draw);

/// True if one state is enough for a field: relative pivots of more than 20 velocities, because
/// they need all entries of M.
[[nodiscard]] bool is_projected_once(const ComparedField& place, const Model& model);

}  // namespace elgen
