// Replaces basis vectors by common rotations of all points, if the rotations are linear
// combinations of the basis vectors.
#include "analyse/symmetry_basis.hpp"

#include <algorithm>
#include <set>

#include "analyse/formulas.hpp"
#include "forms/present/arithmetic.hpp"

namespace elgen {
namespace {

using cln::cl_RA;

bool is_zero_form(const Fraction& x) { return x.numerator.empty(); }

/// The index of the last non-zero unknown. This unknown is free in the echelon form, because all
/// pivots precede it.
std::size_t free_unknown(const Generator& solution) {
  std::size_t last = 0;
  for (std::size_t u = 0; u < solution.size(); ++u) {
    if (!is_zero_form(solution[u])) last = u;
  }
  return last;
}

/// Rotations of all consecutive pairs, or triples, of coordinates by the same angle.
std::vector<Generator> common_rotations(const GeneratorLayout& all, std::size_t dimension) {
  std::vector<Generator> result;
  if (all.scalar_count() == 0 || all.scalar_count() % dimension != 0) return result;
  for (std::size_t i = 0; i < dimension; ++i) {
    for (std::size_t k = i + 1; k < dimension; ++k) {
      Generator& rotation = result.emplace_back(all.size());
      // From x to y, from y to z, from z to x.
      const int sign = k == i + 2 ? -1 : 1;
      for (std::size_t block = 0; block < all.scalar_count(); block += dimension) {
        rotation[all.a_index(block + k, block + i)] = fraction_of(cl_RA(sign));
        rotation[all.a_index(block + i, block + k)] = fraction_of(cl_RA(-sign));
      }
    }
  }
  return result;
}

/// Replaces basis vectors by common rotations that are symmetries.
class BasisChange {
 public:
  BasisChange(ClosedForms& forms, std::vector<Generator>& basis) : forms_(forms), basis_(basis) {
    for (const Generator& solution : basis) free_.push_back(free_unknown(solution));
  }

  void plan_replacement(std::size_t dimension, const Generator& wanted) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (is_zero_form(wanted[free_[i]])) continue;
      if (used_.contains(i)) return;
      parts.push_back(i);
    }
    if (parts.empty() || !is_solution(wanted, parts)) return;
    used_.insert(parts.begin(), parts.end());
    replaced_.push_back({parts.front(), dimension, wanted});
  }

  /// Replaces the planned vectors only now, because plan_replacement() needs the old vectors.
  void apply(const GeneratorLayout& all) {
    for (const CommonRotation& common : replaced_) {
      for (std::size_t i = 0; i < basis_.size(); ++i) {
        if (!used_.contains(i)) make_relative(all, common, basis_[i]);
      }
    }
    for (CommonRotation& common : replaced_) basis_[common.place] = std::move(common.rotation);
  }

 private:
  struct CommonRotation {
    std::size_t place = 0;      ///< index of the replaced basis vector
    std::size_t dimension = 0;  ///< coordinates per point
    Generator rotation = {};
  };

  /// True if `wanted` is the sum over i in `parts` of wanted[free_i] basis_i.
  [[nodiscard]] bool is_solution(const Generator& wanted, const std::vector<std::size_t>& parts) {
    Arithmetic arithmetic(forms_.algebra);
    for (std::size_t u = 0; u < wanted.size(); ++u) {
      OptionalFraction difference = arithmetic.negate(wanted[u]);
      for (const std::size_t i : parts) {
        if (is_zero_form(basis_[i][u])) continue;
        difference =
            arithmetic.add(difference, arithmetic.multiply(wanted[free_[i]], basis_[i][u]));
      }
      if (!difference || !is_zero_form(*difference)) return false;
    }
    return true;
  }

