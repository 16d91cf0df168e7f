// claims: sentences on the scope and completeness of a list of equilibria. An angle acos(n/d) or
// asin(n/d) exists if |n| <= |d|.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "analyse/formulas.hpp"
#include "numbers/exact_number.hpp"
#include "print/analyses/page_parts.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

std::string count_word(std::size_t count) {
  constexpr std::array names{"no", "one", "two", "three", "four", "five", "six"};
  return count < names.size() ? names[count] : std::to_string(count);
}

/// "in [0.5, 5]"; "= 0.5" if the two ends of the interval agree to six digits.
std::string interval_text(const Interval& sides) {
  static const cln::cl_R shown = power_of_ten(-6);
  const cln::cl_R middle = (sides.low + sides.high) / 2;
  const bool holds_zero = !cln::plusp(sides.low) && !cln::minusp(sides.high);
  if (sides.high - sides.low < shown * cln::max(cln::cl_R(1), cln::abs(middle))) {
    return "= " + (holds_zero ? "0" : short_number_text(middle));
  }
  return fmt::format("in [{}, {}]", short_number_text(sides.low), short_number_text(sides.high));
}

/// "l in [0.5, 5], theta = 0; l = 2, theta = 1"
std::string undecided_places_text(const Model& model, const Equilibria& equilibria) {
  constexpr std::size_t most_shown = 4;
  std::string places;
  for (std::size_t k = 0; k < std::min(most_shown, equilibria.undecided_boxes.size()); ++k) {
    std::string place;
    for (const auto& [coordinate, sides] : equilibria.undecided_boxes[k]) {
      place += fmt::format("{}{} {}", place.empty() ? "" : ", ", model.coordinates[coordinate].name,
                           interval_text(sides));
    }
    places += (places.empty() ? "" : "; ") + place;
  }
  if (equilibria.undecided_boxes.size() > most_shown) places += "; and other places";
  return places;
}

/// True if a coordinate of some point satisfies `wanted`, and this point is an equilibrium only for
/// the present values of the parameters.
template <class Wanted>
bool has_inexact_point(const Equilibria& equilibria, const Wanted& wanted) {
  return std::ranges::any_of(equilibria.points, [&wanted](const RestPoint& point) {
    return !point.is_exact && std::ranges::any_of(point.coordinates, wanted);
  });
}

bool has_arc_angle(const RestPoint& point) {
  return std::ranges::any_of(point.coordinates, [](const RestCoordinate& coordinate) {
    return coordinate.inverse_argument.has_value();
  });
}

std::size_t count_points_with_arc_angle(const Equilibria& equilibria) {
  return static_cast<std::size_t>(std::ranges::count_if(equilibria.points, has_arc_angle));
}

/// True if a form is a product of a positive number, even powers, and parameters that are assumed
/// to be positive.
bool is_positive(const PageForms& known, const Fraction& product) {
  if (product.numerator.size() != 1 || !product.denominator.empty()) return false;
  const auto& [monomial, coefficient] = *product.numerator.begin();
  return cln::plusp(coefficient.real) &&
         std::ranges::all_of(monomial, [&known](const AtomPower& power) {
           const Atom& atom = known.forms.algebra.atoms[power.atom];
           const bool is_parameter = atom.kind == AtomKind::leaf && atom.leaf == Opcode::parameter;
           return power.exponent % 2 == 0 ||
                  (is_parameter &&
                   known.model.parameters[atom.index].assumption == Assumption::positive);
         });
}

/// The condition |numerator| <= |denominator|, without bars around a denominator that is known to
/// be positive.
std::optional<Formula> sinusoid_condition(PageForms& known, const Fraction& sinusoid) {
  const OptionalFraction below = full_denominator(known.forms.algebra, sinusoid);
  if (!below) return std::nullopt;
  std::optional<Formula> above =
      known.to_formula(Arithmetic(known.forms.algebra).multiply(sinusoid, below));
  std::optional<Formula> bound = known.to_formula(below);
  if (!above || !bound) return std::nullopt;
  if (!is_positive(known, *below)) bound = absolute_value_of(std::move(*bound));
  return relation(absolute_value_of(std::move(*above)), std::move(*bound), "<=");
}

/// The common c of all rest angles acos(c) or asin(c); none if two angles differ in c.
std::optional<Fraction> common_sinusoid(ClosedForms& forms, const Equilibria& equilibria) {
  std::optional<Fraction> only;
  for (const RestPoint& point : equilibria.points) {
    for (const RestCoordinate& coordinate : point.coordinates) {
      if (!coordinate.inverse_argument) continue;
      if (only && !is_proved_equal(forms, *only, *coordinate.inverse_argument)) return std::nullopt;
      only = coordinate.inverse_argument;
    }
  }
  return only;
}

