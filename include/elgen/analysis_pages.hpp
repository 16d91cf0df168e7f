// Pages of analyses: equilibria, small motions about them, and symmetries; the same as JSON, for
// programs.
#pragma once

#include <string>
#include <vector>

#include "elgen/analyse.hpp"
#include "elgen/page.hpp"

namespace elgen {

[[nodiscard]] Page equilibria_page(const CheckedModel& checked, const Equilibria& equilibria);
[[nodiscard]] Page modes_page(const CheckedModel& checked, const Equilibria& equilibria,
                              const std::vector<LinearMotions>& all);
[[nodiscard]] Page symmetries_page(const CheckedModel& checked, const Symmetries& symmetries);

/// Numbers have the digits that tell doubles apart.
[[nodiscard]] std::string equilibria_json(const CheckedModel& checked,
                                          const Equilibria& equilibria);
[[nodiscard]] std::string modes_json(const CheckedModel& checked, const Equilibria& equilibria,
                                     const std::vector<LinearMotions>& all);
[[nodiscard]] std::string symmetries_json(const CheckedModel& checked,
                                          const Symmetries& symmetries);

}  // namespace elgen
