// Reads one line at a time. A mistake is E912 with the span of its line.
#include "support/parse_program.hpp"

#include <fmt/core.h>

#include <charconv>

#include "support/graph_reader.hpp"

namespace elgen::test {
namespace {

using Words = std::vector<std::string_view>;

Words split(std::string_view line) {
  Words words;
  std::size_t at = 0;
  while ((at = line.find_first_not_of(' ', at)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::optional<std::uint32_t> number(std::string_view word) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

class ProgramReader {
 public:
  explicit ProgramReader(const SourceText& source) : source_(source) {}

  Result<Program> read() {
    for (std::uint32_t line = 1; line <= source_.line_starts.size(); ++line) {
      const std::string_view text = line_text(source_, line);
      const std::string problem = text.empty() ? "" : read_line(text);
      if (!problem.empty()) return Diagnostic{Code::E912, span(line, text), problem};
    }
    return std::move(program_);
  }

 private:
  Span span(std::uint32_t line, std::string_view text) const {
    const std::uint32_t begin = source_.line_starts[line - 1];
    return {&source_, begin, begin + static_cast<std::uint32_t>(text.size())};
  }

  std::string read_repetition(const Words& words) {
    const auto length = words.size() == 3 ? number(words[1]) : std::nullopt;
    const auto count = words.size() == 3 ? number(words[2]) : std::nullopt;
    if (!length || !count) return "a length and a count are expected";
    program_.functions.back().repeated = {*length, *count};
    return "";
  }

  /// Reads a line; returns "" or the error message.
  std::string read_line(std::string_view line) {
    const std::size_t comment = line.find(';');
    const Words words = split(line.substr(0, comment));
    if (words.empty()) return "";
    if (words[0] == "parameters") return read_names(words, LeafOwner::parameters);
    if (words[0] == "positive") return read_assumption(words, Assumption::positive);
    if (words[0] == "nonnegative") return read_assumption(words, Assumption::nonnegative);
    if (words[0] == "open_values") return read_names(words, LeafOwner::open_values);
    if (words[0] == "coordinates") return read_coordinates(words);
    if (words[0] == "velocities") return read_names(words, LeafOwner::velocities);
    if (words[0] == "inputs") return read_names(words, LeafOwner::inputs);
    if (words[0] == "function") return read_heading(words);
    if (words[0] == "time") {
      program_.leaves.uses_time = true;
      program_.leaves.t = "t";
      return "";
    }
    if (words[0] == "momenta") {
      program_.leaves.momenta = program_.leaves.v;
      return "";
    }
    if (words[0] == "step") {
      program_.leaves.h = "h";
      return "";
    }
    if (program_.functions.empty()) return fmt::format("`{}` outside of a function", words[0]);
    if (words[0] == "result") return read_result(words);
    if (words[0] == "repeated") return read_repetition(words);
    const Words name = split(comment == std::string_view::npos ? "" : line.substr(comment + 1));
    return read_instruction(words, name.empty() ? std::string_view() : name[0]);
  }

  std::string read_names(const Words& words, LeafOwner owner) {
    const auto assign = [&](const LeafRow& row, std::vector<std::string>& names) {
      if (row.owner != owner || row.argument_rule == ArgumentRule::if_used) return;
      names.assign(words.begin() + 1, words.end());
    };
    for_each_list(assign, program_.leaves);
    return "";
  }

  std::string read_assumption(const Words& words, Assumption assumption) {
    LeafNames& leaves = program_.leaves;
    leaves.assumptions.resize(leaves.parameters.size(), Assumption::none);
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto parameter = leaf_index(Opcode::parameter, words[i]);
      if (!parameter) return fmt::format("`{}` is no parameter", words[i]);
      leaves.assumptions[*parameter] = assumption;
    }
    return "";
  }

  /// Reads coordinates. Velocities get the same names unless a line for velocities follows.
  std::string read_coordinates(const Words& words) {
    read_names(words, LeafOwner::velocities);
    return read_names(words, LeafOwner::coordinates);
  }

  std::string read_heading(const Words& words) {
    const bool renamed = words.size() > 3 && words[2] == "=";
    if (words.size() != 2 && !renamed)
      return "expected `function NAME [= KIND [NUMBER [ITERATIONS] [order ORDER] [projected]]]`";
    Function function;
    function.name = std::string(words[1]);
    const OutputRow* kind = nullptr;
    for (const OutputRow& row : output_table()) {
      if (row.name == (renamed ? words[3] : words[1])) kind = &row;
    }
    if (kind == nullptr) return fmt::format("`{}` is no output", words[renamed ? 3 : 1]);
    function.kind = kind->kind;
    StepSpec step;
    std::uint32_t first = 0;
    std::uint32_t* const numbers[] = {&first, &step.iterations};
    step.projects = renamed && words.back() == "projected";
    const std::size_t end = words.size() - (step.projects ? 1 : 0);
    for (std::size_t i = 4; i < end; ++i) {
      const bool is_order = words[i] == "order" && i + 1 < end;
      if (is_order) ++i;
      const auto value = number(words[i]);
      if (!value) return fmt::format("`{}` is not a number", words[i]);
      if (is_order) step.composed_order = *value;
      if (!is_order && i < 6) *numbers[i - 4] = *value;
    }
    if (kind->is_step) {
      step.method = static_cast<StepMethod>(first);
      function.step = step;
    } else {
      function.user = first;
    }
    program_.functions.push_back(std::move(function));
    return "";
  }

  std::string read_result(const Words& words) {
    Field field;
    std::size_t at = 1;
    if (words.size() > 1 && !number(words[1])) field.name = std::string(words[at++]);
    if (words.size() < at + 3 || words[at + 2] != "=" || !number(words[at]) ||
        !number(words[at + 1])) {
      return "expected `result [NAME] ROWS COLUMNS = ENTRIES`";
    }
    field.rows = *number(words[at]);
    field.columns = *number(words[at + 1]);
    for (at += 3; at < words.size(); ++at) {
      const auto entry = number(words[at]);
      if (!entry) return fmt::format("`{}` is not a number", words[at]);
      field.entries.push_back(*entry);
    }
    program_.functions.back().fields.push_back(std::move(field));
    return "";
  }

  std::string read_instruction(const Words& words, std::string_view name) {
    Function& function = program_.functions.back();
    if (words.size() < 3 || number(words[0]) != function.instructions.size() || words[1] != "=") {
      return fmt::format("expected `{} = OPERATION …`", function.instructions.size());
    }
    Instruction instruction;
    if (!find_operation(words[2], instruction))
      return fmt::format("`{}` is no operation", words[2]);
    const Words operands(words.begin() + 3, words.end());
    if (!read_operands(operands, instruction)) {
      return fmt::format("`{}` has other operands", words[2]);
    }
    function.instructions.push_back(instruction);
    function.names.emplace_back(name);
    return "";
  }

  static bool find_operation(std::string_view word, Instruction& instruction) {
    for (const OpcodeRow& row : opcode_table) {
      // A call is written with the name of its function.
      if (row.name != word || row.id == Opcode::call) continue;
      instruction.opcode = row.id;
      return true;
    }
    const FunctionRow* row = find_function(word);
    if (row == nullptr) return false;
    instruction.opcode = Opcode::call;
    instruction.function = row->id;
    return true;
  }

  bool read_operands(const Words& words, Instruction& instruction) {
    const std::size_t operands = operand_count(instruction);
    if (operands == 0) return read_leaf(words, instruction);
    if (words.size() != operands) return false;
    const auto a = number(words[0]);
    const auto b = operands > 1 ? number(words[1]) : std::optional<std::uint32_t>(0);
    if (!a || !b) return false;
    instruction.a = *a;
    instruction.b = *b;
    return true;
  }

  bool read_leaf(const Words& words, Instruction& instruction) {
    if (is_leaf(instruction.opcode) && is_single(instruction.opcode)) return words.empty();
    if (words.size() != 1) return false;
    const auto index = is_leaf(instruction.opcode) ? leaf_index(instruction.opcode, words[0])
                                                   : constant_index(words[0]);
    if (!index) return false;
    instruction.a = *index;
    return true;
  }

  std::optional<std::uint32_t> leaf_index(Opcode kind, std::string_view name) {
    for (std::uint32_t i = 0; i < leaf_count(program_.leaves, kind); ++i) {
      if (leaf_of(program_.leaves, kind, i) == name) return i;
    }
    return std::nullopt;
  }

  std::optional<std::uint32_t> constant_index(std::string_view text) {
    const std::optional<Constant> constant = read_constant(std::string(text));
    if (!constant) return std::nullopt;
    return intern_constant(*constant, program_.constants);
  }

  const SourceText& source_;
  Program program_;
};

}  // namespace

Result<Program> parse_program(const SourcePointer& text) { return ProgramReader(*text).read(); }

}  // namespace elgen::test
