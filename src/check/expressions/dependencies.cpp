// Dependencies: depth-first search over the named expressions, without recursion, because a chain
// of points is as deep as it is long.
#include "check/expressions/dependencies.hpp"

#include <algorithm>
#include <array>

namespace elgen {
namespace {

/// A named thing, numbered as below.
using Node = std::uint32_t;

/// What a leaf of the arena refers to: its index counts `parts` of each.
struct ReferenceRow {
  ExpressionKind kind;
  OwnerKind owner;
  std::uint32_t parts;
};

constexpr std::array reference_table{
    ReferenceRow{ExpressionKind::definition, OwnerKind::definition, 1},
    ReferenceRow{ExpressionKind::prescribed, OwnerKind::prescribed, 1},
    ReferenceRow{ExpressionKind::point_component, OwnerKind::point, 3},
    ReferenceRow{ExpressionKind::frame_component, OwnerKind::frame, components_per_frame}};

class DependencyGraph {
 public:
  explicit DependencyGraph(const Context& context) : context_(context) {
    const Model& model = context.model;
    add_named(OwnerKind::definition, model.definitions);
    add_named(OwnerKind::prescribed, model.prescribed);
    add_named(OwnerKind::point, model.points);
    add_named(OwnerKind::frame, model.frames);
    roots_.resize(named_.size());
    uses_.resize(named_.size());
    for (std::uint32_t i = 0; i < context.roots.size(); ++i) {
      add_root(i);
    }
  }

  [[nodiscard]] Node size() const { return static_cast<Node>(uses_.size()); }
  [[nodiscard]] const std::vector<Node>& uses(Node node) const { return uses_[node]; }
  [[nodiscard]] const std::vector<std::uint32_t>& roots(Node node) const { return roots_[node]; }
  [[nodiscard]] const std::string& name(Node node) const { return *named_[node].name; }
  [[nodiscard]] const Span& span(Node node) const { return *named_[node].span; }

 private:
  struct Named {
    const std::string* name;
    const Span* span;
  };

  template <class Rows>
  void add_named(OwnerKind kind, const Rows& rows) {
    first_[static_cast<std::size_t>(kind)] = static_cast<Node>(named_.size());
    for (const auto& row : rows) {
      named_.push_back({&row.name, &row.span});
    }
  }

  void add_root(std::uint32_t index) {
    const WrittenExpression& root = context_.roots[index];
    if (root.owner == OwnerKind::none) {
      return;
    }
    const Node user = node_of(root.owner, root.owner_index);
    roots_[user].push_back(index);
    for (ExpressionId id = root.first; id <= root.value; ++id) {
      add_use(user, context_.model.expressions[id]);
    }
  }

  void add_use(Node user, const Expression& node) {
    for (const auto& [kind, owner, parts] : reference_table) {
      if (node.kind == kind) {
        uses_[user].push_back(node_of(owner, node.index / parts));
      }
    }
  }

  [[nodiscard]] Node node_of(OwnerKind kind, std::uint32_t index) const {
    return first_[static_cast<std::size_t>(kind)] + index;
  }

  const Context& context_;
  std::array<Node, 5> first_ = {};  ///< by OwnerKind
  std::vector<Named> named_ = {};
  std::vector<std::vector<std::uint32_t>> roots_;
  std::vector<std::vector<Node>> uses_;
};

class DepthFirstSearch {
 public:
  explicit DepthFirstSearch(const DependencyGraph& graph)
      : graph_(graph), state_(graph.size(), State::fresh) {}

  /// False where a cycle was found; it is then in `cycle`.
  bool run() {
    for (Node node = 0; node < graph_.size(); ++node) {
      if (state_[node] == State::fresh && !run_from(node)) {
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] const std::vector<Node>& order() const { return order_; }
  [[nodiscard]] const std::vector<Node>& cycle() const { return cycle_; }

 private:
  enum class State : std::uint8_t { fresh, open, done };
  struct Visit {
    Node node;
    std::size_t next_use;
  };

  bool run_from(Node start) {
    open(start);
    while (!path_.empty()) {
      Visit& visit = path_.back();
      if (visit.next_use == graph_.uses(visit.node).size()) {
        close();
        continue;
      }
      const Node used = graph_.uses(visit.node)[visit.next_use++];
      if (state_[used] == State::open) {
        record_cycle(used);
        return false;
      }
      if (state_[used] == State::fresh) {
        open(used);
      }
    }
    return true;
  }

  void open(Node node) {
    state_[node] = State::open;
    path_.push_back({node, 0});
  }

  void close() {
    state_[path_.back().node] = State::done;
    order_.push_back(path_.back().node);
    path_.pop_back();
  }

  void record_cycle(Node from) {
    const auto begin = std::find_if(path_.begin(), path_.end(),
                                    [&](const Visit& visit) { return visit.node == from; });
    std::for_each(begin, path_.end(), [&](const Visit& visit) { cycle_.push_back(visit.node); });
  }

  const DependencyGraph& graph_;
  std::vector<State> state_;
  std::vector<Visit> path_;
  std::vector<Node> order_;
  std::vector<Node> cycle_;
};

/// Prints the cycle from the entry that stands first in the file.
void report_cycle(const DependencyGraph& graph, std::vector<Node> cycle, Report& report) {
  const auto earlier = [&](Node a, Node b) { return graph.span(a).begin < graph.span(b).begin; };
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end(), earlier), cycle.end());
  std::string text;
  for (const Node node : cycle) {
    text += graph.name(node) + " -> ";
  }
  text += graph.name(cycle.front());
  report.add(Code::E206, graph.span(cycle.front()),
             quoted(graph.name(cycle.front())) + " is defined by itself: " + text);
}

}  // namespace

std::optional<std::vector<std::uint32_t>> dependency_order(Context& context) {
  const DependencyGraph graph(context);
  DepthFirstSearch search(graph);
  if (!search.run()) {
    report_cycle(graph, search.cycle(), context.report);
    return std::nullopt;
  }
  std::vector<std::uint32_t> order;
  for (const Node node : search.order()) {
    order.insert(order.end(), graph.roots(node).begin(), graph.roots(node).end());
  }
  for (std::uint32_t i = 0; i < context.roots.size(); ++i) {
    if (context.roots[i].owner == OwnerKind::none) {
      order.push_back(i);
    }
  }
  return order;
}

}  // namespace elgen
