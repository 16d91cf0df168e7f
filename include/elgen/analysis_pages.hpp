// Pages of analyses (equilibria, small motions, symmetries, base parameters), and their JSON.
#pragma once

#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/base_parameters.hpp"
#include "elgen/page.hpp"

namespace elgen {

[[nodiscard]] Page equilibria_page(const CheckedModel& checked, const Equilibria& equilibria);
[[nodiscard]] Page modes_page(const CheckedModel& checked, const Modes& modes);
[[nodiscard]] Page symmetries_page(const CheckedModel& checked, const Symmetries& symmetries);

/// The page with the equation and the value of each base parameter.
[[nodiscard]] Page base_parameters_page(const CheckedModel& checked, const BaseParameters& found);

/// The result of an analysis as JSON. Each number has enough digits to read back the same double.
[[nodiscard]] std::string equilibria_json(const CheckedModel& checked,
                                          const Equilibria& equilibria);
[[nodiscard]] std::string modes_json(const CheckedModel& checked, const Modes& modes);
[[nodiscard]] std::string symmetries_json(const CheckedModel& checked,
                                          const Symmetries& symmetries);

[[nodiscard]] std::string base_parameters_json(const CheckedModel& checked,
                                               const BaseParameters& found);

/// The shortest formula of `form`, a fraction over `algebra`, in the symbols of `model`. None if
/// `form` is none, or if the formula is too long to read.
[[nodiscard]] std::optional<Formula> readable_formula(const Model& model, const Algebra& algebra,
                                                      const std::optional<Fraction>& form);

}  // namespace elgen
