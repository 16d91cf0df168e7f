// Residues: arithmetic modulo 2^521 - 1. The addition theorem gives the sine and cosine of a sum.
#include "analyse/residues.hpp"

#include <cln/integer.h>

#include "elgen/fold.hpp"
#include "elgen/leaves.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using cln::cl_I;
using cln::cl_MI;

const cl_I& prime() {
  static const cl_I value = cln::ash(cl_I(1), 521) - 1;
  return value;
}

cl_MI integer_residue(int value) { return residue_field()->canonhom(value); }

CirclePoint add_angles(const CirclePoint& a, const CirclePoint& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

CirclePoint negate_angle(const CirclePoint& a) { return {a.cosine, -a.sine}; }

/// The point ((1 - s^2), 2 s)/(1 + s^2) of the unit circle.
CirclePoint circle_point(const cl_MI& s) {
  const cl_MI scale = cln::recip(integer_residue(1) + s * s);
  return {(integer_residue(1) - s * s) * scale, integer_residue(2) * s * scale};
}

/// k modulo 4, if the constant is k pi/2 with integer k; else none.
std::optional<int> quarter_turns(const ConstantForm& form) {
  if (form.kind == ConstantKind::pi) return 2;
  if (form.kind != ConstantKind::product) return std::nullopt;
  cln::cl_RA factor = 2;
  bool has_pi = false;
  for (const ConstantOperand& part : form.operands) {
    if (part.form.kind == ConstantKind::pi && part.weight == 1 && !has_pi) {
      has_pi = true;
    } else if (part.form.kind == ConstantKind::rational) {
      factor = factor * cln::expt(part.form.number, part.weight);
    } else {
      return std::nullopt;
    }
  }
  const bool is_whole = has_pi && cln::denominator(factor) == 1;
  return is_whole ? std::optional(cln::cl_I_to_int(cln::mod(cln::numerator(factor), cl_I(4))))
                  : std::nullopt;
}

std::optional<CirclePoint> multiply_angle(const CirclePoint& angle, const cl_I& times) {
  constexpr int most = 16;
  if (times > most || times < -most) return std::nullopt;
  CirclePoint sum{integer_residue(1), integer_residue(0)};
  for (int i = 0; cl_I(i) < cln::abs(times); ++i) sum = add_angles(sum, angle);
  return times < 0 ? negate_angle(sum) : sum;
}

struct ResidueRules {
  const LeafValues<Residue>& leaves;

  [[nodiscard]] Residue constant(const Constant& constant) const {
    Residue result;
    if (is_rational(constant)) result.value = residue_of(cln::the<cln::cl_RA>(constant.value));
    if (cln::zerop(constant.value)) result.angle = {integer_residue(1), integer_residue(0)};
    if (const auto turns = quarter_turns(constant.form)) {
      result.angle = multiply_angle({integer_residue(0), integer_residue(1)}, *turns);
    }
    return result;
  }
  [[nodiscard]] Residue leaf(Opcode kind, std::uint32_t number) const {
    return leaf_of(leaves, kind, number);
  }
  [[nodiscard]] Residue negate(const Residue& x) const {
    Residue result;
    if (x.value) result.value = -*x.value;
    if (x.angle) result.angle = negate_angle(*x.angle);
    return result;
  }
  [[nodiscard]] Residue add(const Residue& x, const Residue& y) const {
    Residue result;
    if (x.value && y.value) result.value = *x.value + *y.value;
    if (x.angle && y.angle) result.angle = add_angles(*x.angle, *y.angle);
    return result;
  }
  [[nodiscard]] Residue subtract(const Residue& x, const Residue& y) const {
    return add(x, negate(y));
  }
  [[nodiscard]] Residue multiply(const Residue& x, const Residue& y) const {
    Residue result;
    if (x.value && y.value) result.value = *x.value * *y.value;
    for (const auto& [angle, factor] : {std::pair(&x, &y), std::pair(&y, &x)}) {
      if (!angle->angle || !factor->value || result.angle) continue;
      const auto times = reconstruct_rational(*factor->value);
      const bool is_whole = times && cln::denominator(*times) == 1;
      if (is_whole) result.angle = multiply_angle(*angle->angle, cln::numerator(*times));
    }
    return result;
  }
  [[nodiscard]] Residue divide(const Residue& x, const Residue& y) const {
    if (!x.value || !y.value || cln::zerop(*y.value)) return {};
    return {.value = *x.value * cln::recip(*y.value)};
  }
  [[nodiscard]] Residue square_root(const Residue&) const { return {}; }
  [[nodiscard]] Residue call(FunctionId function, const Residue& x, const Residue&) const {
    if (function == FunctionId::cos && x.angle) return {.value = x.angle->cosine};
    if (function == FunctionId::sin && x.angle) return {.value = x.angle->sine};
    return {};
  }
};

LeafValues<Residue> draw_leaves(const Model& model, const Program& program, Sampler& draw) {
  const auto drawn = [&draw](const std::string&) {
    const cl_MI s = residue_of(draw.number());
    return Residue{.value = residue_of(draw.number()), .angle = circle_point(s)};
  };
  LeafValues<Residue> leaves =
      map_leaves(drawn, static_cast<const LeafValues<std::string>&>(program.leaves));
  for (std::size_t i = 0; i < leaves.parameters.size(); ++i) {
    const cln::cl_R& value = model.parameters[i].value;
    leaves.parameters[i] = {};
    if (!is_rational(value)) continue;
    leaves.parameters[i].value = residue_of(cln::the<cln::cl_RA>(value));
    if (cln::zerop(value)) leaves.parameters[i].angle = {integer_residue(1), integer_residue(0)};
  }
  // A random unit quaternion: the inverse of the stereographic projection at a random point s.
  for (const Rotation& rotation : model.rotations) {
    const std::array<cl_MI, 3> s{residue_of(draw.number()), residue_of(draw.number()),
                                 residue_of(draw.number())};
    const cl_MI square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
    const cl_MI scale = cln::recip(integer_residue(1) + square);
    leaves.q[rotation.first_coordinate] = {.value = (integer_residue(1) - square) * scale};
    for (std::size_t i = 0; i < 3; ++i) {
      leaves.q[rotation.first_coordinate + 1 + i] = {.value = integer_residue(2) * s[i] * scale};
    }
  }
  return leaves;
}

}  // namespace

