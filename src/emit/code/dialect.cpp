// dialect: names and calls that all languages write in the same way.
#include "emit/code/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 4> loop_names{"given", "solved", "first", "at"};

}  // namespace

FormulaText Dialect::square_root(const FormulaText& radicand) const {
  return named_call_text(library_function_name("sqrt"), {radicand});
}

FormulaText Dialect::call(FunctionId function, const std::vector<FormulaText>& arguments) const {
  const std::string_view own = function_row(function).own_name;
  return named_call_text(
      own.empty() ? library_function_name(function_row(function).name) : helper_function_name(own),
      arguments);
}

bool Dialect::is_function_name(std::string_view name) {
  return name == "sqrt" || find_function(name) != nullptr;
}

std::string Dialect::temporary_name(const std::string& name) const {
  const bool is_argument = std::ranges::any_of(leaf_table(), [&](const LeafRow& leaf) {
    return leaf.symbol == name && may_be_argument(program_.leaves, leaf.id);
  });
  const bool is_of_loop = std::ranges::count(loop_names, name) > 0;
  const bool hides = is_argument || is_of_loop || name == "w" || name == "result" ||
                     is_function_name(name) || is_reserved(name);
  return hides ? name + "_" : name;
}

std::vector<std::string_view> Dialect::argument_names_of(const Function& function) const {
  std::vector<std::string_view> names;
  for (const Opcode argument : arguments_of(model_, function, program_, language_)) {
    names.push_back(leaf_row(argument).symbol);
  }
  return names;
}

bool Dialect::is_scalar_field(const Function& function, const Field& field) const {
  return is_scalar(program_, function, field);
}

}  // namespace elgen
