// temporary_names: names of instructions in equations and emitted code.
//
//     sin of a leaf, or of a sum of leaves       sin_theta, cos_q1_q2, sin_q1_minus_q2
//     an instruction that has a name             that name
//     an operation on few leaves                 m_l_cos_theta, M_plus_m (spelling.hpp)
//     a named intermediate of the derivation     moment_link5_y
//     an operation on few named values           m5_moment_link5_y
//     a part of a named value                    moment_link5_y_part, moment_link5_y_part_2
//     else                                       t_4f2a9: a hash of the computation
//
// The last five kinds of names are given only to values that are used twice, are too long to read,
// or are a sine or cosine whose counterpart is used, too. These names depend only on the value: if
// two values claim one name, or the name has another meaning, the values get hashes. A hash covers
// leaves, constants and operations, not positions, so that it survives changes elsewhere.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "elgen/program.hpp"
#include "program/network/spelling.hpp"

namespace elgen {
namespace {

/// Expressions with more operations are split, so that a line stays readable.
constexpr std::size_t longest_expression = 12;
constexpr std::size_t longest_name = 40;
/// The longest name that fits on a line of 100 columns.
constexpr std::size_t longest_temporary = 60;
constexpr int shortest_hash = 5;
/// Further parts get no number: a higher number tells less than a hash, and changes more often.
constexpr std::size_t most_parts = 9;

/// Names that emitted functions use, besides arguments and functions of the language; and keywords
/// and types that a spelling may produce, such as co_await for co*await.
constexpr std::array<std::string_view, 16> reserved_names{
    "sqrt",         "constant",     "result",           "parameters", "Scalar",  "std",
    "co_await",     "co_yield",     "co_return",        "wchar_t",    "char8_t", "char16_t",
    "thread_local", "dynamic_cast", "reinterpret_cast", "size_t"};

/// True for names without lower-case letters, such as "M_E" or "INT_MAX".
bool is_like_macro(const std::string& name) {
  return std::ranges::none_of(name, [](char c) { return c >= 'a' && c <= 'z'; });
}

/// The number of uses of each value. A negation is written at each of its uses, so the uses of a
/// negation count as uses of its operand.
std::vector<std::size_t> use_counts_of(const Function& function) {
  std::vector<std::size_t> uses(function.instructions.size(), 0);
  for (const std::uint32_t entry : entries_of(function)) ++uses[entry];
  for (std::size_t at = uses.size(); at-- > 0;) {
    const Instruction& i = function.instructions[at];
    if (operand_count(i) > 0) uses[i.a] += i.opcode == Opcode::negate ? uses[at] : 1;
    if (operand_count(i) > 1) ++uses[i.b];
  }
  return uses;
}

/// FNV-1a of the operation, the text of leaves and constants, and the hashes of operands.
std::vector<std::uint64_t> hashes_of(const Program& program, const Function& function) {
  std::vector<std::uint64_t> hashes;
  for (const Instruction& i : function.instructions) {
    std::string content =
        fmt::format("{} {} ", opcode_row(i.opcode).tag,
                    i.opcode == Opcode::call ? function_row(i.function).name : "");
    if (i.opcode == Opcode::constant) content += text_of(program.constants[i.a].form);
    const bool is_listed = is_leaf(i.opcode) && !is_single(i.opcode);
    if (is_listed) content += leaf_of(program.leaves, i.opcode, i.a);
    if (operand_count(i) > 0) content += fmt::format("{:x} ", hashes[i.a]);
    if (operand_count(i) > 1) content += fmt::format("{:x} ", hashes[i.b]);
    std::uint64_t value = 0xCBF29CE484222325U;
    for (const char c : content) {
      value = (value ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
    hashes.push_back(value);
  }
  return hashes;
}

/// The instructions of `wanted` that the expression of `whole` contains, without entering named
/// values; at most most_parts.
std::vector<std::size_t> part_indices(std::size_t whole, const Function& function,
                                      const std::vector<std::string>& names,
                                      const std::set<std::size_t>& wanted) {
  std::vector<std::size_t> parts;
  std::vector<std::size_t> pending = {whole};
  while (!pending.empty() && parts.size() < most_parts) {
    const std::size_t at = pending.back();
    const Instruction& i = function.instructions[at];
    pending.pop_back();
    const bool is_known = std::ranges::find(parts, at) != parts.end();
    if (is_known || (at != whole && !names[at].empty())) continue;
    if (wanted.contains(at)) parts.push_back(at);
    if (operand_count(i) > 1) pending.push_back(i.b);
    if (operand_count(i) > 0) pending.push_back(i.a);
  }
  return parts;
}

/// "moment_link5_y_part", "moment_link5_y_part_2", … for `wanted`. If a value has several such
/// names, the shortest is used; of equally short names, the alphabetically first.
std::vector<std::string> part_names(const Function& function, const std::vector<std::string>& names,
                                    const std::set<std::size_t>& wanted) {
  std::vector<std::string> result(names.size());
  for (std::size_t whole = 0; whole < names.size(); ++whole) {
    const std::string& own = names[whole].empty() ? function.names[whole] : names[whole];
    if (own.empty()) continue;
    const std::string stem = own.starts_with(intermediate_mark) ? own.substr(1) : own;
    int number = 0;
    for (const std::size_t at : part_indices(whole, function, names, wanted)) {
      std::string name = stem + "_part";
      if (++number > 1) name += fmt::format("_{}", number);
      std::string& known = result[at];
      const bool is_better = std::pair(name.size(), name) < std::pair(known.size(), known);
      if (known.empty() || is_better) known = std::move(name);
    }
  }
  return result;
}

std::set<std::string, std::less<>> reserved_identifiers(const Program& program) {
  std::set<std::string, std::less<>> used_names(reserved_names.begin(), reserved_names.end());
  for (const LeafRow& row : leaf_table()) {
    if (may_be_argument(program.leaves, row.id)) used_names.emplace(row.symbol);
  }
  for (const FunctionRow& row : function_table()) used_names.emplace(row.name);
  for_each_leaf([&](Opcode, std::uint32_t,
                    const std::string& leaf) { used_names.insert(identifier_of(leaf)); },
                program.leaves);
  return used_names;
}

bool is_trigonometric(const Instruction& i) {
  return i.opcode == Opcode::call && is_circular(i.function);
}

struct UsedIdentifiers {
  std::set<std::string, std::less<>> all;

  std::string reserve_unique(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 1; !all.insert(name).second; ++number) {
      name = number == 1 ? wanted + "_" : fmt::format("{}_{}", wanted, number);
    }
    return name;
  }

  std::string reserve_hash_name(std::uint64_t hash) {
    const std::string digits = fmt::format("{:016x}", hash);
    for (int length = shortest_hash; length < 16; ++length) {
      const std::string name = "t_" + digits.substr(0, static_cast<std::size_t>(length));
      if (all.insert(name).second) return name;
    }
    return reserve_unique("t_" + digits);
  }
};

class TemporaryNamer {
 public:
  TemporaryNamer(const Program& program, const Function& function)
      : program_(program),
        function_(function),
        used_names_{reserved_identifiers(program)},
        uses_(use_counts_of(function)),
        hashes_(hashes_of(program, function)) {
    find_angles();
    for (std::size_t at = 0; at < function.instructions.size(); ++at) {
      sums_.push_back(leaf_sum_name(at));
      own_.push_back(own_name(at));
      spellings_.push_back(spelling(at));
    }
  }

  std::vector<std::string> assign_names(FallbackName fallback) {
    const std::size_t count = function_.instructions.size();
    std::vector<std::string> names(count);
    std::vector<std::size_t> sizes(count, 0);
    std::vector<std::size_t> unnamed;
    for (std::size_t at = 0; at < count; ++at) {
      const Instruction& i = function_.instructions[at];
      if (operand_count(i) == 0) continue;
      sizes[at] = 1 + sizes[i.a] + (operand_count(i) > 1 ? sizes[i.b] : 0);
      const bool is_short = uses_[at] <= 1 && sizes[at] <= longest_expression;
      const bool is_written_out = is_short && !has_sine_and_cosine(i);
      if (i.opcode == Opcode::negate || (own_[at].empty() && is_written_out)) continue;
      if (own_[at].empty()) unnamed.push_back(at);
      if (!own_[at].empty()) names[at] = used_names_.reserve_unique(own_[at]);
      sizes[at] = 0;
    }
    for (const std::size_t at : unnamed) names[at] = spellings_[at].text;
    unnamed = reserve_unique_names(unnamed, names);
    const std::vector<std::string> parts =
        part_names(function_, names, {unnamed.begin(), unnamed.end()});
    for (const std::size_t at : unnamed) names[at] = parts[at];
    for (const std::size_t at : reserve_unique_names(unnamed, names)) {
      names[at] = fallback == FallbackName::hash ? used_names_.reserve_hash_name(hashes_[at])
                                                 : used_names_.reserve_unique("part");
    }
    return names;
  }

  std::vector<std::string> context_free_names() {
    std::vector<std::string> own = assign_names(FallbackName::hash);
    for (std::size_t at = 0; at < own.size(); ++at) {
      if (own_[at].empty()) own[at].clear();
    }
    return own;
  }

 private:
  void find_angles() {
    for (const Instruction& i : function_.instructions) {
      if (is_trigonometric(i)) angles_[i.a].insert(i.function);
    }
  }

  /// True if sine and cosine of the angle are used, so that one call computes both.
  bool has_sine_and_cosine(const Instruction& i) const {
    return is_trigonometric(i) && angles_.at(i.a).size() == 2;
  }

  std::string own_name(std::size_t at) const {
    const Instruction& i = function_.instructions[at];
    const std::string& name = function_.names[at];
    if (operand_count(i) == 0 || i.opcode == Opcode::negate) return "";
    return angle_name(i).value_or(name.starts_with(intermediate_mark) ? "" : name);
  }

  /// The spelling of a value. An operation on leaves is spelt out; any other named intermediate
  /// counts as a single name.
  OperandName spelling(std::size_t at) const {
    const Instruction& i = function_.instructions[at];
    if (i.opcode == Opcode::constant) return spell_name(program_.constants[i.a].form);
    if (is_leaf(i.opcode)) {
      const std::string leaf = identifier_of(leaf_of(program_.leaves, i.opcode, i.a));
      return {.text = fmt::format(fmt::runtime(leaf_row(i.opcode).identifier), leaf)};
    }
    if (!own_[at].empty() && !is_trigonometric(i))
      return {.text = own_[at], .has_intermediate = true};
    if (!own_[at].empty())
      return {own_[at], 1, false, OperandName::Begin::call, OperandName::End::call};
    OperandName made = spell_name(i, spellings_[i.a], spellings_[operand_count(i) > 1 ? i.b : i.a]);
    const bool is_marked = function_.names[at].starts_with(intermediate_mark);
    if (!is_marked || (!made.text.empty() && !made.has_intermediate)) return made;
    return {.text = function_.names[at].substr(1), .has_intermediate = true};
  }

  /// Reserves the names of `places`. Clears a name that two places claim or that has another
  /// meaning; returns the places with cleared names.
  std::vector<std::size_t> reserve_unique_names(const std::vector<std::size_t>& places,
                                                std::vector<std::string>& names) {
    std::map<std::string, int> claims;
    for (const std::size_t at : places) ++claims[names[at]];
    std::vector<std::size_t> left;
    for (const std::size_t at : places) {
      if (claims[names[at]] > 1 || is_used_name(names[at])) {
        names[at].clear();
        left.push_back(at);
      } else {
        used_names_.all.insert(names[at]);
      }
    }
    return left;
  }

  bool is_used_name(const std::string& name) const {
    const bool is_function =
        std::ranges::find(program_.functions, name, &Function::name) != program_.functions.end();
    return is_function || used_names_.all.contains(name) || is_like_macro(name) ||
           name.size() > longest_temporary || name.find("__") != std::string::npos;
  }

  /// "sin_theta", "cos_q1_minus_q2"; none if the argument is not a short sum of leaves.
  std::optional<std::string> angle_name(const Instruction& i) const {
    if (!is_trigonometric(i)) return std::nullopt;
    const std::optional<std::string>& argument = sums_[i.a];
    if (!argument) return std::nullopt;
    return fmt::format("{}_{}", function_row(i.function).name, *argument);
  }

  /// "q1_minus_q2", from the names of its operands.
  std::optional<std::string> leaf_sum_name(std::size_t at) const {
    const Instruction& i = function_.instructions[at];
    if (is_leaf(i.opcode)) return identifier_of(leaf_of(program_.leaves, i.opcode, i.a));
    if (i.opcode != Opcode::add && i.opcode != Opcode::subtract) return std::nullopt;
    const std::optional<std::string>& left = sums_[i.a];
    const std::optional<std::string>& right = sums_[i.b];
    if (!left || !right) return std::nullopt;
    const std::string name = *left + (i.opcode == Opcode::add ? "_" : "_minus_") + *right;
    return name.size() <= longest_name ? std::optional(name) : std::nullopt;
  }

  const Program& program_;
  const Function& function_;
  UsedIdentifiers used_names_;
  const std::vector<std::size_t> uses_;
  std::map<std::uint32_t, std::set<FunctionId>> angles_;  ///< functions called with each angle
  const std::vector<std::uint64_t> hashes_;
  std::vector<std::optional<std::string>> sums_;  ///< names of short sums of leaves
  std::vector<std::string> own_;                  ///< names of the first two kinds (head of file)
  std::vector<OperandName> spellings_;
};

}  // namespace

std::vector<std::string> temporary_names(const Program& program, const Function& function,
                                         FallbackName last) {
  return TemporaryNamer(program, function).assign_names(last);
}

std::vector<std::string> context_free_names(const Program& program, const Function& function) {
  return TemporaryNamer(program, function).context_free_names();
}

}  // namespace elgen
