// The table of leaves: how each is written.
//
// No two ranks are alike; numbers have 0, constants 1, and what is computed 4. Patterns have holes
// for the name of the entry, text in models, identifier in dumps; in LaTeX s is its symbol.
#include <array>

#include "elgen/opcodes.hpp"

namespace elgen {
namespace leaf_rows {
namespace {

using Row = LeafRow;

constexpr std::string_view number = "std::common_type_t<Scalar>";

// clang-format off
constexpr Row parameter{"p", "Parameters<Scalar>", 2, "{}", "{}", "s", "s"};
constexpr Row open_value{"f", "OpenValues<Scalar>", 5, "{}", "{}", "s", "s"};
constexpr Row coordinate{"q", "Coordinates<Scalar>", 3, "{}", "{}", "s", "s"};
constexpr Row velocity{"v", "Velocities<Scalar>", 6, "dot({})", "{}_dot",
                       R"(\dot{s})", "s"};
constexpr Row momentum{"momenta", "Momenta<Scalar>", 11, "p({})", "p_{}",
                       "p_{s}", "p_{s}"};
constexpr Row reference{"reference", "Velocities<Scalar>", 14, "reference({})", "{}_reference",
                        R"(\dot{s}_{r})", "s_{r}"};
constexpr Row acceleration{"a", "Accelerations<Scalar>", 7, "dot(dot({}))", "{}_ddot",
                           R"(\ddot{s})", R"(\dot{s})"};
constexpr Row multiplier{"lambda", "Multipliers<Scalar>", 13, "lambda_{}", "lambda_{}",
                         R"(\lambda_{s})", R"(\lambda_{s})"};
constexpr Row input{"u", "Inputs<Scalar>", 8, "{}", "{}", "s", "s"};
constexpr Row time{"t", number, 9, "{}", "{}", "s", "s"};
constexpr Row step{"h", number, 10, "{}", "{}", "s", "s"};
constexpr Row energy{"E", number, 12, "{}", "{}", "s", "s"};
// clang-format on

constexpr Row named(Opcode id, std::string_view member, LeafOwner of, Row row) {
  row.id = id;
  row.member = member;
  row.of = of;
  return row;
}

constexpr std::array table{
#define ELGEN_LEAVES(kind, member, of, tag) named(Opcode::kind, #member, LeafOwner::of, kind),
#include "elgen/leaves.def"
#undef ELGEN_LEAVES
};

}  // namespace
}  // namespace leaf_rows

std::span<const LeafRow> leaf_table() { return leaf_rows::table; }

const LeafRow& leaf_row(Opcode leaf) {
  return leaf_rows::table[static_cast<std::size_t>(leaf_kind(leaf))];
}

}  // namespace elgen
