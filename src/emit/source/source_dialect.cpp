// source_dialect: a function has a single body, which computes in doubles of the interpreter. A
// matrix is a list of its rows.
#include "emit/source/source_dialect.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "base/ascii.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/step_methods.hpp"
#include "emit/code/column_loop.hpp"
#include "emit/code/local_names.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/source/exact_numbers.hpp"
#include "emit/text/layout.hpp"
#include "numbers/scalar_literal.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

std::string fill_spelling(std::string_view pattern, std::string_view name,
                          std::string_view more = {}) {
  return fmt::format(fmt::runtime(pattern), name, more);
}

/// `present`: the value is already in brackets. `needed`: a value on several lines gets brackets,
/// because lines may break only inside brackets.
enum class BracketNeed : std::uint8_t { present, needed };

std::string statement_text(const SourceSpelling& spelling, const std::string& start,
                           const std::string& value, BracketNeed brackets) {
  const std::string margin(spelling.indent, ' ');
  const std::string end(spelling.end);
  if (margin.size() + start.size() + value.size() + end.size() <= line_width) {
    return fmt::format("{}{}{}{}\n", margin, start, value, end);
  }
  const bool is_needed = brackets == BracketNeed::needed;
  const std::string text =
      fmt::format("{}{}{}{}{}{}", margin, start, is_needed ? spelling.opening : "", value,
                  is_needed ? spelling.closing : "", end);
  return wrap_source_statement(spelling, text, {line_width, margin + "    "}) + "\n";
}

/// A line of documentation, escaped so that it cannot end the documentation.
std::string escape_docs_line(const SourceSpelling& spelling, std::string_view line) {
  std::string safe;
  if (line.starts_with(' ')) line.remove_prefix(1);
  for (const char c : line) {
    if (spelling.escaped_in_docs.find(c) != std::string_view::npos) safe += '\\';
    safe += c;
    if (!spelling.end_of_docs.empty() && safe.ends_with(spelling.end_of_docs)) {
      safe.insert(safe.size() - 1, 1, ' ');
    }
  }
  return safe;
}

std::string_view argument_type(const TypeSpelling& types, const Model& model, Opcode argument) {
  if (is_single(argument)) return types.number;
  if (!is_vector(argument)) return types.parameters;
  return leaf_count(model, argument) == 0 ? types.empty_argument : types.list_argument;
}

/// True for "q_12", which may be the name of an entry that a body unpacks.
bool is_entry_name(const UnpackingSpelling& unpacking, std::string_view name) {
  const std::string_view stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
  return stem.size() < name.size() && std::ranges::any_of(leaf_table(), [&](const LeafRow& row) {
           return fill_spelling(unpacking.element, row.symbol) == stem;
         });
}

