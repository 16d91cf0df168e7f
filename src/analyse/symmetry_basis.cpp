// Rotations of all points at once replace those vectors of a basis that they are made of.
#include "analyse/symmetry_basis.hpp"

#include <algorithm>
#include <set>

#include "present/arithmetic.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

bool is_zero_form(const Fraction& x) { return x.numerator.empty(); }

/// The last unknown that a solution moves: the free one, since pivots stand before it.
std::size_t free_unknown(const Generator& solution) {
  std::size_t last = 0;
  for (std::size_t u = 0; u < solution.size(); ++u) {
    if (!is_zero_form(solution[u])) last = u;
  }
  return last;
}

/// Turns of all pairs, or triples, of coordinates in their order at once.
std::vector<Generator> common_rotations(const GeneratorClass& all, std::size_t dimension) {
  std::vector<Generator> result;
  if (all.scalars() == 0 || all.scalars() % dimension != 0) return result;
  for (std::size_t i = 0; i < dimension; ++i) {
    for (std::size_t k = i + 1; k < dimension; ++k) {
      Generator& rotation = result.emplace_back(all.size());
      // From x to y, from y to z, from z to x.
      const int sign = k == i + 2 ? -1 : 1;
      for (std::size_t block = 0; block < all.scalars(); block += dimension) {
        rotation[all.a(block + k, block + i)] = fraction_of(cl_RA(sign));
        rotation[all.a(block + i, block + k)] = fraction_of(cl_RA(-sign));
      }
    }
  }
  return result;
}

/// Puts common rotations in the place of basis vectors, where they are solutions.
class BasisChange {
 public:
  BasisChange(ClosedForms& forms, std::vector<Generator>& basis) : forms_(forms), basis_(basis) {
    for (const Generator& solution : basis) free_.push_back(free_unknown(solution));
  }

  void take(const Generator& wanted) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (is_zero_form(wanted[free_[i]])) continue;
      if (used_.contains(i)) return;
      parts.push_back(i);
    }
    if (parts.empty() || !is_solution(wanted, parts)) return;
    used_.insert(parts.begin(), parts.end());
    replaced_.emplace_back(parts.front(), wanted);
  }

  /// Once all are taken, since they are combinations of the old ones.
  void apply() {
    for (auto& [place, generator] : replaced_) basis_[place] = std::move(generator);
  }

 private:
  /// wanted = sum over parts of wanted_free basis_part
  [[nodiscard]] bool is_solution(const Generator& wanted, const std::vector<std::size_t>& parts) {
    Arithmetic arithmetic(forms_.algebra);
    for (std::size_t u = 0; u < wanted.size(); ++u) {
      Value difference = arithmetic.negate(wanted[u]);
      for (const std::size_t i : parts) {
        if (is_zero_form(basis_[i][u])) continue;
        difference =
            arithmetic.add(difference, arithmetic.multiply(wanted[free_[i]], basis_[i][u]));
      }
      if (!difference || !is_zero_form(*difference)) return false;
    }
    return true;
  }

  ClosedForms& forms_;
  std::vector<Generator>& basis_;
  std::vector<std::size_t> free_ = {};
  std::set<std::size_t> used_ = {};
  std::vector<std::pair<std::size_t, Generator>> replaced_ = {};
};

}  // namespace

void prefer_common_rotations(ClosedForms& forms, const GeneratorClass& all,
                             std::vector<Generator>& basis) {
  BasisChange change(forms, basis);
  for (const std::size_t dimension : {std::size_t{3}, std::size_t{2}}) {
    for (const Generator& rotation : common_rotations(all, dimension)) change.take(rotation);
  }
  change.apply();
}

SymmetryKind kind_of(ClosedForms& forms, const GeneratorClass& all, const Generator& generator) {
  const auto count = [&](std::size_t first, std::size_t last) {
    return std::count_if(generator.begin() + static_cast<std::ptrdiff_t>(first),
                         generator.begin() + static_cast<std::ptrdiff_t>(last),
                         [](const Fraction& x) { return !is_zero_form(x); });
  };
  const auto in_a = count(0, all.c(0));
  const auto in_c = count(all.c(0), all.b(0));
  const auto in_b = count(all.b(0), all.world_turn(0, 0));
  const auto in_turns = count(all.world_turn(0, 0), all.time());
  const auto in_time = count(all.time(), all.size());
  const auto total = in_a + in_c + in_b + in_turns + in_time;
  if (in_time == total) return SymmetryKind::time;
  if (in_turns == total) return SymmetryKind::turn;
  if (in_b == total) return total == 1 ? SymmetryKind::coordinate : SymmetryKind::translation;
  if (in_c == total) return SymmetryKind::boost;
  if (in_a < total) return SymmetryKind::other;
  Arithmetic arithmetic(forms.algebra);
  for (std::size_t i = 0; i < all.scalars(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const Value sum = arithmetic.add(generator[all.a(i, k)], generator[all.a(k, i)]);
      if (!sum || !is_zero_form(*sum)) return SymmetryKind::other;
    }
  }
  return SymmetryKind::rotation;
}

}  // namespace elgen
