// An angle acos(n/d) or asin(n/d) exists where |n| <= |d|.
#include "analyse/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "analyse/searched_range.hpp"
#include "forms/present/arithmetic.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

std::string words(std::size_t count) {
  constexpr std::array names{"no", "one", "two", "three", "four", "five", "six"};
  return count < names.size() ? names[count] : std::to_string(count);
}

/// "= 0" of boxes that six digits do not show.
std::string side_text(const Interval& sides) {
  static const cln::cl_R shown = power_of_ten(-6);
  const cln::cl_R middle = (sides.low + sides.high) / 2;
  const bool holds_zero = !cln::plusp(sides.low) && !cln::minusp(sides.high);
  if (sides.high - sides.low < shown * cln::max(cln::cl_R(1), cln::abs(middle))) {
    return "= " + (holds_zero ? "0" : short_text(middle));
  }
  return fmt::format("in [{}, {}]", short_text(sides.low), short_text(sides.high));
}

/// "l in [0.5, 5], theta = 0; l = 2, theta = 1"
std::string undecided_places(const Model& model, const Equilibria& equilibria) {
  constexpr std::size_t most_shown = 4;
  std::string places;
  for (std::size_t k = 0; k < std::min(most_shown, equilibria.undecided.size()); ++k) {
    std::string place;
    for (const auto& [coordinate, sides] : equilibria.undecided[k]) {
      place += fmt::format("{}{} {}", place.empty() ? "" : ", ", model.coordinates[coordinate].name,
                           side_text(sides));
    }
    places += (places.empty() ? "" : "; ") + place;
  }
  if (equilibria.undecided.size() > most_shown) places += "; and other places";
  return places;
}

/// Whether a coordinate is so at a point that is one at these parameters alone.
template <class Wanted>
bool has_inexact(const Equilibria& equilibria, const Wanted& wanted) {
  return std::ranges::any_of(equilibria.points, [&wanted](const RestPoint& point) {
    return !point.is_exact && std::ranges::any_of(point.coordinates, wanted);
  });
}

bool has_sinusoid(const RestPoint& point) {
  return std::ranges::any_of(point.coordinates, [](const CoordinateAtRest& coordinate) {
    return coordinate.sinusoid.has_value();
  });
}

std::size_t count_with_sinusoids(const Equilibria& equilibria) {
  return static_cast<std::size_t>(std::ranges::count_if(equilibria.points, has_sinusoid));
}

Printed with_semicolon(const Printed& formula) {
  return {formula.text + ";", formula.latex + "\\text{; }"};
}

/// The conditions of the closed forms, and where was searched.
class ScopeOfForms {
 public:
  ScopeOfForms(const Model& model, const Equilibria& equilibria)
      : model_(model),
        equilibria_(equilibria),
        forms_(equilibria.forms),
        symbols_(symbols_of(model)) {}

  Printed operator()() {
    std::vector<Printed> special;
    if (has_inexact(equilibria_, [](const CoordinateAtRest& x) { return !x.is_any && !x.form; })) {
      special.push_back(prose("numbers"));
    }
    if (has_inexact(equilibria_, [](const CoordinateAtRest& x) { return x.is_any; })) {
      special.push_back(prose("any"));
    }
    Printed result = count_with_sinusoids(equilibria_) > 0 ? existence()
                     : special.empty() ? prose("exact for all values of the parameters")
                                       : Printed{};
    if (!result.text.empty()) result = with_semicolon(result);
    special.push_back(prose("stability"));
    return with_turns(result + listed(special) + prose("at the parameters' values"));
  }

 private:
  /// "the last two exist where |g| <= R W^2"
  Printed existence() {
    const std::size_t count = count_with_sinusoids(equilibria_);
    std::optional<Fraction> sinusoid;
    bool is_one = true;
    for (const RestPoint& point : equilibria_.points) {
      for (const CoordinateAtRest& coordinate : point.coordinates) {
        if (!coordinate.sinusoid) continue;
        if (sinusoid) is_one = is_one && proved_equal(forms_, *sinusoid, *coordinate.sinusoid);
        sinusoid = coordinate.sinusoid;
      }
    }
    const bool are_last =
        std::ranges::is_partitioned(equilibria_.points, std::not_fn(has_sinusoid));
    const std::string subject = count == equilibria_.points.size() ? "they exist"
                                : !are_last                        ? "angles exist"
                                : count == 1                       ? "the last one exists"
                                             : fmt::format("the last {} exist", words(count));
    const std::optional<Printed> condition = is_one ? condition_of(*sinusoid) : std::nullopt;
    const Printed where = condition ? prose("where") + *condition
                                    : prose("where the arguments of acos and asin are in [-1, 1]");
    return prose(subject) + where;
  }