/// True if every interpreted language has a name for the C function. If the module defines the
/// function itself, `spelling.used_names` must reserve the name. The assertion fails for a new
/// function until spellings.def has rows for the function.
constexpr bool is_spelled_in_all_languages(FunctionId function, std::string_view name) {
  return std::ranges::all_of(spelling_table, [&](const SourceSpelling& spelling) {
    const auto found = function_spelling(spelling, function, name);
    return found && (found->provider == FunctionProvider::library ||
                     has_word(spelling.used_names, found->name));
  });
}
#define ELGEN_FUNCTION(name, arity)                                   \
  static_assert(is_spelled_in_all_languages(FunctionId::name, #name), \
                #name " lacks rows in spellings.def");
#define ELGEN_OWN_FUNCTION(name, arity)
#include "elgen/functions.def"
#undef ELGEN_FUNCTION

class SourceDialect final : public Dialect {
 public:
  SourceDialect(const Model& model, const Scene& scene, const Program& program)
      : Dialect(model, program, scene.emission.language),
        scene_(scene),
        spelling_(source_spelling(scene.emission.language)),
        members_(parameter_leaf_members(model, program.leaves)),
        numbers_(model, program, spelling_) {}

  std::string leaf(Opcode kind, std::uint32_t number) const override {
    if (kind != Opcode::parameter) {
      const std::string_view name = leaf_row(kind).symbol;
      if (is_single(kind)) return std::string(name);
      const std::string_view element = spelling_.unpacking.element;
      return element.empty() ? element_access(std::string(name), number)
                             : fill_spelling(element, name, std::to_string(number));
    }
    const auto& [name, place] = members_[number];
    const std::string member = "p." + name_in_language(spelling_.language, name);
    return place ? element_access(member, *place) : member;
  }

  FormulaText constant(const Constant& constant) const override {
    const bool is_negative = cln::minusp(constant.value);
    const std::string name = numbers_.name_of(constant);
    const std::string text =
        name.empty() ? source_literal(constant.value) : (is_negative ? "-" : "") + name;
    return {text, is_negative ? Binding::negation : Binding::atom};
  }

  BodyRules body_rules() const override {
    return {true,
            spelling_.max_nesting,
            spelling_.max_name_length,
            {spelling_.member_comment, spelling_.member_comment}};
  }

  ColumnLoopTexts column_loop_texts(std::uint32_t count) const override {
    const std::string margin(spelling_.indent, ' ');
    const std::string element = fill_spelling(spelling_.element, "{0}", "{1}at");
    return {fill_spelling(spelling_.loop.opening, std::to_string(count)),
            std::string(spelling_.local), element,
            fmt::format("{0}{0}{1} = {{2}}{2}\n", margin, element, spelling_.end),
            std::string(spelling_.loop.closing)};
  }

  std::string loop_assignment(const std::string& target, const std::string& value) const override {
    return statement(fmt::format("{}{} = ", std::string(spelling_.indent, ' '), target), value,
                     BracketNeed::needed);
  }

  /// The emitted body unpacks its arguments, assigns the named values, then returns all entries. It
  /// writes out the repetitions of models with few velocities.
  FunctionDefinition function_definition(const Function& function, Storage storage) const override {
    Function ordered = to_storage_order(function, storage);
    if (model().velocities.size() <= max_unrolled_velocities) ordered.repeated = {};
    const ColumnLoop loop = column_loop(ordered);
    Texts names = local_names(*this, program(), ordered);
    const FunctionFormulas formulas(program(), ordered, *this, names);
    std::string lines = assign_entries(function);
    for (std::uint32_t at = 0; at < loop.first; ++at) {
      if (names[at].empty()) continue;
      lines += statement(fmt::format("{}{} = ", spelling_.local, names[at]),
                         formulas.formula(at).text, BracketNeed::needed);
    }
    if (loop.count > 0) lines += loop_lines(ordered, loop, formulas, {names});
    for (std::uint32_t at = loop.first; at < names.size(); ++at) {
      const std::optional<std::size_t> index = solved_index(loop, ordered, at);
      names[at] = index ? element_access("solved", static_cast<std::uint32_t>(*index)) : "";
    }
    FieldTexts entries;
    for (const Field& field : ordered.fields) {
      entries.emplace_back();
      for (const std::uint32_t at : field.entries) {
        entries.back().push_back(formulas.name_or_formula(at).text);
      }
    }
    return {{signature(function), lines + return_statement(function, entries)}};
  }

  /// "acceleration: list[float]"
  std::string field_declaration(const Function& function, const Field& field) const override {
    return fill_spelling(spelling_.typed, name_in_language(spelling_.language, field.name),
                         result_type(function, field));
  }

  std::string struct_name(const Function& function) const override {
    return camel_case(function.name);
  }

  Texts escape_docs(Texts lines) const override {
    for (std::string& line : lines) line = escape_docs_line(spelling_, line);
    return lines;
  }

 private:
  /// The loop over columns, after its operands and the list of its results.
  [[nodiscard]] std::string loop_lines(const Function& function, const ColumnLoop& loop,
                                       const FunctionFormulas& formulas,
                                       const ColumnLoopNames& names) const {
    Texts given;
    for (const std::uint32_t at : loop.varying_operands)
      given.push_back(formulas.name_or_formula(at).text);
    const std::size_t solved = loop.stored_instructions.size() * loop.count;
    const std::string local(spelling_.local);
    return statement(local + "given = ", source_list(spelling_.vector, given),
                     BracketNeed::present) +
           statement(
               local + "solved = ", fill_spelling(spelling_.loop.results, std::to_string(solved)),
               BracketNeed::present) +
           column_loop_text(*this, program(), function, loop, names);
  }

  [[nodiscard]] std::string_view result_type(const Function& function, const Field& field) const {
    if (is_scalar_field(function, field)) return spelling_.types.number;
    return is_matrix(kind_of_field(program(), function, field), field) ? spelling_.types.matrix
                                                                       : spelling_.types.vector;
  }

  [[nodiscard]] std::string signature(const Function& function) const {
    Texts typed;
    const auto arguments = arguments_of(model(), function, program(), spelling_.language);
    for (const Opcode argument : arguments) {
      typed.push_back(fill_spelling(spelling_.typed, leaf_row(argument).symbol,
                                    argument_type(spelling_.types, model(), argument)));
    }
    const bool is_last_empty = !arguments.empty() && is_vector(arguments.back()) &&
                               leaf_count(model(), arguments.back()) == 0;
    if (is_last_empty) typed.back() += spelling_.types.empty_default;
    const std::string type = returns_struct(function)
                                 ? struct_name(function)
                                 : std::string(result_type(function, function.fields.front()));
    const std::string text = fmt::format(fmt::runtime(spelling_.definition),
                                         name_in_language(spelling_.language, function.name),
                                         fmt::join(typed, ", "), type);
    return wrap_source_statement(spelling_, text, {line_width, "        "});
  }

  /// "(q_0, q_1) = q" for each argument that is a list.
  [[nodiscard]] std::string assign_entries(const Function& function) const {
    if (spelling_.unpacking.block.empty()) return {};
    const std::string margin(2 * spelling_.indent, ' ');
    std::string lines;
    for (const Opcode argument : arguments_of(model(), function, program(), spelling_.language)) {
      if (!is_vector(argument)) continue;
      Texts entries;
      for (std::uint32_t i = 0; i < leaf_count(model(), argument); ++i) {
        entries.push_back(leaf(argument, i));
      }
      const std::string text =
          fmt::format("{}{} = {}", margin, source_list(spelling_.numbers, entries),
                      fill_spelling(entries.empty() ? spelling_.unpacking.no_entries : "{0}",
                                    leaf_row(argument).symbol));
      lines += wrap_source_statement(spelling_, text, {line_width, margin + "    "}) + "\n";
    }
    return lines.empty() ? lines : fill_spelling(spelling_.unpacking.block, lines);
  }

  [[nodiscard]] std::string return_statement(const Function& function,
                                             const FieldTexts& entries) const {
    if (!returns_struct(function)) {
      return statement(std::string(spelling_.result),
                       field_value_text(function, function.fields.front(), entries.front()),
                       is_scalar_field(function, function.fields.front()) ? BracketNeed::needed
                                                                          : BracketNeed::present);
    }
    Texts values;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Field& field = function.fields[i];
      values.push_back(
          fill_spelling(spelling_.field, name_in_language(spelling_.language, field.name)) +
          field_value_text(function, field, entries[i]));
    }
    if (spelling_.results.empty()) {
      std::string lines;
      for (const std::string& value : values) lines += statement("", value, BracketNeed::present);
      return lines;
    }
    const std::string all = fmt::format("{}", fmt::join(values, ", "));
    return statement(std::string(spelling_.result),
                     fill_spelling(spelling_.results, struct_name(function), all),
                     BracketNeed::present);
  }

  [[nodiscard]] std::string statement(const std::string& start, const std::string& value,
                                      BracketNeed brackets) const {
    return statement_text(spelling_, start, value, brackets);
  }

  [[nodiscard]] std::string element_access(const std::string& name, std::uint32_t number) const {
    return fill_spelling(spelling_.element, name, std::to_string(number + spelling_.first_index));
  }

  [[nodiscard]] std::string field_value_text(const Function& function, const Field& field,
                                             const Texts& entries) const {
    if (is_scalar_field(function, field)) return entries.front();
    const OutputKind kind = kind_of_field(program(), function, field);
    if (!is_matrix(kind, field)) return source_list(spelling_.vector, entries);
    Texts rows;
    for (std::size_t row = 0; row < field.rows; ++row) {
      const auto first = entries.begin() + static_cast<std::ptrdiff_t>(row * field.columns);
      const Texts of_row(first, first + static_cast<std::ptrdiff_t>(field.columns));
      rows.push_back(source_list(spelling_.row, of_row));
    }
    return source_list(spelling_.matrix, rows, field.columns);
  }

  bool is_reserved(const std::string& name) const override {
    return has_word(spelling_.reserved, name) || has_word(spelling_.used_names, name) ||
           name == scene_.base_name || is_entry_name(spelling_.unpacking, name);
  }

  std::string library_function_name(std::string_view name) const override {
    if (const auto known = library_function_spelling(spelling_, name))
      return fill_spelling(spelling_.library, *known);
    return helper_function_name(function_spelling(spelling_, find_function(name)->id, name)->name);
  }

  std::string helper_function_name(std::string_view name) const override {
    return fill_spelling(spelling_.own_function, name, scene_.base_name);
  }

  const Scene& scene_;
  const SourceSpelling& spelling_;
  std::vector<ParameterMember> members_;
  ExactNumbers numbers_;
};

}  // namespace

