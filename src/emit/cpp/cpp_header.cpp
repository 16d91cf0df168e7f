// cpp_header: the C++17 header, as templates/cpp/header.hpp.mustache pictures it.
#include <fmt/format.h>

#include "base/number_text.hpp"
#include "emit/code/cpp_constant.hpp"
#include "emit/code/header_data.hpp"
#include "emit/cpp/cpp_artifacts.hpp"
#include "emit/cpp/cpp_declarations.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "emit/text/layout.hpp"
#include "emit/text/parameters.hpp"
#include "lower/code_interface.hpp"

namespace elgen {
namespace {

using List = TemplateData::type;

/// The functions that hold constants too long to stand in an equation, in order of the program.
TemplateData numbers(const Program& program) {
  TemplateData list(List::list);
  for (const Constant& constant : executed_constants(program)) {
    if (is_short_constant(constant.value)) continue;
    TemplateData item;
    const cln::cl_R magnitude = cln::abs(constant.value);
    item.set("text", is_rational(constant) ? exact_text(magnitude) : text_of(constant.form));
    item.set("name", constant_name(constant));
    const Wrapping wrapping{line_width - 10, std::string(6, ' ')};
    item.set("value",
             fmt::format(
                 "{}", fmt::join(wrap_expression(cpp_magnitude(constant.value), wrapping), "\n")));
    list.push_back(item);
  }
  return list;
}

}  // namespace

std::string cpp_header(const EmissionInput& input) {
  const std::vector<ParameterArray> parameters = emitted_parameters(input.model, input.program);
  TemplateData data = header_data(input, *cpp_dialect(input.model, input.program));
  data.set("declared", declarations(input.model));
  data.set("filled", section_if(has_filled_array(input.model, parameters)));
  data.set("numbers", numbers(input.program));
  data.set("sine_cosine", section_if(has_sine_with_cosine(input.program)));
  data.set("parameters",
           lines_data(documented_members(declared_parameters(input.model, parameters))));
  return header_text("cpp/header.hpp.mustache", data);
}

}  // namespace elgen
