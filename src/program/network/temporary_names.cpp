// temporary_names: what instructions are called in equations and emitted code.
//
//     sin of a leaf, or of a sum of leaves       sin_theta, cos_q1_q2, sin_q1_minus_q2
//     an instruction that has a name             that name
//     a sum of leaves used more than once        sum_q1_q2
//     used more than once, too long to read,     t_4f2a9: a hash of what it computes
//     or beside the cosine (sine) of its angle
//
// The hash covers leaves, constants and operations, not positions, so a change elsewhere leaves it
// alone. told_names leaves it out.
#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "elgen/program.hpp"

namespace elgen {
namespace {

/// Longer expressions are broken up, so that a line stays readable.
constexpr std::size_t longest_expression = 12;
constexpr std::size_t longest_name = 40;
constexpr int shortest_hash = 5;

/// Names the emitted functions use themselves, beside arguments and functions of the language.
constexpr std::array<std::string_view, 6> reserved_names{"sqrt",       "constant", "result",
                                                         "parameters", "Scalar",   "std"};

class Naming {
 public:
  Naming(const Program& program, const Function& function)
      : program_(program), function_(function) {
    for (const std::string_view name : reserved_names) taken_.emplace(name);
    for (const LeafRow& row : leaf_table()) {
      if (is_passed(program.leaves, row.id)) taken_.emplace(row.symbol);
    }
    for (const FunctionRow& row : function_table()) taken_.emplace(row.name);
    for_each_leaf([this](Opcode, std::uint32_t,
                         const std::string& leaf) { taken_.insert(identifier_of(leaf)); },
                  program.leaves);
    count_uses();
    find_angles();
    for (std::size_t at = 0; at < function.instructions.size(); ++at) {
      hash(at);
      sums_.push_back(leaf_sum(at));
    }
  }

  std::vector<std::string> names() {
    const std::size_t count = function_.instructions.size();
    std::vector<std::string> names(count);
    std::vector<std::size_t> sizes(count, 0);
    for (std::size_t at = 0; at < count; ++at) {
      const Instruction& i = function_.instructions[at];
      if (operand_count(i) == 0) continue;
      sizes[at] = 1 + sizes[i.a] + (operand_count(i) > 1 ? sizes[i.b] : 0);
      names[at] = name(at, sizes[at]);
      if (!names[at].empty()) sizes[at] = 0;
    }
    return names;
  }

  std::vector<std::string> told_names() {
    std::vector<std::string> told = names();
    for (const std::size_t at : hashed_) told[at].clear();
    return told;
  }

 private:
  /// A negation is written out wherever it is used, so its uses are its operand's.
  void count_uses() {
    uses_.resize(function_.instructions.size(), 0);
    for (const Field& field : function_.fields) {
      for (const std::uint32_t entry : field.entries) ++uses_[entry];
    }
    for (std::size_t at = uses_.size(); at-- > 0;) {
      const Instruction& i = function_.instructions[at];
      if (operand_count(i) > 0) uses_[i.a] += i.opcode == Opcode::negate ? uses_[at] : 1;
      if (operand_count(i) > 1) ++uses_[i.b];
    }
  }

  void find_angles() {
    for (const Instruction& i : function_.instructions) {
      if (is_trigonometric(i)) angles_[i.a].insert(i.function);
    }
  }

  static bool is_trigonometric(const Instruction& i) {
    return i.opcode == Opcode::call && is_circular(i.function);
  }

  /// One call computes both.
  bool has_sine_and_cosine(const Instruction& i) const {
    return is_trigonometric(i) && angles_.at(i.a).size() == 2;
  }

  std::string name(std::size_t at, std::size_t size) {
    const Instruction& i = function_.instructions[at];
    if (i.opcode == Opcode::negate) return "";
    if (const auto angle = angle_name(i)) return unique(*angle);
    if (!function_.names[at].empty()) return unique(function_.names[at]);
    const bool is_short = uses_[at] <= 1 && size <= longest_expression;
    if (is_short && !has_sine_and_cosine(i)) return "";
    if (sums_[at]) return unique("sum_" + *sums_[at]);
    hashed_.push_back(at);
    return hash_name(hashes_[at]);
  }

  /// "sin_theta", "cos_q1_minus_q2"; nothing where the argument is no short sum of
  /// leaves.
  std::optional<std::string> angle_name(const Instruction& i) const {
    if (!is_trigonometric(i)) return std::nullopt;
    const std::optional<std::string>& argument = sums_[i.a];
    if (!argument) return std::nullopt;
    return fmt::format("{}_{}", function_row(i.function).name, *argument);
  }

  /// "q1_minus_q2", from those of its operands.
  std::optional<std::string> leaf_sum(std::size_t at) const {
    const Instruction& i = function_.instructions[at];
    if (is_leaf(i.opcode)) return identifier_of(leaf_of(program_.leaves, i.opcode, i.a));
    if (i.opcode != Opcode::add && i.opcode != Opcode::subtract) return std::nullopt;
    const std::optional<std::string>& left = sums_[i.a];
    const std::optional<std::string>& right = sums_[i.b];
    if (!left || !right) return std::nullopt;
    const std::string name = *left + (i.opcode == Opcode::add ? "_" : "_minus_") + *right;
    return name.size() <= longest_name ? std::optional(name) : std::nullopt;
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int number = 1; !taken_.insert(name).second; ++number) {
      name = number == 1 ? wanted + "_" : fmt::format("{}_{}", wanted, number);
    }
    return name;
  }

  std::string hash_name(std::uint64_t hash) {
    const std::string digits = fmt::format("{:016x}", hash);
    for (int length = shortest_hash; length < 16; ++length) {
      const std::string name = "t_" + digits.substr(0, static_cast<std::size_t>(length));
      if (taken_.insert(name).second) return name;
    }
    return unique("t_" + digits);
  }

  /// FNV-1a over the operation, the spelling of leaves and constants, and the hashes of operands.
  void hash(std::size_t at) {
    const Instruction& i = function_.instructions[at];
    std::string content =
        fmt::format("{} {} ", opcode_row(i.opcode).tag,
                    i.opcode == Opcode::call ? function_row(i.function).name : "");
    if (i.opcode == Opcode::constant) content += text_of(program_.constants[i.a].form);
    const bool is_listed = is_leaf(i.opcode) && !is_single(i.opcode);
    if (is_listed) content += leaf_of(program_.leaves, i.opcode, i.a);
    if (operand_count(i) > 0) content += fmt::format("{:x} ", hashes_[i.a]);
    if (operand_count(i) > 1) content += fmt::format("{:x} ", hashes_[i.b]);
    std::uint64_t value = 0xCBF29CE484222325U;
    for (const char c : content) {
      value = (value ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
    hashes_.push_back(value);
  }

  const Program& program_;
  const Function& function_;
  std::set<std::string, std::less<>> taken_;
  std::vector<std::size_t> uses_;
  std::map<std::uint32_t, std::set<FunctionId>> angles_;  ///< the functions called with each
  std::vector<std::uint64_t> hashes_;
  std::vector<std::size_t> hashed_;               ///< instructions that are called by their hash
  std::vector<std::optional<std::string>> sums_;  ///< names of short sums of leaves
};

}  // namespace

std::vector<std::string> temporary_names(const Program& program, const Function& function) {
  return Naming(program, function).names();
}

std::vector<std::string> told_names(const Program& program, const Function& function) {
  return Naming(program, function).told_names();
}

}  // namespace elgen