const cln::cl_modint_ring& residue_field() {
  static const cln::cl_modint_ring field = cln::find_modint_ring(prime());
  return field;
}

cl_MI residue_of(const cln::cl_RA& number) {
  return residue_field()->canonhom(cln::numerator(number)) *
         cln::recip(residue_field()->canonhom(cln::denominator(number)));
}

/// Rational reconstruction: Euclid's algorithm for the prime and `residue` stops at the first
/// remainder below `bound`.
std::optional<cln::cl_RA> reconstruct_rational(const cl_MI& residue) {
  const cl_I bound = cln::ash(cl_I(1), 250);
  cl_I before = prime();
  cl_I remainder = residue_field()->retract(residue);
  cl_I factor_before = 0;
  cl_I factor = 1;
  while (remainder >= bound) {
    const cl_I quotient = cln::floor1(before, remainder);
    const cl_I next = before - quotient * remainder;
    before = remainder;
    remainder = next;
    const cl_I next_factor = factor_before - quotient * factor;
    factor_before = factor;
    factor = next_factor;
  }
  if (cln::zerop(factor) || cln::abs(factor) >= bound) return std::nullopt;
  return cln::cl_RA(remainder) / factor;
}

std::vector<Residue> sample_residues(const Model& model, const Program& program,
                                     const Function& function, Sampler& sampler) {
  const LeafValues<Residue> leaves = draw_leaves(model, program, sampler);
  return entries_of(function, fold<Residue>(ResidueRules{leaves}, program, function));
}

}  // namespace elgen
