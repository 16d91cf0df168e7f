// Leaves: what the equations of a system depend on, one thing per kind.
#pragma once

#include <utility>
#include <vector>

namespace elgen {

/// One thing per kind of leaf: a list where there are many of the kind.
template <class List, class One>
struct PerLeaf {
  List parameters = {};
  List q = {};
  List v = {};
  List a = {};  ///< dv/dt
  List u = {};
  One t = {};
};

/// A T for every leaf.
template <class T>
using LeafValues = PerLeaf<std::vector<T>, T>;

/// list(kind) of every kind with many leaves, one(time) of time; `each` are leaves of any type.
template <class Lists, class Ones, class... Leaves>
[[nodiscard]] auto map_kinds(const Lists& lists, const Ones& one, const Leaves&... each) {
  using List = decltype(lists(each.parameters...));
  using One = decltype(one(each.t...));
  // In this order: what draws numbers gives the same everywhere.
  PerLeaf<List, One> result;
  result.parameters = lists(each.parameters...);
  result.q = lists(each.q...);
  result.v = lists(each.v...);
  result.a = lists(each.a...);
  result.u = lists(each.u...);
  result.t = one(each.t...);
  return result;
}

/// f of every leaf of one or more lists of the same lengths.
template <class F, class First, class... Others>
[[nodiscard]] auto map_leaves(const F& f, const LeafValues<First>& first,
                              const LeafValues<Others>&... others) {
  const auto list = [&f](const std::vector<First>& values, const std::vector<Others>&... more) {
    std::vector<decltype(f(values[0], more[0]...))> result;
    result.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) result.push_back(f(values[i], more[i]...));
    return result;
  };
  return map_kinds(list, f, first, others...);
}

}  // namespace elgen
