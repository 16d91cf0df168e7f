// leaves: the table of leaves: their notation, and their role in states and functions.
//
// opcodes.hpp explains the columns. The rank of every leaf is different; ranks 0, 1 and 4 are used
// for numbers, constants and computed values.
#include <array>

#include "elgen/opcodes.hpp"

namespace elgen {
namespace leaf_rows {
namespace {

using G = FactorGroup;
using U = LeafUnit;
using P = ArgumentRule;

constexpr std::string_view number = "std::common_type_t<Scalar>";
constexpr bool yes = true;
constexpr bool no = false;

// clang-format off
namespace written {
//                              symbol       type                     rank  text             identifier      latex             own_latex
constexpr LeafNotation parameter   {"p",         "Parameters<Scalar>",    2,    "{}",            "{}",           "s",              "s"};
constexpr LeafNotation open_value  {"f",         "OpenValues<Scalar>",    5,    "{}",            "{}",           "s",              "s"};
constexpr LeafNotation coordinate  {"q",         "Coordinates<Scalar>",   3,    "{}",            "{}",           "s",              "s"};
constexpr LeafNotation velocity    {"v",         "Velocities<Scalar>",    6,    "dot({})",       "{}_dot",       R"(\dot{s})",     "s"};
constexpr LeafNotation momentum    {"momenta",   "Momenta<Scalar>",       11,   "p({})",         "p_{}",         "p_{s}",          "p_{s}"};
constexpr LeafNotation reference   {"reference", "Velocities<Scalar>",    14,   "reference({})", "{}_reference", R"(\dot{s}_{r})", "s_{r}"};
constexpr LeafNotation acceleration{"a",         "Accelerations<Scalar>", 7,    "dot(dot({}))",  "{}_ddot",      R"(\ddot{s})",    R"(\dot{s})"};
constexpr LeafNotation multiplier  {"lambda",    "Multipliers<Scalar>",   13,   "lambda_{}",     "lambda_{}",    R"(\lambda_{s})", R"(\lambda_{s})"};
constexpr LeafNotation input       {"u",         "Inputs<Scalar>",        8,    "{}",            "{}",           "s",              "s"};
constexpr LeafNotation time        {"t",         number,                  9,    "{}",            "{}",           "s",              "s"};
constexpr LeafNotation step        {"h",         number,                  10,   "{}",            "{}",           "s",              "s"};
constexpr LeafNotation energy      {"E",         number,                  12,   "{}",            "{}",           "s",              "s"};
}  // namespace written

namespace used {
//                             group            unit                 argument_rule  is_zero_at_rest  is_settable
constexpr LeafUse parameter   {G::parameter,    U::entry_unit,       P::always,     no,              no};
constexpr LeafUse open_value  {G::function,     U::open_value_unit,  P::if_any,     no,              no};
constexpr LeafUse coordinate  {G::coordinate,   U::entry_unit,       P::always,     no,              no};
constexpr LeafUse velocity    {G::rate,         U::entry_unit,       P::always,     yes,             no};
constexpr LeafUse momentum    {G::rate,         U::joule_per_entry,  P::if_used,    yes,             yes};
constexpr LeafUse reference   {G::rate,         U::entry_unit,       P::if_used,    yes,             yes};
constexpr LeafUse acceleration{G::acceleration, U::entry_per_second, P::always,     yes,             yes};
constexpr LeafUse multiplier  {G::multiplier,   U::multiplier_unit,  P::never,      no,              no};
constexpr LeafUse input       {G::input,        U::entry_unit,       P::always,     yes,             no};
constexpr LeafUse time        {G::coordinate,   U::second,           P::always,     no,              yes};
constexpr LeafUse step        {G::coordinate,   U::second,           P::if_used,    no,              yes};
constexpr LeafUse energy      {G::coordinate,   U::joule,            P::never,      no,              no};
}  // namespace used
// clang-format on

constexpr std::array table{
#define ELGEN_LEAVES(kind, member, of, tag) \
  LeafRow{written::kind, used::kind, Opcode::kind, #member, LeafOwner::of},
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
