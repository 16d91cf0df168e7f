// source_module: a module in an interpreted language, from the template of the language.
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/ascii.hpp"
#include "emit/code/function_docs.hpp"
#include "emit/code/header_data.hpp"
#include "emit/interface/code_interface.hpp"
#include "emit/source/reflection.hpp"
#include "emit/source/source_dialect.hpp"
#include "emit/text/emission_checks.hpp"
#include "emit/text/emission_input.hpp"
#include "emit/text/layout.hpp"

namespace elgen {
namespace {

using Texts = std::vector<std::string>;

/// declared_arrays(), and the names and units of the emitted parameters.
std::vector<DeclaredArray> module_arrays(const Model& model, const Program& program) {
  std::vector<DeclaredArray> arrays = declared_arrays(model, program);
  DeclaredArray names{"parameter_names"};
  DeclaredArray units{"parameter_units"};
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    names.texts.push_back(array.name);
    units.texts.push_back(array.unit_text);
  }
  arrays.push_back(std::move(names));
  arrays.push_back(std::move(units));
  return arrays;
}

TemplateData declared_array_data(const DeclaredArray& array, const SourceSpelling& spelling) {
  using Kind = DeclaredArray::Kind;
  Texts elements = element_literals(array, spelling.interval, spelling.unbounded);
  for (std::size_t i = 0; i < array.texts.size(); ++i) {
    elements[i] = source_string_literal(spelling, array.texts[i]);
  }
  const ListSpelling& list = array.kind == Kind::texts     ? spelling.texts
                             : array.kind == Kind::numbers ? spelling.numbers
                                                           : spelling.intervals;
  const std::string value = source_list(list, elements) + std::string(spelling.end);
  return TemplateRow{{"name", array.name},
                     {"value", wrap_source_value(spelling, array.name + " = ", value)}};
}

Texts parameter_literals(const Model& model, const ParameterArray& array) {
  Texts texts;
  for (const cln::cl_R& value : element_values(model, array))
    texts.push_back(source_literal(value));
  return texts;
}

/// The parameters as members, such as "M: float = 1.0", with documentation.
std::vector<Member> parameter_members(const EmissionInput& input) {
  const SourceSpelling& spelling = source_spelling(input.scene.emission.language);
  const std::string margin(spelling.indent, ' ');
  std::vector<Member> members;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    const Texts values = parameter_literals(input.model, array);
    const auto pattern =
        fmt::runtime(array.is_array ? spelling.array_value : spelling.number_value);
    const std::string start = fmt::format(pattern, name_in_language(spelling.language, array.name));
    const std::string value =
        (array.is_array ? source_list(spelling.numbers, values) : values.front()) +
        std::string(spelling.end_of_value);
    const std::string lines =
        wrap_source_value(spelling, fmt::format("{}{}", margin, start), value);
    members.push_back({fmt::format("{}{}", start, lines), parameter_doc(array)});
  }
  return members;
}

/// The lines of the members. `is_documented` is false for the script of a page, because
/// documentation from the model could contain the end tag of the script.
Texts parameter_lines(const EmissionInput& input, bool is_documented) {
  const std::string_view mark = source_spelling(input.scene.emission.language).comment;
  const std::vector<Member> members = parameter_members(input);
  if (is_documented) return member_doc_lines(members, {mark, mark});
  Texts lines;
  for (const Member& member : members) lines.push_back(member.declaration);
  return lines;
}

/// True if the module is a class, whose functions call each other through the name of the class. A
/// member with the name of the class would be its constructor.
bool is_class_module(const SourceSpelling& spelling) {
  return spelling.own_function.find("{1}") != std::string_view::npos;
}

/// Names in the module besides its outputs; if the module is a class, also the name of the class.
std::set<std::string> names_in_module(const Model& model, const Scene& scene,
                                      const Program& program) {
  const SourceSpelling& spelling = source_spelling(scene.emission.language);
  std::set<std::string> names;
  for (const DeclaredArray& array : module_arrays(model, program)) names.insert(array.name);
  for (const std::string& name : called_library_functions(program, spelling)) names.insert(name);
  if (is_class_module(spelling)) names.insert(scene.base_name);
  return names;
}

