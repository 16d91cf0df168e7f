// flip_signs: see network.hpp. -x replaces x only if this saves an executed negation: of a result,
// or of an operand of a call or root.
#include <algorithm>

#include "program/network/network.hpp"

namespace elgen {
namespace {

struct UseCounts {
  std::uint32_t all = 0;
  std::uint32_t negative = 0;
  std::uint32_t costly = 0;  ///< negative uses that cost a negation
};

class SignFlipper {
 public:
  explicit SignFlipper(Network& network) : network_(network), uses_(network.operations.size()) {
    for (const Operation& operation : network.operations) {
      for (const SignedNode operand : operation.operands) {
        count_use(operand, operation.kind != OperationKind::sum);
      }
    }
    for (const SignedNode value : network.values) count_use(value, true);
  }

  void flip_all() {
    std::vector<bool> turned(network_.operations.size(), false);
    for (NodeId id = 0; id < turned.size(); ++id) {
      const UseCounts& uses = uses_[id];
      turned[id] = uses.costly > 0 && uses.negative == uses.all && try_flip(id);
    }
    for (Operation& operation : network_.operations) flip_references(operation.operands, turned);
    flip_references(network_.values, turned);
  }

 private:
  void count_use(SignedNode use, bool is_costly) {
    UseCounts& uses = uses_[use.node];
    ++uses.all;
    if (!use.is_negative) return;
    ++uses.negative;
    if (is_costly) ++uses.costly;
  }

  static void flip_references(std::vector<SignedNode>& references,
                              const std::vector<bool>& turned) {
    for (SignedNode& reference : references) {
      if (turned[reference.node]) reference.is_negative = !reference.is_negative;
    }
  }

  /// Negates the operation if that costs nothing: reverses a difference; in a product or quotient,
  /// negates an operand that has no other use. Returns false if negation would cost an operation.
  bool try_flip(NodeId id) {
    Operation& operation = network_.operations[id];
    std::vector<SignedNode>& operands = operation.operands;
    if (operation.kind == OperationKind::sum) {
      const bool is_difference = std::any_of(operands.begin(), operands.end(),
                                             [](SignedNode term) { return term.is_negative; });
      if (!is_difference) return false;
      for (SignedNode& term : operands) term.is_negative = !term.is_negative;
      return true;
    }
    if (operation.kind != OperationKind::product && operation.kind != OperationKind::quotient) {
      return false;
    }
    return std::any_of(operands.begin(), operands.end(), [&](SignedNode factor) {
      return uses_[factor.node].all == 1 && try_flip(factor.node);
    });
  }

  Network& network_;
  std::vector<UseCounts> uses_;
};

}  // namespace

void flip_signs(Network& network) { SignFlipper(network).flip_all(); }

}  // namespace elgen
