// expanded_calls: see expanded_calls.hpp.
#include "forms/write/expanded_calls.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <vector>

#include "forms/write/graph_terms.hpp"
#include "forms/write/kept_terms.hpp"

namespace elgen {
namespace {

class CallExpander : GraphTermBuilder {
 public:
  using GraphTermBuilder::GraphTermBuilder;

  std::optional<ExpandedCall> expanded_call(FunctionId function, const LocalValue& u) {
    switch (function) {
      case FunctionId::exp:
      case FunctionId::expm1:
        return exponential(function, u);
      case FunctionId::log:
        return logarithm(u.value, u.at, u.difference);
      case FunctionId::log1p:
        return logarithm(graph_.sum({one(), u.value}), sum({one(), u.at}), u.difference);
      case FunctionId::sin:
      case FunctionId::cos:
      case FunctionId::sinh:
      case FunctionId::cosh:
        return sinusoid(function, u);
      case FunctionId::tan:
      case FunctionId::tanh:
        return tangent(function, u);
      case FunctionId::atan:
        return arctangent(u);
      case FunctionId::asin:
      case FunctionId::acos:
      case FunctionId::atan2:
      case FunctionId::asinh:
      case FunctionId::hypot:
      case FunctionId::stumpff:
      case FunctionId::abs:
      case FunctionId::sign:
      case FunctionId::min:
      case FunctionId::max:
        break;
    }
    return std::nullopt;
  }

 private:
  ExpandedCall exponential(FunctionId function, const LocalValue& u) {
    const SignedNode d = u.difference;
    const SignedNode slope = call(FunctionId::exp, u.at);
    const SignedNode series = multiply(
        half(half(square(d))), graph_.call(FunctionId::stumpff, {half(d), graph_.rational(-3)}));
    const SignedNode excess = multiply(multiply(d, call(FunctionId::exp, half(d))),
                                       graph_.sum({series, -call(FunctionId::expm1, -half(d))}));
    return {call(function, u.at), slope, multiply(slope, call(FunctionId::expm1, d)),
            multiply(slope, excess)};
  }

  /// log(u) with c = u/u0.
  std::optional<ExpandedCall> logarithm(SignedNode u, SignedNode at, SignedNode difference) {
    if (graph_.is_zero(at.node)) return std::nullopt;
    const SignedNode less = divide(difference, at);
    const SignedNode logarithm = logarithm_near_one(graph_, {}, divide(u, at), less);
    return ExpandedCall{logarithm_at(at), divide(one(), at), logarithm,
                        -logarithm_remainder(graph_, {u, at, less}, logarithm)};
  }

  /// log(1/2) is -log(2), so that both cancel.
  SignedNode logarithm_at(SignedNode at) {
    const bool is_small =
        graph_.is_rational(at.node) && !at.is_negative && graph_.rational_of(at.node) < 1;
    return is_small ? -call(FunctionId::log, divide(one(), at)) : call(FunctionId::log, at);
  }

  /// The sine or cosine of a multiple of pi/2 is a number: cos(pi/2) = 0.
  SignedNode sinusoid_at(FunctionId function, SignedNode at) {
    const ScaledTerm term = split_term(at);
    const bool is_multiple_of_pi = term.factors.size() == 1 && term.factors[0].weight == 1 &&
                                   graph_.node(term.factors[0].node).kind == NodeKind::pi;
    const cln::cl_RA quarters = term.coefficient * 2;
    if (!is_circular(function) || !is_multiple_of_pi || cln::denominator(quarters) != 1)
      return call(function, at);
    const cln::cl_I count =
        cln::numerator(quarters) + cln::cl_I(function == FunctionId::cos ? 1 : 0);
    const long rest = cln::cl_I_to_long(cln::logand(count, 3));  // modulo 4
    if (rest % 2 == 0) return graph_.rational(0);
    return negate_if(one(), rest == 3);
  }

  /// f(u0 + D/2) of a sine or cosine. For a multiple u0 of pi/2 it is a sine or cosine of D/2,
  /// which has no rounding error of pi.
  SignedNode sinusoid_between(FunctionId function, const LocalValue& u) {
    const SignedNode sine_at = sinusoid_at(FunctionId::sin, u.at);
    const SignedNode cosine_at = sinusoid_at(FunctionId::cos, u.at);
    const bool is_quarter_turn = is_circular(function) && graph_.is_rational(sine_at.node) &&
                                 graph_.is_rational(cosine_at.node);
    if (!is_quarter_turn) return call(function, graph_.sum({u.at, half(u.difference)}));
    const SignedNode sine = call(FunctionId::sin, half(u.difference));
    const SignedNode cosine = call(FunctionId::cos, half(u.difference));
    if (function == FunctionId::sin)
      return graph_.sum({multiply(sine_at, cosine), multiply(cosine_at, sine)});
    return graph_.sum({multiply(cosine_at, cosine), -multiply(sine_at, sine)});
  }

