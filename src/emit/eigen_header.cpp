// eigen_header: every function copies its arguments into std::array (a reinterpreted Map would be
// undefined), calls the one of the other header, and gives the result its type by a Map. What the
// copies cost: nothing to a tenth of panda7 with clang++, a quarter with g++ -O2, a tenth with -O3.
#include "eigen_header.hpp"

#include <fmt/format.h>

#include "arguments.hpp"
#include "cpp_names.hpp"
#include "fields.hpp"
#include "function_docs.hpp"
#include "header_data.hpp"
#include "languages.hpp"
#include "layout.hpp"
#include "signature.hpp"
#include "stamp.hpp"

namespace elgen {
namespace {

using List = TemplateData::type;
using Texts = std::vector<std::string>;

std::string matrix_type(const Field& field) {
  return fmt::format("Matrix<Scalar, {}, {}>", field.rows, field.columns);
}

/// The declared types of the arguments, and what the function of the other header is given.
struct CallTexts {
  Texts declared = {};
  Texts given = {};
};

CallTexts call_texts(const Model& model, const Function& function) {
  CallTexts texts;
  for (const Argument argument : arguments_of(model, function)) {
    const std::string name(argument_name(argument));
    const std::size_t size = argument_size(model, argument);
    if (argument == Argument::parameters) {
      texts.declared.push_back("const Parameters<Scalar>& " + name);
      texts.given.push_back(name);
    } else if (argument == Argument::time) {
      texts.declared.push_back("const std::common_type_t<Scalar>& " + name);
      texts.given.push_back(name);
    } else {
      texts.declared.push_back(fmt::format("const detail::Argument<Scalar, {}>& {}", size, name));
      texts.given.push_back(fmt::format("detail::entries<Scalar, {}>({})", size, name));
    }
  }
  return texts;
}

/// "Eigen::Map<const Matrix<Scalar, 2, 1>>(result.acceleration.data())", or the number.
std::string mapped(const Field& field, bool is_number) {
  const std::string value = field.name.empty() ? "result" : "result." + field.name;
  return is_number ? value
                   : fmt::format("Eigen::Map<const {}>({}.data())", matrix_type(field), value);
}

std::string body(const EmissionInput& input, const Function& function, const Texts& given) {
  const std::vector<bool> scalars = scalar_fields(input.program, function);
  Texts values;
  for (std::size_t i = 0; i < function.fields.size(); ++i) {
    values.push_back(mapped(function.fields[i], scalars[i]));
  }
  const std::string callee =
      fmt::format("  const auto result = ::{}::{}", name_space(input.scene), function.name);
  const std::string start = signature(callee, given, ";\n");
  if (!gives_struct(function)) return start + fmt::format("  return {};\n", values.front());
  return start + fmt::format("  return {{\n      {},\n  }};\n", fmt::join(values, ",\n      "));
}

TemplateData struct_data(const FunctionText& text) {
  const std::vector<bool> scalars = scalar_fields(text.program, text.function);
  std::vector<Member> members;
  for (std::size_t i = 0; i < text.function.fields.size(); ++i) {
    const Field& field = text.function.fields[i];
    const std::string type = scalars[i] ? "Scalar" : matrix_type(field);
    members.push_back({fmt::format("{} {};", type, field.name), field_summary(text, field)});
  }
  TemplateData data;
  data.set("name", cpp_struct_name(text.function));
  data.set("doc", fmt::format("What {} returns.", text.function.name));
  data.set("members", lines_data(documented_members(members)));
  return data;
}

std::string result_type(const EmissionInput& input, const Function& function) {
  if (gives_struct(function)) return cpp_struct_name(function) + "<Scalar>";
  const bool is_number = scalar_fields(input.program, function).front();
  return is_number ? "Scalar" : matrix_type(function.fields.front());
}

TemplateData function_data(const EmissionInput& input, std::size_t index) {
  const Function& function = input.program.functions[index];
  const FunctionText text{input.model, input.program,       function, input.equations[index],
                          "",          input.scene.emission};
  const CallTexts call = call_texts(input.model, function);
  const bool has_struct = gives_struct(function);
  TemplateData data;
  data.set("struct", section_if(has_struct, has_struct ? struct_data(text) : TemplateData()));
  data.set("summary", function_heading(text));
  data.set("signature", signature(fmt::format("[[nodiscard]] {} {}", result_type(input, function),
                                              function.name),
                                  call.declared, ""));
  data.set("body", body(input, function, call.given));
  return data;
}

}  // namespace

std::string eigen_header(const EmissionInput& input) {
  TemplateData list(List::list);
  for (std::size_t i = 0; i < input.program.functions.size(); ++i) {
    if (is_returned(input.program.functions[i])) list.push_back(function_data(input, i));
  }
  const bool is_row_major = input.scene.emission.storage == Storage::row_major;
  TemplateData data = stamp_data(input);
  data.set("header", input.scene.base_name + ".hpp");
  data.set("order", is_row_major ? "RowMajor" : "ColMajor");
  data.set("functions", list);
  return stamped(render("cpp/eigen.hpp.mustache", data));
}

Diagnostics eigen_check_names(const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    for (const char* const name : {"eigen", "Eigen", "Matrix"}) {
      const bool takes_struct = gives_struct(function) && cpp_struct_name(function) == name;
      if (function.name != name && !takes_struct) continue;
      diagnostics.push_back(taken_name(function.name, "function", span_of(scene, function)));
      break;
    }
  }
  return diagnostics;
}

}  // namespace elgen
