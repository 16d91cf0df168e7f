// The mass matrix entry by entry, then one linear solve.
#include "oracle/solved_dynamics.hpp"

#include <algorithm>

#include "oracle/contraction.hpp"

namespace elgen::oracle {

using cln::cl_R;

std::vector<cl_R> mass_matrix_values(Mechanics& at) {
  const std::size_t n = at.size();
  std::vector<cl_R> values(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      values[i * n + j] = values[j * n + i] = at.mass(at.unit(i), at.unit(j));
    }
  }
  return values;
}

Solution solve_mass(const Model& model, std::vector<cl_R> mass,
                    const std::vector<cl_R>& right_side) {
  if (!eliminates_last_first(model)) return solve_symmetric(std::move(mass), right_side);
  std::reverse(mass.begin(), mass.end());
  Solution solution = solve_symmetric(std::move(mass), {right_side.rbegin(), right_side.rend()});
  std::reverse(solution.x.begin(), solution.x.end());
  std::reverse(solution.relative_pivots.begin(), solution.relative_pivots.end());
  return solution;
}

Solution solved_dynamics(Mechanics& at, const std::vector<cl_R>& mass) {
  std::vector<cl_R> right_side;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Direction w = at.unit(i);
    right_side.push_back(at.input_force(w, at.state().u) - bias(at, w));
  }
  return solve_mass(at.model(), mass, right_side);
}

}  // namespace elgen::oracle
