// Common-subexpression elimination: see network.hpp. A pair may lose users while it is queued, so
// the users are counted again when the pair leaves the queue.
#include <algorithm>
#include <optional>
#include <queue>
#include <unordered_map>

#include "program/network/network.hpp"

namespace elgen {
namespace {

/// Operands are paired only if their positions differ by at most this, so that the time is linear
/// in the number of operands.
constexpr std::size_t pairing_distance = 24;

struct OperandPair {
  OperationKind kind;
  bool is_opposite;  ///< a - b rather than a + b
  NodeId a;          ///< a <= b
  NodeId b;
  friend auto operator<=>(const OperandPair&, const OperandPair&) = default;
};

struct OperandPairHash {
  std::size_t operator()(const OperandPair& pair) const {
    const std::uint64_t operands = (std::uint64_t{pair.a} << 32U) | pair.b;
    const bool is_sum = pair.kind == OperationKind::sum;
    return (operands ^ (is_sum ? 2U : 0U) ^ (pair.is_opposite ? 1U : 0U)) * 0x9E3779B97F4A7C15U;
  }
};

struct CommonPair {
  std::size_t count;
  OperandPair pair;
  /// std::priority_queue pops the largest: the pair with most users, then the first pair.
  friend bool operator<(const CommonPair& x, const CommonPair& y) {
    return x.count != y.count ? x.count < y.count : y.pair < x.pair;
  }
};

bool is_n_ary(OperationKind kind) {
  return kind == OperationKind::sum || kind == OperationKind::product;
}

OperandPair pair_of(OperationKind kind, SignedNode x, SignedNode y) {
  return {kind, x.is_negative != y.is_negative, std::min(x.node, y.node), std::max(x.node, y.node)};
}

/// Indices of the pair's operands in an operation, the smaller first.
using OperandPositions = std::pair<std::size_t, std::size_t>;

std::optional<OperandPositions> find_pair(const Operation& operation, const OperandPair& pair) {
  const std::vector<SignedNode>& operands = operation.operands;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].node != pair.a && operands[i].node != pair.b) continue;
    for (std::size_t j = i + 1; j < operands.size(); ++j) {
      if (pair_of(operation.kind, operands[i], operands[j]) == pair) return OperandPositions{i, j};
    }
  }
  return std::nullopt;
}

class CommonPairElimination {
 public:
  explicit CommonPairElimination(Network& network) : network_(network) {}

  void eliminate_all() {
    for (NodeId id = 0; id < network_.operations.size(); ++id) register_pairs(id);
    for (const auto& [pair, users] : users_) {
      if (users.size() > 1) queue_.push({users.size(), pair});
    }
    while (!queue_.empty()) {
      const CommonPair candidate = queue_.top();
      queue_.pop();
      extract_if_common(candidate);
    }
  }

 private:
  void register_pairs(NodeId id) {
    const Operation& operation = network_.operations[id];
    if (!is_n_ary(operation.kind)) return;
    for (std::size_t i = 0; i < operation.operands.size(); ++i) {
      const std::size_t end = std::min(operation.operands.size(), i + 1 + pairing_distance);
      for (std::size_t j = i + 1; j < end; ++j) register_pair(id, i, j);
    }
  }

  void register_pair(NodeId id, std::size_t i, std::size_t j) {
    const Operation& operation = network_.operations[id];
    const OperandPair pair = pair_of(operation.kind, operation.operands[i], operation.operands[j]);
    std::vector<NodeId>& users = users_[pair];
    if (users.empty() || users.back() != id) users.push_back(id);
  }

  void extract_if_common(const CommonPair& candidate) {
    std::vector<NodeId>& users = users_[candidate.pair];
    std::sort(users.begin(), users.end());
    users.erase(std::unique(users.begin(), users.end()), users.end());
    std::erase_if(users,
                  [&](NodeId id) { return !find_pair(network_.operations[id], candidate.pair); });
    if (users.size() < 2) return;
    if (users.size() < candidate.count) {
      queue_.push({users.size(), candidate.pair});
      return;
    }
    extract_pair(candidate.pair, std::vector<NodeId>(users));
  }

  void extract_pair(const OperandPair& pair, const std::vector<NodeId>& users) {
    NodeId common = existing_operation(users);
    if (common == network_.operations.size()) {
      Operation operation{.kind = pair.kind};
      const Operation& user = network_.operations[users[0]];
      const auto [first, second] = *find_pair(user, pair);
      operation.operands = {{user.operands[first].node, false},
                            {user.operands[second].node, pair.is_opposite}};
      network_.operations.push_back(std::move(operation));
    }
    for (const NodeId user : users) {
      if (user != common) replace_pair(pair, user, common);
    }
  }

  /// A user whose only operands are the pair; the number of operations if no user has only these
  /// operands.
  NodeId existing_operation(const std::vector<NodeId>& users) const {
    for (const NodeId user : users) {
      if (network_.operations[user].operands.size() == 2) return user;
    }
    return static_cast<NodeId>(network_.operations.size());
  }

  void replace_pair(const OperandPair& pair, NodeId user, NodeId common) {
    Operation& operation = network_.operations[user];
    const SignedNode reference = network_.operations[common].operands[0];
    while (const std::optional<OperandPositions> positions = find_pair(operation, pair)) {
      const auto [first, second] = *positions;
      std::vector<SignedNode>& operands = operation.operands;
      const SignedNode same =
          operands[first].node == reference.node ? operands[first] : operands[second];
      operands[first] = {common, same.is_negative != reference.is_negative};
      operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(second));
      queue_new_pairs(user, first);
    }
  }

  /// Queues the pairs of the new operand with the remaining operands.
  void queue_new_pairs(NodeId user, std::size_t place) {
    const std::vector<SignedNode>& operands = network_.operations[user].operands;
    const std::size_t begin = place > pairing_distance ? place - pairing_distance : 0;
    const std::size_t end = std::min(operands.size(), place + 1 + pairing_distance);
    for (std::size_t other = begin; other < end; ++other) {
      if (other == place) continue;
      register_pair(user, std::min(place, other), std::max(place, other));
      const OperandPair pair =
          pair_of(network_.operations[user].kind, operands[place], operands[other]);
      const std::size_t count = users_[pair].size();
      if (count > 1) queue_.push({count, pair});
    }
  }

  Network& network_;
  std::unordered_map<OperandPair, std::vector<NodeId>, OperandPairHash> users_;
  std::priority_queue<CommonPair> queue_;
};

}  // namespace

void eliminate_common_subexpressions(Network& network) {
  CommonPairElimination(network).eliminate_all();
}

}  // namespace elgen
