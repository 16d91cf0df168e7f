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
std::set<std::string> emitted_names(const DriverInput& input) {
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

std::size_t length_of(const Program& program) {
  std::size_t length = 0;
  for (const Function& function : program.functions) length += function.instructions.size();
  return length;
}

bool is_generic(const Scene& scene) {
  return language_row(scene.emission.language).scalars == LanguageScalars::any;
}

/// Writes a driver; null in a table if the build does not compile the header.
using DriverText = std::string (*)(const DriverInput& input);

struct DriverRow {
  const char* types;
  const char* name;
  const char* needs;
  DriverText text;
  DriverText as_users;
  bool in_packs = false;
  bool is_wide = false;
};

constexpr DriverRow no_code{"", "", "", nullptr, nullptr};
constexpr PerArtifact<DriverRow> driver_table{
    .cpp = {"", "cpp", "", &cpp_driver, &cpp_driver},
    .eigen = {"Eigen", "eigen", "Eigen/Core", &eigen_driver, nullptr},
    .batch = {"batch", "batch", "", &batch_driver, &sine_driver, true},
    .wide = {"wide", "wide", "", &wide_driver, &wide_driver, false, true},
    .c99 = {"", "c99", "", &c99_driver, &c99_driver},
    .source = no_code,
    .sidecar = no_code,
    .page = no_code};

}  // namespace

std::string declared_leaves(std::string_view scalar, std::string_view attribute) {
  std::string text;
  for (const LeafRow& leaf : leaf_table()) {
    const char* const pattern = is_single(leaf.id) ? "{}{} {}, " : "{}const {}* {}, ";
    text += fmt::format(fmt::runtime(pattern), attribute, scalar, leaf.member);
  }
  return text;
}

std::string parameter_assignments(const DriverInput& input) {
  const LeafNames& leaves = input.program.leaves;
  const std::vector<std::string> members = parameter_members(input.model, leaves);
  const std::set<std::string> emitted = emitted_names(input);
  std::string text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (emitted.count(leaves.parameters[i]) == 0) continue;
    text += fmt::format("  result.{} = values[{}];\n", members[i], i);
  }
  return text;
}

std::string_view stored_position(const Scene& scene) {
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

std::vector<Driver> drivers(const DriverInput& input, Build build) {
  std::vector<Driver> result;
  for (const Artifact& artifact : artifacts_of(input.scene)) {
    const DriverRow& row = driver_table[artifact.id];
    const DriverText text = build == Build::user_flags ? row.as_users : row.text;
    if (text == nullptr) continue;
    result.push_back({row.types, row.name, text(input), row.needs, row.in_packs, row.is_wide,
                      text != &sine_driver});
  }
  return result;
}

std::vector<DriverUnit> units_of(const DriverInput& input, Build build, const std::string& more) {
  const bool is_long = length_of(input.program) > max_unit_length;
  std::vector<DriverUnit> units;
  for (Driver& driver : drivers(input, build)) {
    if (units.empty() || (is_long && driver.has_functions)) {
      units.push_back({{}, build, {}});
      units.back().source.file =
          fmt::format("driver_{}_{}.{}", static_cast<int>(build), units.size(),
                      language_row(input.scene.emission.language).ending);
    }
    Source& source = units.back().source;
    const std::string& needs = driver.needs;
    source.text += needs.empty()
                       ? driver.text
                       : fmt::format("#if __has_include(<{}>)\n{}#endif\n", needs, driver.text);
    if (!needs.empty()) source.needs = needs;
    units.back().drivers.push_back(std::move(driver));
  }
  units.front().source.text += more;
  return units;
}

std::vector<ScalarKind> driver_scalars(const DriverInput& input) {
  if (!is_generic(input.scene)) return input.scene.numerics.scalars;
  std::vector<ScalarKind> scalars{ScalarKind::double_precision};
  constexpr ScalarKind other = ScalarKind::single_precision;
  if (fits(input.model, input.program, other)) scalars.push_back(other);
  return scalars;
}

std::vector<ScalarKind> scalars_of(const Driver& driver, const DriverInput& input) {
  return driver.in_packs || driver.is_wide ? input.scene.numerics.scalars : driver_scalars(input);
}

bool is_wrapped(const Driver& driver, const Function& function) {
  const bool returns_by_value = driver.in_packs || driver.is_wide;
  return driver.has_functions && (!returns_by_value || is_returned(function));
}

std::string driver_symbol(std::string_view driver, std::string_view scalar, std::size_t function) {
  return fmt::format("elgen_driver_{}_{}_{}", driver, scalar, function);
}

}  // namespace elgen