  /// f(u0 + D) = f(u0) c(D) + f'(u0) s(D), with c = cos or cosh, and s = sin or sinh.
  ExpandedCall sinusoid(FunctionId function, const LocalValue& u) {
    const bool is_circular_call = is_circular(function);
    const FunctionId odd = is_circular_call ? FunctionId::sin : FunctionId::sinh;
    const FunctionId even = is_circular_call ? FunctionId::cos : FunctionId::cosh;
    const bool is_odd = function == odd;
    const SignedNode d = u.difference;
    const SignedNode at = sinusoid_at(function, u.at);
    const SignedNode other = sinusoid_at(is_odd ? even : odd, u.at);
    const SignedNode slope = negate_if(other, is_circular_call && !is_odd);
    const SignedNode sine = call(odd, half(d));
    const SignedNode middle = sinusoid_between(is_odd ? even : odd, u);
    const SignedNode difference =
        graph_.is_zero(u.at.node) && is_odd
            ? call(odd, d)
            : multiply_by_two(multiply(negate_if(middle, is_circular_call && !is_odd), sine));
    const SignedNode order = graph_.rational(is_circular_call ? 3 : -3);
    const SignedNode series =
        graph_.product({{d, 3}, {graph_.call(FunctionId::stumpff, {d, order}), 1}});
    const SignedNode excess =
        graph_.sum({multiply(multiply_by_two(at), negate_if(square(sine), is_circular_call)),
                    multiply(slope, negate_if(series, is_circular_call))});
    return {at, slope, difference, excess};
  }

  /// atan(u) - atan(u0) = atan2(D, 1 + u u0) for all u, because both cosines are positive. The
  /// remainder is unknown.
  ExpandedCall arctangent(const LocalValue& u) {
    const SignedNode difference = graph_.call(
        FunctionId::atan2, {u.difference, graph_.sum({one(), multiply(u.value, u.at)})});
    const SignedNode slope = divide(one(), sum({one(), square(u.at)}));
    return {call(FunctionId::atan, u.at), slope, difference, std::nullopt};
  }

  /// tan(D) - D = D^3 (stumpff(D, 2) - stumpff(D, 3))/cos(D), only for u0 = 0. tanh is treated
  /// alike.
  std::optional<ExpandedCall> tangent(FunctionId function, const LocalValue& u) {
    if (!graph_.is_zero(u.at.node)) return std::nullopt;
    const bool is_circular_call = function == FunctionId::tan;
    const int sign = is_circular_call ? 1 : -1;
    const SignedNode d = u.difference;
    const SignedNode cosine = call(is_circular_call ? FunctionId::cos : FunctionId::cosh, d);
    const SignedNode second = graph_.call(FunctionId::stumpff, {d, graph_.rational(2 * sign)});
    const SignedNode third = graph_.call(FunctionId::stumpff, {d, graph_.rational(3 * sign)});
    const SignedNode excess =
        graph_.product({{d, 3}, {graph_.sum({second, -third}), 1}, {cosine, -1}});
    return ExpandedCall{graph_.rational(0), one(), call(function, d),
                        negate_if(excess, !is_circular_call)};
  }
};

/// Square roots of values at a place.
class RootBuilder : GraphTermBuilder {
 public:
  RootBuilder(Graph& graph, const LeafNames& leaves) : GraphTermBuilder(graph), leaves_(leaves) {}

  SignedNode root_of(SignedNode radicand) {
    const bool is_sum = graph_.node(radicand.node).kind == NodeKind::sum;
    std::vector<SignedNode> roots;
    for (const SignedNode term : is_sum ? terms_of(radicand.node) : std::vector{radicand}) {
      const auto root = exact_root(split_term(negate_if(term, is_sum && radicand.is_negative)), 2);
      if (root) roots.push_back(*root);
    }
    const SignedNode root = graph_.sum(roots);
    const bool is_square = expanded_sum({multiply(root, root)}) == expanded_sum({radicand});
    return is_square && is_positive(root) ? root : graph_.square_root(radicand);
  }

 private:
  /// True for sums and products of positive parameters and numbers.
  [[nodiscard]] bool is_positive(SignedNode value) const {
    if (graph_.node(value.node).kind == NodeKind::sum)
      return std::ranges::all_of(terms_of(value.node), [&](SignedNode term) {
        return is_positive(negate_if(term, value.is_negative));
      });
    const ScaledTerm term = split_term(value);
    return cln::plusp(term.coefficient) &&
           std::ranges::all_of(term.factors, [this](const Operand& factor) {
             const Node& base = graph_.node(factor.node);
             if (base.kind == NodeKind::square_root || factor.weight % 2 == 0) return true;
             if (base.kind == NodeKind::sum) return is_positive({factor.node, false});
             return base.kind == NodeKind::leaf && base.leaf == Opcode::parameter &&
                    assumption_of(leaves_, base.index) != Assumption::none;
           });
  }

  const LeafNames& leaves_;
};

}  // namespace

SignedNode positive_root(Graph& graph, const LeafNames& leaves, SignedNode radicand) {
  return RootBuilder(graph, leaves).root_of(radicand);
}

std::optional<ExpandedCall> expanded_call(Graph& graph, FunctionId function, const LocalValue& u) {
  return CallExpander(graph).expanded_call(function, u);
}

}  // namespace elgen