/// "the last two exist if |g| <= R*Omega^2"
Formula existence_condition(PageForms& known, const Equilibria& equilibria) {
  const std::size_t count = count_points_with_arc_angle(equilibria);
  const bool are_last = std::ranges::is_partitioned(equilibria.points, std::not_fn(has_arc_angle));
  const std::string subject = count == equilibria.points.size() ? "they exist"
                              : !are_last                       ? "angles exist"
                              : count == 1                      ? "the last one exists"
                                           : fmt::format("the last {} exist", count_word(count));
  const std::optional<Fraction> sinusoid = common_sinusoid(known.forms, equilibria);
  const std::optional<Formula> condition =
      sinusoid ? sinusoid_condition(known, *sinusoid) : std::nullopt;
  return row_of({prose(subject + " if"),
                 condition ? *condition : prose("the arguments of acos and asin are in [-1, 1]")});
}

/// The clause "numbers and stability computed at the parameters' values".
Formula parameter_value_clause(Formulas special) {
  special.push_back(prose("stability"));
  return row_of({enumeration(std::move(special)), prose("computed at the parameters' values")});
}

/// Appends searched ranges, then coordinates without a range: "r in [0.3, 3]; theta modulo 2*pi".
void add_search_clauses(Formulas& clauses, const PageForms& known, const Equilibria& equilibria) {
  std::ranges::move(searched_ranges(known, equilibria), std::back_inserter(clauses));
  Formulas turns;
  Formulas starts;
  for (std::size_t i = 0; i < known.symbols.q.size(); ++i) {
    if (equilibria.kinds[i] == SearchKind::turn) turns.push_back(known.symbols.q[i]);
    if (equilibria.kinds[i] == SearchKind::start) starts.push_back(known.symbols.q[i]);
  }
  if (!turns.empty()) {
    clauses.push_back(row_of({enumeration(std::move(turns)), prose("modulo"),
                              product_of({number_formula(2), pi_formula()})}));
  }
  if (!starts.empty()) {
    clauses.push_back(
        row_of({enumeration(std::move(starts)), prose("searched only from the start")}));
  }
}

/// The limit that ended the search, and the option that raises it; "" without a limit.
std::string limit_text(const Equilibria& equilibria) {
  const std::string& limit = equilibria.limit;
  if (limit.empty()) return {};
  return fmt::format("; the limit {} ended the search: raise it with --limit {}=N", limit,
                     limit.substr(0, limit.find('=')));
}

}  // namespace

Formula scope_claim(PageForms& known, const Equilibria& equilibria) {
  Formulas special;
  if (has_inexact_point(
          equilibria, [](const RestCoordinate& x) { return !x.is_arbitrary && !x.closed_form; })) {
    special.push_back(prose("numbers"));
  }
  if (has_inexact_point(equilibria, &RestCoordinate::is_arbitrary))
    special.push_back(prose("\"any\""));
  Formulas clauses;
  if (count_points_with_arc_angle(equilibria) > 0) {
    clauses.push_back(existence_condition(known, equilibria));
  } else if (special.empty()) {
    clauses.push_back(prose("exact for all values of the parameters"));
  }
  clauses.push_back(parameter_value_clause(std::move(special)));
  add_search_clauses(clauses, known, equilibria);
  Formulas row;
  for (Formula& clause : clauses) {
    if (!row.empty()) row.push_back(prose(";"));
    row.push_back(std::move(clause));
  }
  return row_of(std::move(row));
}

Formula completeness_claim(const Model& model, const Equilibria& equilibria) {
  const std::string places = undecided_places_text(model, equilibria);
  switch (equilibria.completeness) {
    case Completeness::proved:
      return prose("the list is complete at the parameters' values (proved)");
    case Completeness::searched:
      if (equilibria.points.empty() && !places.empty()) break;
      return prose(fmt::format(
          "found from {} start{}; there may be more{}{}{}",
          std::max<std::uint64_t>(equilibria.starts, 1), equilibria.starts > 1 ? "s" : "",
          places.empty() ? "" : "; undecided near ", places, limit_text(equilibria)));
    case Completeness::undecided:
      if (places.empty())
        return prose("undecided: bias - B u is 0 in 60 digits, not proved to be 0");
      break;
  }
  return prose("undecided near " + places + limit_text(equilibria));
}

}  // namespace elgen
