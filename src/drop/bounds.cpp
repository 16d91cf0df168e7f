// RangeBounds: see bounds.hpp. Every leaf of a term lies in its range by itself, so that bounds
// hold but need not be reached.
#include "drop/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "present/polynomial.hpp"

namespace elgen {

using cln::cl_RA;

namespace {

/// The first exponential of a monomial; null where it has none.
const AtomPower* exponential(const Algebra& algebra, const Monomial& monomial) {
  const auto found = std::find_if(monomial.begin(), monomial.end(), [&](const AtomPower& power) {
    return algebra.atoms[power.atom].kind == AtomKind::circular;
  });
  return found == monomial.end() ? nullptr : &*found;
}

Monomial conjugate(const Algebra& algebra, Monomial monomial) {
  for (AtomPower& power : monomial) {
    if (algebra.atoms[power.atom].kind == AtomKind::circular) power.exponent = -power.exponent;
  }
  return monomial;
}

Enclosure about_zero(const cl_RA& radius) { return {-radius, radius}; }

}  // namespace

std::vector<Fraction> terms_of(const Algebra& algebra, const Fraction& x) {
  std::vector<Fraction> terms;
  for (const auto& [monomial, coefficient] : x.numerator) {
    const AtomPower* angle = exponential(algebra, monomial);
    if (angle != nullptr && angle->exponent < 0) continue;  // stands with its conjugate
    Fraction term{{{monomial, coefficient}}, x.denominator};
    if (angle != nullptr) {
      add_term(term.numerator, conjugate(algebra, monomial),
               {coefficient.real, -coefficient.imaginary});
    }
    terms.push_back(std::move(term));
  }
  return terms;
}

std::nullopt_t RangeBounds::miss(const Span& span, std::string message, std::string hint) {
  missing_ = {Code::E616, span, std::move(message), std::move(hint)};
  return std::nullopt;
}

std::optional<Enclosure> RangeBounds::of(const Fraction& x) {
  std::optional<Enclosure> result = of(x.numerator);
  for (const auto& [factor, exponent] : x.denominator) {
    const std::optional<Enclosure> divisor = of(algebra_.factors[factor].shown);
    if (!result || !divisor) return std::nullopt;
    const std::optional<Enclosure> inverse = power(*divisor, -exponent);
    if (!inverse) return miss({}, "a denominator may be 0 within the declared ranges");
    result = product(*result, *inverse);
  }
  return result;
}

std::optional<TermBounds> RangeBounds::of_terms(const Fraction& x) {
  TermBounds bounds;
  for (const Fraction& term : terms_of(algebra_, x)) {
    const std::optional<Enclosure> bound = of(term);
    if (!bound) return std::nullopt;
    bounds.largest = cln::max(bounds.largest, magnitude(*bound));
    bounds.together = bounds.together + magnitude(*bound);
  }
  return bounds;
}

/// A pair c z + conj(c z), |z| = r, is at most 2 |c| r.
std::optional<Enclosure> RangeBounds::of(const Polynomial& sum) {
  Enclosure total;
  for (const auto& [monomial, coefficient] : sum) {
    const AtomPower* angle = exponential(algebra_, monomial);
    if (angle != nullptr && angle->exponent < 0) continue;
    const std::optional<Enclosure> powers = of(monomial);
    if (!powers) return std::nullopt;
    if (angle == nullptr) {
      total = elgen::sum(total, product(*powers, {coefficient.real, coefficient.real}));
      continue;
    }
    const cl_RA square =
        coefficient.real * coefficient.real + coefficient.imaginary * coefficient.imaginary;
    const cl_RA amplitude = square_root(Enclosure{square, square}).high * 2;
    total = elgen::sum(total, about_zero(amplitude * magnitude(*powers)));
  }
  return total;
}

std::optional<Enclosure> RangeBounds::of(const Monomial& monomial) {
  Enclosure result{1, 1};
  for (const AtomPower& factor : monomial) {
    if (algebra_.atoms[factor.atom].kind == AtomKind::circular) continue;  // of length 1
    const std::optional<Enclosure> base = of_atom(factor.atom);
    if (!base) return std::nullopt;
    const std::optional<Enclosure> raised = power(*base, factor.exponent);
    if (!raised) return miss({}, "a denominator may be 0 within the declared ranges");
    result = product(result, *raised);
  }
  return result;
}

std::optional<Enclosure> RangeBounds::of_atom(AtomId id) {
  if (const auto known = known_.find(id); known != known_.end()) return known->second;
  const Atom& atom = algebra_.atoms[id];
  std::optional<Enclosure> result;
  switch (atom.kind) {
    case AtomKind::leaf:
      result = of_leaf(atom);
      break;
    case AtomKind::pi:
      result = enclosure_of(cln::pi(cln::float_format(100)));
      break;
    case AtomKind::circular:
      result = about_zero(1);
      break;
    case AtomKind::root:
      result = of(atom.arguments[0]);
      if (result) result = square_root(*result);
      break;
    case AtomKind::call:
      result = of_call(atom);
      break;
  }
  if (result) known_[id] = *result;
  return result;
}

template <class Owner>
std::optional<Enclosure> RangeBounds::of_range(const Owner& owner,
                                               std::optional<Interval> Owner::*range,
                                               std::string_view key, std::string_view reason) {
  if (const auto& declared = owner.*range) return enclosure_of(declared->low, declared->high);
  return miss(owner.span, fmt::format("`drop_below` needs the `{}` of `{}`", key, owner.name),
              fmt::format("{}declare `{} = [low, high]`", reason, key));
}

std::optional<Enclosure> RangeBounds::of_leaf(const Atom& atom) {
  switch (atom.leaf) {
    case Opcode::parameter: {
      const Parameter& parameter = model_.parameters[atom.index];
      const auto& range = model_.parameter_arrays[parameter.array].range;
      return range ? enclosure_of(range->low, range->high) : enclosure_of(parameter.value);
    }
    case Opcode::coordinate:
      return of_range(model_.coordinates[atom.index], &Coordinate::range, "range",
                      "it stands outside sines and cosines: ");
    case Opcode::velocity:
      return of_range(model_.velocities[atom.index], &Velocity::rate_range, "rate_range", "");
    default:
      return miss({}, fmt::format("`drop_below` has no bound of `{}` outside sines and cosines",
                                  leaf_row(atom.leaf).symbol));
  }
}

std::optional<Enclosure> RangeBounds::of_call(const Atom& atom) {
  const cl_RA pi_above = cl_RA(22) / 7;
  switch (atom.function) {
    case FunctionId::tanh:
    case FunctionId::sign:
      return about_zero(1);
    case FunctionId::asin:
    case FunctionId::atan:
      return about_zero(pi_above / 2);
    case FunctionId::acos:
    case FunctionId::atan2:
      return about_zero(pi_above);
    case FunctionId::abs:
    case FunctionId::min:
    case FunctionId::max:
      break;
    default:
      return miss(
          {}, fmt::format("`drop_below` has no bound of `{}`", function_row(atom.function).name));
  }
  // |x|, min and max are at most the largest of their arguments.
  cl_RA largest = 0;
  for (const Fraction& argument : atom.arguments) {
    const std::optional<Enclosure> own = of(argument);
    if (!own) return std::nullopt;
    largest = cln::max(largest, magnitude(*own));
  }
  return about_zero(largest);
}

}  // namespace elgen
