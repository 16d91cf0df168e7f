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

/// f of every leaf of one or more lists of the same lengths, in their order: what draws numbers
/// gives the same everywhere.
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

/// The list of a kind with many leaves; null of a kind with one.
template <class List, class One>
[[nodiscard]] const List* list_of(const PerLeaf<List, One>& leaves, Opcode kind) {
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

/// The leaf of this kind and number.
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

/// How many there are of a kind.
template <class T>
[[nodiscard]] std::size_t leaf_count(const LeafValues<T>& leaves, Opcode kind) {
  const std::vector<T>* const list = list_of(leaves, kind);
  return list != nullptr ? list->size() : 1;
}

/// Whether emitted functions may take the kind. A list of the kinds if_any and if_taken is passed
/// if it has entries. The only single leaf among them, h, always is: ask for its name instead.
template <class T>
[[nodiscard]] bool is_passed(const LeafValues<T>& leaves, Opcode kind) {
  const Passed passed = leaf_row(kind).passed;
  return passed == Passed::always || (passed != Passed::never && leaf_count(leaves, kind) > 0);
}

}  // namespace elgen
