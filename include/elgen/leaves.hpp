// Leaves: what the equations of a system depend on, one thing per kind.
#pragma once

#include <utility>
#include <vector>

#include "elgen/opcodes.hpp"

namespace elgen {

/// One thing per kind of leaf: a list where there are many of the kind.
template <class List, class One>
struct PerLeaf {
#define ELGEN_LEAVES(kind, member, ...) List member = {};
#define ELGEN_LEAF(kind, member, ...) One member = {};
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
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
#define ELGEN_LEAVES(kind, member, ...) result.member = lists(each.member...);
#define ELGEN_LEAF(kind, member, ...) result.member = one(each.member...);
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
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

/// f(kind, number, leaf, ...) of every leaf of one or more lists of the same lengths.
template <class F, class First, class... Others>
void for_each_leaf(const F& f, First&& first, Others&&... others) {
#define ELGEN_LEAVES(kind, member, ...)                       \
  for (std::uint32_t i = 0; i < first.member.size(); ++i) {   \
    f(Opcode::kind, i, first.member[i], others.member[i]...); \
  }
#define ELGEN_LEAF(kind, member, ...) \
  f(Opcode::kind, std::uint32_t{0}, first.member, others.member...);
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
}

/// f(row, list) of every kind with many leaves.
template <class F, class Leaves>
void for_each_list(const F& f, Leaves&& leaves) {
#define ELGEN_LEAVES(kind, member, ...) f(leaf_row(Opcode::kind), leaves.member);
#define ELGEN_LEAF(kind, member, ...)
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
}

/// What there is of a kind with many leaves; null of time.
template <class List, class One>
[[nodiscard]] const List* list_of(const PerLeaf<List, One>& leaves, Opcode kind) {
  switch (kind) {
#define ELGEN_LEAVES(kind, member, ...) \
  case Opcode::kind:                    \
    return &leaves.member;
#define ELGEN_LEAF(kind, member, ...)
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
    default:
      return nullptr;
  }
}

/// The leaf of this kind and number.
template <class T>
[[nodiscard]] const T& leaf_of(const LeafValues<T>& leaves, Opcode kind, std::uint32_t number) {
  const std::vector<T>* const list = list_of(leaves, kind);
  return list != nullptr ? (*list)[number] : leaves.t;
}

/// How many there are of a kind.
template <class T>
[[nodiscard]] std::size_t leaf_count(const LeafValues<T>& leaves, Opcode kind) {
  const std::vector<T>* const list = list_of(leaves, kind);
  return list != nullptr ? list->size() : 1;
}

}  // namespace elgen
