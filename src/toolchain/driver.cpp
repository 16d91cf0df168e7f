// driver: the drivers of a scene's headers, and helpers for all languages. Example: the driver
// function of inverse_dynamics(q, v, a) for two coordinates:
//
//     void elgen_driver_cpp_double_0(const double* p, const double* f, const double* q,
//                                    const double* v, const double* momenta, const double* a,
//                                    const double* u, double t, double h, double E,
//                                    double* result);
#include "toolchain/driver.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "elgen/artifacts.hpp"
#include "elgen/emitted_files.hpp"
#include "emit/interface/code_interface.hpp"

namespace elgen {
namespace {

/// The names of all emitted parameters; for arrays, of all elements.
std::set<std::string> emitted_parameter_names(const DriverInput& input) {
  std::set<std::string> names;
  for (const ParameterArray& array : emitted_parameters(input.model, input.program)) {
    for (std::uint32_t i = 0; i < array.count; ++i) {
      names.insert(input.model.parameters[array.first + i].name);
    }
  }
  return names;
}

/// Largest number of instructions of a program whose headers share a unit. If all headers of an arm
/// of seven joints are in one unit, the compiler needs a gigabyte of memory.
constexpr std::size_t max_unit_length = 4096;

std::size_t instruction_count(const Program& program) {
  std::size_t length = 0;
  for (const Function& function : program.functions) length += function.instructions.size();
  return length;
}

bool is_generic(const Scene& scene) {
  return language_row(scene.emission.language).scalars == LanguageScalars::any;
}

/// Writes a driver; null in a table if the build does not compile the header.
using DriverWriter = std::string (*)(const DriverInput& input);

struct DriverRow {
  const char* types;
  const char* name;
  const char* needs;
  DriverWriter text;
  DriverWriter user_build_text;
  bool uses_packs = false;
  bool is_wide = false;
};

constexpr DriverRow no_code{"", "", "", nullptr, nullptr};
constexpr ArtifactTable<DriverRow> driver_table{
    .cpp = {"", "cpp", "", &cpp_driver, &cpp_driver},
    .eigen = {"Eigen", "eigen", "Eigen/Core", &eigen_driver, nullptr},
    .batch = {"batch", "batch", "", &batch_driver, &sine_driver, true},
    .wide = {"wide", "wide", "", &wide_driver, &wide_driver, false, true},
    .c99 = {"", "c99", "", &c99_driver, &c99_driver},
    .source = no_code,
    .sidecar = no_code,
    .page = no_code};

/// Steps of the batch header whose accelerations are in float.
constexpr DriverRow wide_batch_row{"wide, batch",      "wide_batch", "",  &wide_batch_driver,
                                   &wide_batch_driver, true,         true};

}  // namespace

std::string leaf_parameter_list(std::string_view scalar, std::string_view attribute) {
  std::string text;
  for (const LeafRow& leaf : leaf_table()) {
    const char* const pattern = is_single(leaf.id) ? "{}{} {}, " : "{}const {}* {}, ";
    text += fmt::format(fmt::runtime(pattern), attribute, scalar, leaf.member);
  }
  return text;
}

std::string parameter_assignments(const DriverInput& input) {
  const LeafNames& leaves = input.program.leaves;
  const std::vector<std::string> members = parameter_member_texts(input.model, leaves);
  const std::set<std::string> emitted = emitted_parameter_names(input);
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (emitted.count(leaves.parameters[i]) == 0) continue;
    text += fmt::format("  result.{} = values[{}];\n", members[i], i);
  }
  return text;
}

std::string_view storage_index(const Scene& scene) {
  const bool is_row_major = scene.emission.storage == Storage::row_major;
  return is_row_major ? "i * columns + j" : "j * rows + i";
}

std::string append_statements(const DriverInput& input, const Function& function,
                              std::string_view to, std::string_view data) {
  std::string text;
  for (const Field& field : function.fields) {
    if (field.entries.empty()) continue;
    const std::string value = field.name.empty() ? "result" : "result." + field.name;
    const std::string address =
        is_scalar(input.program, function, field) ? "&" + value : value + std::string(data);
    text += fmt::format("  append({}, {}, {}, {});\n", to, address, field.rows, field.columns);
  }
  return text;
}

std::vector<Driver> make_drivers(const DriverInput& input, BuildFlags build) {
  std::vector<DriverRow> rows;
  for (const Artifact& artifact : requested_artifacts(input.scene)) {
    rows.push_back(driver_table[artifact.id]);
    const bool is_wide = artifact.id == ArtifactId::wide;
    if (is_wide && input.scene.emission.has_batch_header) rows.push_back(wide_batch_row);
  }
  std::vector<Driver> result;
  for (const DriverRow& row : rows) {
    const DriverWriter text = build == BuildFlags::user_flags ? row.user_build_text : row.text;
    if (text == nullptr) continue;
    result.push_back({row.types, row.name, text(input), row.needs, row.uses_packs, row.is_wide,
                      text != &sine_driver});
  }
  return result;
}

std::vector<DriverUnit> make_driver_units(const DriverInput& input, BuildFlags build,
                                          const std::string& more) {
  const bool is_long = instruction_count(input.program) > max_unit_length;
  std::vector<DriverUnit> units;
  for (Driver& driver : make_drivers(input, build)) {
    if (units.empty() || (is_long && driver.has_functions)) {
      units.push_back({{}, build, {}});
      units.back().source.file =
          fmt::format("driver_{}_{}.{}", static_cast<int>(build), units.size(),
                      language_row(input.scene.emission.language).file_extension);
    }
    SourceFile& source = units.back().source;
    const std::string& needs = driver.needs;
    source.text += needs.empty()
                       ? driver.text
                       : fmt::format("#if __has_include(<{}>)\n{}#endif\n", needs, driver.text);
    if (!needs.empty()) source.required_header = needs;
    units.back().drivers.push_back(std::move(driver));
  }
  units.front().source.text += more;
  return units;
}

std::vector<ScalarKind> driver_scalars(const DriverInput& input) {
  if (!is_generic(input.scene)) return input.scene.numerics.scalars;
  std::vector<ScalarKind> scalars{ScalarKind::double_precision};
  constexpr ScalarKind other = ScalarKind::single_precision;
  if (literals_fit(input.model, input.program, other)) scalars.push_back(other);
  return scalars;
}

std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input) {
  return driver.uses_packs || driver.is_wide ? input.scene.numerics.scalars : driver_scalars(input);
}

bool is_wrapped(const Driver& driver, const Function& function) {
  const bool returns_by_value = driver.uses_packs || driver.is_wide;
  return driver.has_functions && (!returns_by_value || is_returned_by_value(function));
}

std::string driver_symbol(std::string_view driver, std::string_view scalar, std::size_t function) {
  return fmt::format("elgen_driver_{}_{}_{}", driver, scalar, function);
}

}  // namespace elgen
