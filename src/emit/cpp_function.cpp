// cpp_function: a short function is one body. A long one is cut, because the time of compilers
// grows faster than the length of a function (9 000 operations: g++ 21 s whole, 4 s in parts):
//
//     Dynamics<Scalar> result;
//     detail::DynamicsWorkspace<Scalar> w;
//     detail::dynamics_part_1(result, w, p, q, v);
//     …
//     return result;
#include "cpp_function.hpp"

#include <fmt/format.h>

#include "cpp_body.hpp"
#include "cpp_names.hpp"
#include "cpp_signature.hpp"
#include "cpp_spelling.hpp"

namespace elgen {
namespace {

CppDefinition definition(const Model& model, const Function& function, const std::string& body) {
  std::vector<CppArgument> arguments = cpp_arguments(model, function);
  const std::string type = result_type(function);
  if (is_returned(function)) {
    return {cpp_signature(fmt::format("[[nodiscard]] {} {}", type, function.name), arguments, body),
            body};
  }
  arguments.insert(arguments.begin(), {type + "&", "result"});
  return {cpp_signature("void " + function.name, arguments, body), body};
}

std::string part_name(const Function& function, std::size_t part) {
  return fmt::format("{}_part_{}", function.name, part + 1);
}

CppDefinition part_definition(const Model& model, const CppText& text, const Sections& cut,
                              std::size_t part) {
  const std::string body = cpp_part(text, cut, part);
  std::vector<CppArgument> arguments = {{result_type(text.function) + "&", "result"},
                                        {workspace_name(text.function) + "<Scalar>&", "w"}};
  const std::vector<CppArgument> own = cpp_arguments(model, text.function);
  arguments.insert(arguments.end(), own.begin(), own.end());
  return {cpp_signature("void " + part_name(text.function, part), arguments, body), body};
}

/// The body that calls the parts one after another.
std::string calling_body(const Model& model, const Function& function, std::size_t parts) {
  std::string body;
  if (is_returned(function)) body += fmt::format("  {} result;\n", result_type(function));
  body += fmt::format("  detail::{}<Scalar> w;\n", workspace_name(function));
  std::string arguments = "result, w";
  for (const CppArgument& argument : cpp_arguments(model, function)) {
    arguments += ", " + argument.name;
  }
  for (std::size_t part = 0; part < parts; ++part) {
    body += fmt::format("  detail::{}({});\n", part_name(function, part), arguments);
  }
  return is_returned(function) ? body + "  return result;\n" : body;
}

std::vector<std::string> shared_names(const FunctionBody& body, const std::vector<bool>& crosses) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < crosses.size(); ++i) {
    if (crosses[i]) names.push_back(body.statements[i].name);
  }
  return names;
}

}  // namespace

std::string workspace_name(const Function& function) { return struct_name(function) + "Workspace"; }

CppFunction cpp_function(const Model& model, const Program& program, const Function& function) {
  const CppSpelling spelling(model, program);
  const FunctionBody body = statements(program, function, spelling);
  if (length(body) <= longest_body) {
    return {definition(model, function, cpp_body(cpp_text(program, function, body)))};
  }
  const Sections cut = sections(body, section_length);
  const FunctionBody shared = statements(program, function, spelling, cut.crosses);
  const CppText text = cpp_text(program, function, shared);
  CppFunction result{definition(model, function, calling_body(model, function, cut.parts.size()))};
  for (std::size_t part = 0; part < cut.parts.size(); ++part) {
    result.parts.push_back(part_definition(model, text, cut, part));
  }
  result.workspace = shared_names(body, cut.crosses);
  return result;
}

}  // namespace elgen
