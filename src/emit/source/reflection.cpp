// reflection: lists the library functions that the module calls, the functions that it defines, and
// its exact numbers.
#include "emit/source/reflection.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.hpp"
#include "elgen/leaf_names.hpp"
#include "elgen/leaves.hpp"
#include "emit/code/header_data.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/source/exact_numbers.hpp"
#include "emit/source/source_dialect.hpp"
#include "numbers/exact_number.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

Texts quote_names(Texts names) {
  for (std::string& name : names) name = fmt::format("\"{}\"", name);
  return names;
}

/// The function and its names in other libraries: arctan2 for atan2, abs and Abs for fabs.
std::string library_aliases(const SourceSpelling& spelling, const std::string& name) {
  Texts names{name};
  const bool is_inverse = name != "abs" && name.starts_with('a');
  if (is_inverse) names.push_back("arc" + name.substr(1));
  if (name == "fabs") names.insert(names.end(), {"abs", "Abs"});
  return source_list(spelling.texts, quote_names(std::move(names)));
}

std::string library_dictionary(const SourceSpelling& spelling, const Texts& names) {
  Texts pairs;
  for (const std::string& name : names) {
    pairs.push_back(fmt::format("\"{}\": {}", name, library_aliases(spelling, name)));
  }
  return wrap_source_value(spelling, "_library: dict[str, tuple[str, ...]] = ",
                           fmt::format("{{{}}}", fmt::join(pairs, ", ")));
}

/// Functions of the module that branch on a number. The template defines sign, min and max
/// together.
Texts branching_functions(const EmissionInput& input) {
  constexpr std::array kinks{FunctionId::sign, FunctionId::min, FunctionId::max};
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  const auto is_called = [&](FunctionId function) {
    return calls_function(input.program, function);
  };
  Texts names;
  const auto add = [&](FunctionId function) {
    names.push_back(fmt::format(fmt::runtime(spelling.own_function),
                                function_row(function).own_name, input.scene.base_name));
  };
  if (std::ranges::any_of(kinks, is_called)) std::ranges::for_each(kinks, add);
  if (is_called(FunctionId::stumpff)) add(FunctionId::stumpff);
  return names;
}

Texts names_of_functions(const EmissionInput& input) {
  Texts names = branching_functions(input);
  for (const Function& function : input.program.functions) {
    names.push_back(name_in_language(input.scene.emission.language, function.name));
  }
  return names;
}

/// Imports the functions `called`. One that raises an error on overflow is imported as "_exp", for
/// the module's own "exp".
void set_imports(TemplateData& data, const SourceSpelling& spelling, const Texts& called,
                 bool has_unbounded) {
  Texts imported;
  Texts wrapped;
  for (const std::string& name : called) {
    const bool is_wrapped = has_word(spelling.overflow_errors, name);
    imported.push_back(is_wrapped ? fmt::format("{0} as _{0}", name) : name);
    if (is_wrapped) wrapped.push_back(name);
  }
  if (has_unbounded) imported.emplace_back(spelling.unbounded);
  std::sort(imported.begin(), imported.end());
  data.set("imports",
           optional_section(!imported.empty(),
                            TemplateRow{{"names", fmt::format("{}", fmt::join(imported, ", "))}}));
  data.set("overflow",
           optional_section(!wrapped.empty(), TemplateRow{{"wrapped", lines_section(wrapped)}}));
}

/// The names that other modules import with `from module import *`.
Texts exported_names(const EmissionInput& input, const std::vector<DeclaredArray>& arrays) {
  Texts names{"Parameters", "exact", "on"};
  for (const DeclaredArray& array : arrays) names.push_back(array.name);
  if (returns_pivots(input.program)) names.insert(names.end(), {"digits_left", "is_regular"});
  for (const Function& function : input.program.functions) {
    names.push_back(name_in_language(input.scene.emission.language, function.name));
    if (returns_struct(function)) names.push_back(camel_case(function.name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// {"q": 2, "v": 2}: the lengths of all arguments that are lists.
std::string length_dictionary(const EmissionInput& input) {
  Texts pairs;
  for (const LeafRow& leaf : leaf_table()) {
    if (!is_vector(leaf.id) || !may_be_argument(input.program.leaves, leaf.id)) continue;
    pairs.push_back(fmt::format("\"{}\": {}", leaf.symbol, leaf_count(input.model, leaf.id)));
  }
  return fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

}  // namespace

Texts called_library_functions(const Program& program, const SourceSpelling& spelling) {
  Texts names;
  for (const std::size_t arity : {1U, 2U}) {
    for (const std::string_view name : library_calls(program, arity)) {
      if (const auto known = library_function_spelling(spelling, name)) names.emplace_back(*known);
    }
  }
  const bool has_series = calls_function(program, FunctionId::stumpff);
  if (has_series || calls_function(program, FunctionId::sin)) names.emplace_back("sin");
  if (calls_function(program, FunctionId::cos)) names.emplace_back("cos");
  if (has_series) names.emplace_back("sinh");
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void set_reflection(TemplateData& data, const EmissionInput& input,
                    const std::vector<DeclaredArray>& arrays) {
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  const Texts called = called_library_functions(input.program, spelling);
  set_imports(data, spelling, called, std::ranges::any_of(arrays, has_unbounded_element));
  data.set(
      "exported_names",
      wrap_source_value(spelling, "__all__ = ",
                        source_list(spelling.texts, quote_names(exported_names(input, arrays)))));
  data.set("lengths", length_dictionary(input));
  const ExactNumbers exact(input.model, input.program, spelling);
  data.set("exact",
           wrap_source_value(spelling, "exact: dict[Any, Any] = ",
                             fmt::format("{{{}}}", fmt::join(exact.dictionary_entries(), ", "))));
  data.set("numbers", repeated_section(exact.named_numbers(), [](const auto& number) {
             return TemplateRow{{"name", number.first},
                                {"value", source_literal(exact_value(number.second))}};
           }));
  data.set("library", library_dictionary(spelling, called));
  data.set("branching", source_list(spelling.texts, quote_names(branching_functions(input))));
  data.set("all", wrap_source_value(spelling, "_functions: tuple[Any, ...] = ",
                                    source_list(spelling.texts, names_of_functions(input))));
}

}  // namespace elgen
