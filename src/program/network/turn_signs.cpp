// turn_signs: see network.hpp. A value is turned only if this saves an executed negation: at
// results, in calls and in roots.
#include <algorithm>

#include "program/network/network.hpp"

namespace elgen {
namespace {

struct Uses {
  std::uint32_t all = 0;
  std::uint32_t negative = 0;
  std::uint32_t negated = 0;  ///< negative uses that cost a negation
};

class SignTurner {
 public:
  explicit SignTurner(Network& network) : network_(network), uses_(network.operations.size()) {
    for (const Operation& operation : network.operations) {
      for (const Ref operand : operation.operands) {
        count(operand, operation.kind != OperationKind::sum);
      }
    }
    for (const Ref value : network.values) count(value, true);
  }

  void run() {
    std::vector<bool> turned(network_.operations.size(), false);
    for (NodeId id = 0; id < turned.size(); ++id) {
      const Uses& uses = uses_[id];
      turned[id] = uses.negated > 0 && uses.negative == uses.all && turn(id);
    }
    for (Operation& operation : network_.operations) turn_references(operation.operands, turned);
    turn_references(network_.values, turned);
  }

 private:
  void count(Ref use, bool is_costly) {
    Uses& uses = uses_[use.node];
    ++uses.all;
    if (!use.negative) return;
    ++uses.negative;
    if (is_costly) ++uses.negated;
  }

  static void turn_references(std::vector<Ref>& references, const std::vector<bool>& turned) {
    for (Ref& reference : references) {
      if (turned[reference.node]) reference.negative = !reference.negative;
    }
  }

  /// Negates the operation if that costs nothing: reverses a difference, or turns a factor of a
  /// product or quotient that has no other use. Otherwise returns false.
  bool turn(NodeId id) {
    Operation& operation = network_.operations[id];
    std::vector<Ref>& operands = operation.operands;
    if (operation.kind == OperationKind::sum) {
      const bool is_difference =
          std::any_of(operands.begin(), operands.end(), [](Ref term) { return term.negative; });
      if (!is_difference) return false;
      for (Ref& term : operands) term.negative = !term.negative;
      return true;
    }
    if (operation.kind != OperationKind::product && operation.kind != OperationKind::quotient) {
      return false;
    }
    return std::any_of(operands.begin(), operands.end(), [&](Ref factor) {
      return uses_[factor.node].all == 1 && turn(factor.node);
    });
  }

  Network& network_;
  std::vector<Uses> uses_;
};

}  // namespace

void turn_signs(Network& network) { SignTurner(network).run(); }

}  // namespace elgen