  /// |numerator| <= |denominator|, without bars where the sign is known.
  std::optional<Printed> condition_of(const Fraction& sinusoid) {
    Arithmetic arithmetic(forms_.algebra);
    const Value below = divisor_of(forms_.algebra, sinusoid);
    if (!below) return std::nullopt;
    const std::optional<Printed> above = read(arithmetic.multiply(sinusoid, below));
    const std::optional<Printed> bound = read(below);
    if (!above || !bound) return std::nullopt;
    const auto bars = [](const Printed& x) {
      return Printed{"|" + x.text + "|", "|" + x.latex + "|"};
    };
    const Printed right = is_positive(*below) ? *bound : bars(*bound);
    const Printed left = bars(*above);
    return Printed{left.text + " <= " + right.text, left.latex + " \\le " + right.latex};
  }

  /// A product of even powers and of parameters that are assumed to be positive.
  [[nodiscard]] bool is_positive(const Fraction& product) const {
    if (product.numerator.size() != 1 || !product.denominator.empty()) return false;
    const auto& [monomial, coefficient] = *product.numerator.begin();
    return cln::plusp(coefficient.real) &&
           std::ranges::all_of(monomial, [this](const AtomPower& power) {
             return power.exponent % 2 == 0 || is_positive_leaf(power.atom);
           });
  }

  [[nodiscard]] bool is_positive_leaf(AtomId id) const {
    const Atom& atom = forms_.algebra.atoms[id];
    return atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter &&
           model_.parameters[atom.index].assumption == Assumption::positive;
  }

  /// "; r in [0.3, 3]; θ modulo 2 π": where was searched, and what was not.
  Printed with_turns(const Printed& line) const {
    std::vector<Printed> turns;
    std::vector<Printed> starts;
    for (std::size_t i = 0; i < model_.coordinates.size(); ++i) {
      if (equilibria_.kinds[i] == SearchKind::turn) turns.push_back(symbols_.q[i]);
      if (equilibria_.kinds[i] == SearchKind::start) starts.push_back(symbols_.q[i]);
    }
    Printed result = line;
    const auto add = [&result](const std::vector<Printed>& names, const Printed& rest) {
      if (names.empty()) return;
      const Printed part = listed(names) + rest;
      result = result.text.empty() ? part : with_semicolon(result) + part;
    };
    for (std::size_t i = 0; i < model_.coordinates.size(); ++i) {
      const Interval* const range = searched_range(model_.coordinates[i], equilibria_.kinds[i]);
      if (range == nullptr) continue;
      add({symbols_.q[i]},
          prose(fmt::format("in [{}, {}]", short_text(range->low), short_text(range->high))));
    }
    add(turns, prose("modulo") + Printed{"2*pi", "2 \\pi"});
    add(starts, prose("from the start alone"));
    return result;
  }

  [[nodiscard]] std::optional<Printed> read(const std::optional<Fraction>& form) const {
    return printed(model_, forms_.algebra, form);
  }

  const Model& model_;
  const Equilibria& equilibria_;
  ClosedForms forms_;  ///< a copy: reading forms adds to their algebra
  LeafValues<Printed> symbols_;
};

}  // namespace

Printed scope_of(const Model& model, const Equilibria& equilibria) {
  return ScopeOfForms(model, equilibria)();
}

Printed claim_of(const Model& model, const Equilibria& equilibria) {
  const std::string places = undecided_places(model, equilibria);
  switch (equilibria.completeness) {
    case Completeness::proved:
      return prose("these are all at the parameters' values (proved)");
    case Completeness::searched:
      if (equilibria.points.empty() && !places.empty()) break;
      return prose(fmt::format("found from {} start{}{}, there may be more{}{}",
                               std::max<std::uint64_t>(equilibria.starts, 1),
                               equilibria.starts > 1 ? "s" : "",
                               equilibria.is_cut ? " at the limit of enclosures" : "",
                               places.empty() ? "" : ": undecided near ", places));
    case Completeness::undecided:
      if (places.empty()) return prose("undecided: 64 digits do not tell bias - B u from 0");
      break;
  }
  return prose("undecided near " + places);
}

}  // namespace elgen