/// Reports E701 if the language reserves the name of the module, or if the module is a class that
/// has a member with the same name.
void check_module_name(const Model& model, const Scene& scene, const Program& program,
                       Diagnostics& diagnostics) {
  const SourceSpelling& spelling = source_spelling(scene.emission.language);
  const std::string& name = scene.base_name;
  const Span& span = scene.emission.name_space_span;
  const auto arrays = module_arrays(model, program);
  if (has_word(spelling.forbidden_names, name) || has_word(spelling.reserved, name)) {
    diagnostics.push_back({Code::E701, span,
                           fmt::format("`{}` cannot name a module: {} uses the name itself", name,
                                       language_row(spelling.language).name),
                           "rename the model or scene"});
  } else if (is_class_module(spelling) &&
             (has_word(spelling.used_names, name) ||
              std::ranges::count(arrays, name, &DeclaredArray::name) > 0)) {
    diagnostics.push_back(reserved_name_error(name, "module", span));
  }
}

/// Reports E701 if the name is longer than the language allows.
void check_name_length(const Scene& scene, const std::string& name, const Span& span,
                       Diagnostics& diagnostics) {
  const LanguageId language = scene.emission.language;
  const std::size_t longest = source_spelling(language).max_name_length;
  const std::string emitted_name = name_in_language(language, name);
  if (longest == 0 || emitted_name.size() <= longest) return;
  diagnostics.push_back(
      {Code::E701, span,
       fmt::format("`{}` has {} characters: names in {} have {} at most", emitted_name,
                   emitted_name.size(), language_row(language).name, longest)});
}

/// The module; if `is_exported`, with documentation and the list of names for other modules.
std::string fill_module(const EmissionInput& input, bool is_exported) {
  TemplateData data = header_data(input, *source_dialect(input.model, input.scene, input.program));
  const LanguageRow& language = language_row(input.scene.emission.language);
  const SourceSpelling& spelling = source_spelling(language.id);
  for (const FunctionSpelling& function : function_spelling_table) {
    if (function.language != language.id || function.provider != FunctionProvider::module) continue;
    data.set(std::string(function_row(function.function).name),
             optional_section(calls_function(input.program, function.function)));
  }
  data.set("exported", optional_section(is_exported));
  data.set("export", is_exported ? "export " : "");
  const std::vector<DeclaredArray> arrays = module_arrays(input.model, input.program);
  data.set("declared", repeated_section(arrays, [&](const DeclaredArray& array) {
             return declared_array_data(array, spelling);
           }));
  data.set("parameters", lines_section(parameter_lines(input, is_exported)));
  data.set("count_of_pivots",
           std::to_string(input.model.velocities.size() + input.model.constraints.size()));
  if (spelling.has_reflection) {
    set_reflection(data, input, arrays);
  }
  return fill_header_template(
      fmt::format("{}/module.{}.mustache", language.name, language.file_extension), data,
      spelling.max_empty_lines);
}

}  // namespace

std::string source_module(const EmissionInput& input) { return fill_module(input, true); }

std::string source_script(const EmissionInput& input) { return fill_module(input, false); }

Diagnostics source_check_names(const Model& model, const Scene& scene, const Program& program) {
  const LanguageId language = scene.emission.language;
  const SourceSpelling& spelling = source_spelling(language);
  Diagnostics diagnostics;
  check_name_length(scene, scene.base_name, scene.emission.name_space_span, diagnostics);
  check_module_name(model, scene, program, diagnostics);
  std::set<std::string> names;
  for (const ParameterArray& array : emitted_parameters(model, program)) {
    check_name_length(scene, array.name, array.span, diagnostics);
    if (names.insert(name_in_language(language, array.name)).second) continue;
    diagnostics.push_back(reserved_name_error(array.name, "parameter", array.span));
  }
  names = names_in_module(model, scene, program);
  for (const Function& function : program.functions) {
    const OutputRequest* const request = find_request(scene, function.name);
    check_name_length(scene, function.name, request == nullptr ? Span{} : request->span,
                      diagnostics);
    const std::string name = name_in_language(language, function.name);
    const std::string type = camel_case(function.name);
    const bool has_type = returns_struct(function) && spelling.results.starts_with("{0}");
    const bool is_reserved =
        has_word(spelling.used_names, name) || !names.insert(name).second ||
        (has_type && (has_word(spelling.used_names, type) || !names.insert(type).second));
    if (is_reserved) diagnostics.push_back(reserved_name_error(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