std::optional<std::string_view> library_function_spelling(const SourceSpelling& spelling,
                                                          std::string_view name) {
  const FunctionRow* const row = find_function(name);
  if (row == nullptr) return name;
  const auto found = function_spelling(spelling, row->id, name);
  if (!found || found->provider == FunctionProvider::module) return std::nullopt;
  return found->name;
}

std::string source_literal(const cln::cl_R& value) {
  return signed_literal(value, ScalarKind::double_precision);
}

std::string source_string_literal(const SourceSpelling& spelling, std::string_view text) {
  std::string literal;
  for (const char c : string_literal(text, spelling.quote, spelling.escape)) {
    const bool is_coded = spelling.coded_in_texts.find(c) != std::string_view::npos;
    literal += is_coded ? fmt::format("\\u{:04x}", c) : std::string(1, c);
  }
  return literal;
}

std::string source_list(const ListSpelling& list, const Texts& values, std::size_t columns) {
  if (values.empty()) return fmt::format(fmt::runtime(list.empty), columns);
  return fmt::format("{}{}{}{}", list.opening, fmt::join(values, list.separator),
                     values.size() == 1 ? list.after_single : "", list.closing);
}

std::string wrap_source_statement(const SourceSpelling& spelling, const std::string& text,
                                  Wrapping wrapping) {
  wrapping.line_end = spelling.end_of_line;
  return fmt::format("{}", fmt::join(wrap_expression(text, wrapping), "\n"));
}

std::string wrap_source_value(const SourceSpelling& spelling, const std::string& start,
                              const std::string& text) {
  return wrap_source_statement(spelling, text, {line_width - start.size(), "    "});
}

std::unique_ptr<Dialect> source_dialect(const Model& model, const Scene& scene,
                                        const Program& program) {
  return std::make_unique<SourceDialect>(model, scene, program);
}

}  // namespace elgen
