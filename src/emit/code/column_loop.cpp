// column_loop: examines each operand that is computed before the loop. If all columns have the same
// operand, the loop body uses the name or expression of the operand; otherwise the body loads the
// operand of each column from the array `given`.
#include "emit/code/column_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace elgen {
namespace {

using InstructionNumbers = std::vector<std::uint32_t>;

/// Operand `slot` (0: a, 1: b) of instruction `at` and of its repetitions, one per column.
InstructionNumbers operands_by_column(const Function& function, std::uint32_t at,
                                      std::size_t slot) {
  InstructionNumbers all;
  for (std::size_t i = at; i < function.instructions.size(); i += function.repeated.length) {
    const Instruction& instruction = function.instructions[i];
    all.push_back(slot == 0 ? instruction.a : instruction.b);
  }
  return all;
}

bool are_equal(const InstructionNumbers& places) {
  return std::ranges::all_of(places, [&](std::uint32_t at) { return at == places.front(); });
}

void add_unique(InstructionNumbers& places, std::uint32_t at) {
  if (std::ranges::find(places, at) == places.end()) places.push_back(at);
}

/// "60 + ": the offset of a row in its array; "" for row 0.
std::string row_offset(std::size_t row, std::uint32_t count) {
  return row == 0 ? "" : fmt::format("{} + ", row * count);
}

class LoopBody {
 public:
  LoopBody(const Dialect& dialect, const Program& program, const Function& function,
           const ColumnLoop& loop, const std::vector<std::string>& names)
      : dialect_(dialect),
        function_(function),
        loop_(loop),
        outer_names_(names),
        words_(dialect.column_loop_texts(loop.count)),
        formulas_(program, body_, dialect, names_) {}

  std::string write_lines(const ColumnLoopNames& arrays) {
    std::string text = words_.opening;
    for (std::uint32_t at = loop_.first; at < loop_.first + function_.repeated.length; ++at) {
      const std::size_t row = row_of(loop_.stored_instructions, at);
      const bool is_stored = row < loop_.stored_instructions.size();
      std::string name = outer_names_[at];
      if (is_stored && name.empty()) name = fmt::format("solved_{}", row + 1);
      const std::uint32_t place = add_instruction(translate_instruction(at, arrays), name);
      body_indices_.push_back(place);
      if (name.empty()) continue;
      text += dialect_.loop_assignment(words_.value + name, formulas_.formula(place).text);
      if (!is_stored) continue;
      text += fmt::format(fmt::runtime(words_.store), arrays.solved, row_offset(row, loop_.count),
                          name);
    }
    return text + words_.closing;
  }

 private:
  static std::size_t row_of(const InstructionNumbers& rows, std::uint32_t at) {
    return static_cast<std::size_t>(std::ranges::find(rows, at) - rows.begin());
  }

  std::uint32_t add_instruction(const Instruction& instruction, std::string name) {
    body_.instructions.push_back(instruction);
    names_.push_back(std::move(name));
    return static_cast<std::uint32_t>(names_.size() - 1);
  }

  Instruction translate_instruction(std::uint32_t at, const ColumnLoopNames& arrays) {
    Instruction instruction = function_.instructions[at];
    const std::size_t count = operand_count(instruction);
    if (count > 0) instruction.a = translate_operand(at, 0, arrays);
    if (count > 1) instruction.b = translate_operand(at, 1, arrays);
    return instruction;
  }

  std::uint32_t translate_operand(std::uint32_t at, std::size_t slot,
                                  const ColumnLoopNames& arrays) {
    const InstructionNumbers all = operands_by_column(function_, at, slot);
    if (all.front() >= loop_.first) return body_indices_[all.front() - loop_.first];
    if (are_equal(all)) return add_shared_operand(all.front());
    const auto count = static_cast<std::ptrdiff_t>(loop_.count);
    auto row = loop_.varying_operands.begin();
    while (!std::equal(all.begin(), all.end(), row)) row += count;
    const auto start = static_cast<std::size_t>(row - loop_.varying_operands.begin());
    return add_instruction({}, fmt::format(fmt::runtime(words_.load), arrays.given,
                                           row_offset(start / loop_.count, loop_.count)));
  }

  /// Adds the operand `at`, which is the same in all columns, to `body_`: as a name, or as an
  /// expression if the operand has no name. Returns the index in `body_`.
  std::uint32_t add_shared_operand(std::uint32_t at) {
    const auto known = shared_.find(at);
    if (known != shared_.end()) return known->second;
    Instruction instruction = function_.instructions[at];
    const bool is_named = !outer_names_[at].empty();
    const std::size_t count = is_named ? 0 : operand_count(instruction);
    if (count > 0) instruction.a = add_shared_operand(instruction.a);
    if (count > 1) instruction.b = add_shared_operand(instruction.b);
    return shared_[at] = add_instruction(is_named ? Instruction{} : instruction, outer_names_[at]);
  }

  const Dialect& dialect_;
  const Function& function_;
  const ColumnLoop& loop_;
  const std::vector<std::string>& outer_names_;
  const ColumnLoopTexts words_;
  Function body_ = {};
  std::vector<std::string> names_ = {};  ///< of the instructions of `body_`
  /// Index in `body_` of each instruction of the first column.
  InstructionNumbers body_indices_ = {};
  std::map<std::uint32_t, std::uint32_t> shared_ = {};
  const FunctionFormulas formulas_;
};

}  // namespace

ColumnLoop column_loop(const Function& function) {
  ColumnLoop loop{.first = static_cast<std::uint32_t>(first_repeated_instruction(function)),
                  .count = function.repeated.count};
  std::set<InstructionNumbers> known;
  for (std::uint32_t at = loop.first; at < loop.first + function.repeated.length; ++at) {
    for (std::size_t slot = 0; slot < operand_count(function.instructions[at]); ++slot) {
      const InstructionNumbers all = operands_by_column(function, at, slot);
      if (all.front() >= loop.first || !known.insert(all).second) continue;
      if (are_equal(all)) {
        loop.invariant_operands.push_back(all.front());
      } else {
        loop.varying_operands.insert(loop.varying_operands.end(), all.begin(), all.end());
      }
    }
  }
  for (const std::uint32_t entry : entries_of(function)) {
    if (entry < loop.first) continue;
    add_unique(loop.stored_instructions,
               loop.first + (entry - loop.first) % function.repeated.length);
  }
  return loop;
}

std::optional<std::size_t> solved_index(const ColumnLoop& loop, const Function& function,
                                        std::uint32_t at) {
  const std::uint32_t length = function.repeated.length;
  const std::uint32_t inside = at - loop.first;
  const auto row = std::ranges::find(loop.stored_instructions, loop.first + inside % length);
  if (row == loop.stored_instructions.end()) return std::nullopt;
  const auto stored = static_cast<std::size_t>(row - loop.stored_instructions.begin());
  return stored * loop.count + inside / length;
}

std::string column_loop_text(const Dialect& dialect, const Program& program,
                             const Function& function, const ColumnLoop& loop,
                             const ColumnLoopNames& names) {
  return LoopBody(dialect, program, function, loop, names.values).write_lines(names);
}

}  // namespace elgen
