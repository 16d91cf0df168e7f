// rounding_errors: see rounding_errors.hpp. Both ways are one function of two entries, so that what
// they share, sines above all, is evaluated once.
#include "rounding_errors.hpp"

#include <cln/integer.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.hpp"
#include "evaluate/dual.hpp"
#include "evaluate/exact_value.hpp"
#include "lower/linearise.hpp"

namespace elgen {
namespace {

/// Of three terms that are drawn alike each outweighs the others in a third of all points: that
/// none of 12 wide points shows it happens in one of 130 cases.
constexpr std::size_t point_count = 16;
constexpr int widest = 26;

Arguments<double> point(const LeafNames& leaves, int lowest, int highest, Random& random) {
  Arguments<double> result =
      draw_leaves(leaves, [&] { return random.log_uniform(lowest, highest); });
  for (double& value : result.parameters) value = std::abs(value);
  return result;
}

/// A multiple of a leaf by a power of two keeps its digits.
bool is_exact(const Graph& graph, NodeId id) {
  const Node& node = graph.node(id);
  if (node.kind != NodeKind::product) return node.kind == NodeKind::leaf;
  if (node.operands.size() != 2 || !graph.is_rational(node.operands[0].node)) return false;
  const cln::cl_RA& factor = graph.rational_of(node.operands[0].node);
  const cln::cl_I powers = cln::numerator(factor) * cln::denominator(factor);
  return node.operands[1].weight == 1 && cln::power2p(powers) > 0 &&
         is_exact(graph, node.operands[1].node);
}

using NodeSet = std::set<NodeId>;

/// Of every angle that is rounded before its sine or cosine is taken, the leaves in it: x - y and
/// 2 x - 2 y are rounded alike.
std::set<NodeSet> rounded_angles(const Graph& graph, Ref value) {
  std::set<NodeSet> angles;
  for (const NodeId id : reachable(graph, {value})) {
    const Node& node = graph.node(id);
    const bool is_wave = node.kind == NodeKind::call &&
                         (node.function == FunctionId::sin || node.function == FunctionId::cos);
    if (!is_wave || is_exact(graph, node.operands[0].node)) continue;
    NodeSet leaves;
    for (const NodeId part : reachable(graph, {{node.operands[0].node, false}})) {
      if (graph.node(part).kind == NodeKind::leaf) leaves.insert(part);
    }
    if (!leaves.empty()) angles.insert(std::move(leaves));
  }
  return angles;
}

/// Whether `way` takes sines of sums that the reference has taken apart: q1 - q2 is rounded, q1 and
/// q2 are not. Few points show it, where all else is small and the angles are large.
bool rounds_more_angles(const Expressions& way, const Expressions& reference) {
  Graph both;
  const Ref own = copied(both, way);
  const Ref known = copied(both, reference);
  const auto known_angles = rounded_angles(both, known);
  const auto is_known = [&known_angles](const NodeSet& angle) {
    return std::any_of(known_angles.begin(), known_angles.end(), [&angle](const NodeSet& other) {
      return std::includes(other.begin(), other.end(), angle.begin(), angle.end());
    });
  };
  const auto own_angles = rounded_angles(both, own);
  return !std::all_of(own_angles.begin(), own_angles.end(), is_known);
}

struct Comparison {
  Program program = {};  ///< the constants
  Function function = {};
};

Comparison comparison(const Expressions& way, const Expressions& reference) {
  Expressions both;
  both.values = {copied(both.graph, way), copied(both.graph, reference)};
  Comparison result;
  result.function.fields = {Field{"", 1, 2, {0, 1}}};
  linearise(make_network(both), result.program, result.function);
  return result;
}

/// Values and errors of a function's instructions at one point.
class RunningErrors {
 public:
  RunningErrors(const Comparison& compared, const Arguments<double>& point, Leaves leaves)
      : program_(compared.program), point_(point), leaves_(leaves) {
    for (const Instruction& i : compared.function.instructions) {
      values_.push_back(value(i));
      errors_.push_back(error(i, values_.back()));
    }
  }

  /// Undefined where the value is.
  [[nodiscard]] const Real& of(std::uint32_t instruction) const { return errors_[instruction]; }