  /// Replaces `generator` by a multiple of `common` minus `generator`, if this difference does not
  /// move points that coincide. For two bodies, the rotation of one body about the other remains.
  void make_relative(const GeneratorLayout& all, const CommonRotation& common,
                     Generator& generator) {
    const std::size_t dimension = common.dimension;
    const Generator& rotation = common.rotation;
    Arithmetic arithmetic(forms_.algebra);
    // The change of coordinate i if every point has coordinate 1 along `axis` and 0 otherwise.
    const auto moved = [&](const Generator& of, std::size_t i, std::size_t axis) {
      OptionalFraction sum = Fraction{};
      for (std::size_t k = axis; k < all.scalar_count(); k += dimension) {
        sum = arithmetic.add(sum, of[all.a_index(i, k)]);
      }
      return sum;
    };
    OptionalFraction share = Fraction{};
    for (std::size_t i = 0; i < dimension && share && is_zero_form(*share); ++i) {
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        const OptionalFraction own = moved(rotation, i, axis);
        if (own && !is_zero_form(*own)) {
          share = arithmetic.divide(moved(generator, i, axis), own);
        }
      }
    }
    if (!share || is_zero_form(*share)) return;
    Generator relative;
    for (std::size_t u = 0; u < generator.size(); ++u) {
      const OptionalFraction entry =
          arithmetic.subtract(arithmetic.multiply(*share, rotation[u]), generator[u]);
      if (!entry) return;
      relative.push_back(*entry);
    }
    for (std::size_t i = 0; i < all.scalar_count(); ++i) {
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        const OptionalFraction rest = moved(relative, i, axis);
        if (!rest || !is_zero_form(*rest)) return;
      }
    }
    generator = std::move(relative);
  }

  ClosedForms& forms_;
  std::vector<Generator>& basis_;
  std::vector<std::size_t> free_ = {};
  std::set<std::size_t> used_ = {};
  std::vector<CommonRotation> replaced_ = {};
};

}  // namespace

void prefer_common_rotations(ClosedForms& forms, const GeneratorLayout& layout,
                             std::vector<Generator>& basis) {
  BasisChange change(forms, basis);
  for (const std::size_t dimension : {std::size_t{3}, std::size_t{2}}) {
    for (const Generator& rotation : common_rotations(layout, dimension))
      change.plan_replacement(dimension, rotation);
  }
  change.apply(layout);
}

Generator without_divisors(ClosedForms& forms, Generator generator) {
  Arithmetic arithmetic(forms.algebra);
  for (std::size_t u = 0; u < generator.size(); ++u) {
    const OptionalFraction divisor = full_denominator(forms.algebra, generator[u]);
    Generator scaled;
    for (const Fraction& entry : generator) {
      const OptionalFraction product = arithmetic.multiply(entry, divisor);
      if (!product) return generator;
      scaled.push_back(*product);
    }
    generator = std::move(scaled);
  }
  return generator;
}

SymmetryKind kind_of(ClosedForms& forms, const GeneratorLayout& all, const Generator& generator) {
  const auto count = [&](std::size_t first, std::size_t last) {
    return std::count_if(generator.begin() + static_cast<std::ptrdiff_t>(first),
                         generator.begin() + static_cast<std::ptrdiff_t>(last),
                         [](const Fraction& x) { return !is_zero_form(x); });
  };
  const auto in_a = count(0, all.c_index(0));
  const auto in_c = count(all.c_index(0), all.b_index(0));
  const auto in_b = count(all.b_index(0), all.world_turn_index(0, 0));
  const auto in_turns = count(all.world_turn_index(0, 0), all.time_index());
  const auto in_time = count(all.time_index(), all.size());
  const auto total = in_a + in_c + in_b + in_turns + in_time;
  if (in_time == total) return SymmetryKind::time;
  if (in_turns == total) return SymmetryKind::body_rotation;
  if (in_b == total) return total == 1 ? SymmetryKind::coordinate : SymmetryKind::translation;
  if (in_c == total) return SymmetryKind::boost;
  if (in_a < total) return SymmetryKind::other;
  Arithmetic arithmetic(forms.algebra);
  for (std::size_t i = 0; i < all.scalar_count(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const OptionalFraction sum =
          arithmetic.add(generator[all.a_index(i, k)], generator[all.a_index(k, i)]);
      if (!sum || !is_zero_form(*sum)) return SymmetryKind::other;
    }
  }
  return SymmetryKind::rotation;
}

}  // namespace elgen
