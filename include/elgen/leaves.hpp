// Leaves: the variables and parameters of the equations of a system, by kind.
#pragma once

#include <utility>
#include <vector>

#include "elgen/opcodes.hpp"

namespace elgen {

/// One member for each kind of leaf: a List, or a One if a system has exactly one leaf of the kind.
template <class List, class One>
struct LeafMembers {
#define ELGEN_LEAVES(kind, member, ...) List member = {};
#define ELGEN_LEAF(kind, member, ...) One member = {};
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
};

/// One T per leaf.
template <class T>
using LeafValues = LeafMembers<std::vector<T>, T>;

/// The result of f(leaf, ...) for every leaf of one or more LeafValues of equal sizes. f is called
/// in a fixed order, so that random draws in f are the same on every machine.
template <class F, class First, class... Others>
[[nodiscard]] auto map_leaves(const F& f, const LeafValues<First>& first,
                              const LeafValues<Others>&... others) {
  LeafValues<decltype(f(first.t, others.t...))> result;
#define ELGEN_LEAVES(kind, member, ...)                               \
  result.member.reserve(first.member.size());                         \
  for (std::size_t i = 0; i < first.member.size(); ++i) {             \
    result.member.push_back(f(first.member[i], others.member[i]...)); \
  }
#define ELGEN_LEAF(kind, member, ...) result.member = f(first.member, others.member...);
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  return result;
}

/// Calls f(kind, number, leaf, ...) for every leaf of one or more LeafValues of equal sizes.
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

/// Calls f(leaf_row(kind), list) for every kind that has a list of leaves.
template <class F, class Leaves>
void for_each_list(const F& f, Leaves&& leaves) {
#define ELGEN_LEAVES(kind, member, ...) f(leaf_row(Opcode::kind), leaves.member);
#define ELGEN_LEAF(kind, member, ...)
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
}

/// The list of leaves of a kind; null if the kind has a single leaf.
template <class List, class One>
[[nodiscard]] const List* leaf_list(const LeafMembers<List, One>& leaves, Opcode kind) {
  switch (leaf_kind(kind)) {
#define ELGEN_LEAVES(kind, member, ...) \
  case LeafKind::kind:                  \
    return &leaves.member;
#define ELGEN_LEAF(kind, member, ...) \
  case LeafKind::kind:                \
    break;
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  }
  return nullptr;
}

/// The entry of `leaves` for leaf `number` of this kind; for a single leaf, `number` is ignored.
template <class T>
[[nodiscard]] const T& leaf_of(const LeafValues<T>& leaves, Opcode kind, std::uint32_t number) {
  switch (leaf_kind(kind)) {
#define ELGEN_LEAVES(kind, member, ...) \
  case LeafKind::kind:                  \
    return leaves.member[number];
#define ELGEN_LEAF(kind, member, ...) \
  case LeafKind::kind:                \
    return leaves.member;
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
#undef ELGEN_LEAF
  }
  return leaves.t;
}

/// The number of leaves of a kind; 1 for a kind with a single leaf.
template <class T>
[[nodiscard]] std::size_t leaf_count(const LeafValues<T>& leaves, Opcode kind) {
  const std::vector<T>* const list = leaf_list(leaves, kind);
  return list != nullptr ? list->size() : 1;
}

/// True if emitted functions may take leaves of this kind. For the rules if_any and if_used: true
/// if `leaves` has a leaf of this kind. This includes h, even if h has no name and no function
/// takes it.
template <class T>
[[nodiscard]] bool may_be_argument(const LeafValues<T>& leaves, Opcode kind) {
  const ArgumentRule passed = leaf_row(kind).argument_rule;
  return passed == ArgumentRule::always ||
         (passed != ArgumentRule::never && leaf_count(leaves, kind) > 0);
}

}  // namespace elgen