  /// The error that may take the place of an instruction's.
  [[nodiscard]] Real admitted(std::uint32_t instruction) const {
    static const Real recounted(3);
    static const Real always(8);
    return max(errors_[instruction] * recounted, abs(values_[instruction]) * always);
  }

 private:
  [[nodiscard]] Real value(const Instruction& i) const {
    const bool is_leaf = operand_count(i) == 0 && i.opcode != Opcode::constant;
    if (!is_leaf) return interpreter::step(program_, i, {}, values_);
    return Real(exact_value(interpreter::step(program_, i, point_, {})));
  }

  [[nodiscard]] Real error(const Instruction& i, const Real& value) const {
    switch (i.opcode) {
      case Opcode::constant:
        return is_binary(value) ? Real() : abs(value);
      case Opcode::negate:
        return errors_[i.a];
      case Opcode::add:
      case Opcode::subtract:
        return errors_[i.a] + errors_[i.b] + abs(value);
      case Opcode::multiply:
        return product_error(i, value);
      case Opcode::divide:
        return (errors_[i.a] + abs(value) * errors_[i.b]) / abs(values_[i.b]) + abs(value);
      case Opcode::square_root:
        return errors_[i.a] / (value + value) + value;
      case Opcode::call:
        return call_error(i, value);
      default:
        return leaves_ == Leaves::rounded ? abs(value) : Real();
    }
  }

  [[nodiscard]] Real product_error(const Instruction& i, const Real& value) const {
    const bool is_scaled = is_power_of_two(values_[i.a]) || is_power_of_two(values_[i.b]);
    const Real rounding = is_scaled ? Real() : abs(value);
    return errors_[i.a] * abs(values_[i.b]) + errors_[i.b] * abs(values_[i.a]) + rounding;
  }

  /// Kinked functions pass an operand on.
  [[nodiscard]] Real call_error(const Instruction& i, const Real& value) const {
    const FunctionRow& row = function_row(i.function);
    const Real& second = row.arity == 2 ? errors_[i.b] : errors_[i.a];
    if (row.use == FunctionUse::forces) return max(errors_[i.a], second);
    Real result = abs(value) + slope(i, true) * errors_[i.a];
    if (row.arity == 2) result = result + slope(i, false) * second;
    return result;
  }

  /// Magnitude of the derivative by one argument.
  [[nodiscard]] Real slope(const Instruction& i, bool by_first) const {
    const Dual<Real> first{values_[i.a], Real(by_first ? 1 : 0)};
    const Dual<Real> second{values_[i.b], Real(by_first ? 0 : 1)};
    return abs(interpreter::call(i.function, first, second).slope);
  }

  /// What double holds.
  static bool is_binary(const Real& value) {
    const double rounded = ScalarTraits<double>::from_real(value.value());
    return cln::zerop(value.value() - Real(exact_value(rounded)).value());
  }

  static bool is_power_of_two(const Real& value) {
    if (!value.is_defined() || cln::zerop(value.value())) return false;
    return cln::abs(cln::decode_float(value.value()).mantissa) == cln::cl_RA(1) / 2;
  }

  const Program& program_;
  const Arguments<double>& point_;
  Leaves leaves_;
  std::vector<Real> values_ = {};
  std::vector<Real> errors_ = {};
};

}  // namespace

MixedPoints mixed_points(const LeafNames& leaves) {
  Random random(1);
  MixedPoints points;
  for (std::size_t i = 0; i < point_count; ++i) {
    const bool is_ordinary = i % 4 == 0;
    points.push_back(is_ordinary ? point(leaves, -3, 0, random)
                                 : point(leaves, -widest, widest, random));
  }
  return points;
}

bool is_as_precise(const Expressions& way, const Expressions& reference, const MixedPoints& points,
                   Leaves leaves) {
  if (leaves == Leaves::exact && rounds_more_angles(way, reference)) return false;
  const Comparison compared = comparison(way, reference);
  const std::vector<std::uint32_t>& entries = compared.function.fields[0].entries;
  bool is_compared = false;
  for (const Arguments<double>& point : points) {
    const RunningErrors errors(compared, point, leaves);
    const Real& own = errors.of(entries[0]);
    const Real admitted = errors.admitted(entries[1]);
    if (!admitted.is_defined()) continue;
    if (!own.is_defined() || own.value() > admitted.value()) return false;
    is_compared = true;
  }
  return is_compared;
}

}  // namespace elgen
