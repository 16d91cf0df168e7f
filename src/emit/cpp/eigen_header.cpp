// eigen_header: the bodies are written again rather than called: a Map of the other header's arrays
// would be a copy of them each way (up to a quarter of the time of panda7, g++ -O2), or undefined.
#include "emit/code/header_data.hpp"
#include "emit/cpp/cpp_artifacts.hpp"
#include "emit/cpp/cpp_dialect.hpp"
#include "emit/cpp/cpp_names.hpp"
#include "emit/text/layout.hpp"
#include "emit/text/taken_name.hpp"
#include "lower/code_interface.hpp"

namespace elgen {

std::string eigen_header(const EmissionInput& input) {
  TemplateData data = header_data(input, *eigen_dialect(input.model, input.program));
  const bool is_row_major = input.scene.emission.storage == Storage::row_major;
  data.set("header", input.scene.base_name + ".hpp");
  data.set("order", is_row_major ? "RowMajor" : "ColMajor");
  return header_text("cpp/eigen.hpp.mustache", data);
}

Diagnostics eigen_check_names(const Model& /*model*/, const Scene& scene, const Program& program) {
  Diagnostics diagnostics;
  for (const Function& function : program.functions) {
    const bool takes_struct = gives_struct(function) && is_eigen_name(cpp_struct_name(function));
    if (!takes_struct && !is_eigen_name(function.name)) continue;
    diagnostics.push_back(taken_name(scene, function));
  }
  return diagnostics;
}

}  // namespace elgen
