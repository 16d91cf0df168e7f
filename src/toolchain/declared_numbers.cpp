// make_declaration_reader: the text of a function that writes all declared numbers, one after
// another. For the parameters m and l[2] in C++ it contains:
//
//     const emitted::Parameters<double> in_double{};
//     *to++ = static_cast<double>(in_double.l[1]);
//     *to++ = static_cast<double>(reinterpret_cast<const double*>(&in_double.l[1]) -
//                                 reinterpret_cast<const double*>(&in_double));
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "elgen/artifacts.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/sines.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

/// The patterns of the code that reads the declarations of a header, for one language.
struct DeclarationRow {
  ArtifactId header;            ///< the header that is read if the scene has no batch header
  std::string_view array;       ///< name of an array; {0}: namespace, {1}: unqualified name
  std::string_view size;        ///< size of the array {}
  std::string_view linkage;     ///< linkage of the function that writes the numbers
  std::string_view statement;   ///< statement that writes the number {}
  std::string_view constant;    ///< {0}: namespace, {1}: unqualified name, {2}: both in capitals
  std::string_view parameters;  ///< {0}: namespace, {1}: scalar, {2}: name, {3}: {0} in capitals
  std::string_view address;     ///< address of the variable {1} as pointer to the scalar {0}
};

/// The rows of the compiled languages, which come first in languages.def.
constexpr std::array declaration_table{
    DeclarationRow{ArtifactId::cpp, "::{0}::{1}", "{}.size()", "extern \"C\" ",
                   "  *to++ = static_cast<double>({});\n", "::{0}::{1}",
                   "static const ::{0}::Parameters<{1}> {2}{{}};\n",
                   "reinterpret_cast<const {0}*>(&{1})"},
    DeclarationRow{
        ArtifactId::c99, "{0}_{1}", "sizeof({0}) / sizeof(*{0})", "", "  *to++ = (double)({});\n",
        "{2}", "static const {0}_parameters {2} = {3}_DEFAULT_PARAMETERS;\n", "(const {0}*)&{1}"}};
static_assert(std::ssize(declaration_table) ==
              std::ranges::count(language_table, false, &LanguageRow::is_interpreted));

/// Builds a function that prints declared numbers, and the list of the numbers that it must print.
class DeclarationText {
 public:
  explicit DeclarationText(const DriverInput& input)
      : input_(input),
        row_(declaration_table[static_cast<std::size_t>(input.scene.emission.language)]) {}

  [[nodiscard]] DeclarationReader build() && {
    add_counts();
    for (const ScalarKind scalar : driver_scalars(input_)) add_parameters(scalar);
    add_arrays();
    const bool has_batch = input_.scene.emission.has_batch_header;
    if (has_batch) {
      for (const ScalarKind scalar : input_.scene.numerics.computed_scalars())
        add_trigonometry(scalar);
    }
    const ArtifactId header = has_batch ? ArtifactId::batch : row_.header;
    std::string text =
        fmt::format("#include \"{}\"\n{}", artifact_path(input_.scene, header), variables_);
    text += fmt::format("{0}void {1}(double* to);\n{0}void {1}(double* to) {{\n{2}}}\n",
                        row_.linkage, declarations_symbol, statements_);
    return {std::move(text), std::move(numbers_)};
  }

 private:
  void add_number(std::string name, const std::string& expression, double of_model) {
    statements_ += fmt::format(fmt::runtime(row_.statement), expression);
    numbers_.push_back({std::move(name), 0, of_model});
  }

  void add_count(const std::string& name, std::size_t count) {
    const std::string& space = name_space(input_.scene);
    const std::string in_capitals = upper_case(fmt::format("{}_{}", space, name));
    add_number(name, fmt::format(fmt::runtime(row_.constant), space, name, in_capitals),
               static_cast<double>(count));
  }

  void add_counts() {
    const Model& model = input_.model;
    add_count("coordinate_count", model.coordinates.size());
    add_count("velocity_count", model.velocities.size());
    add_count("input_count", model.inputs.size());
    if (!model.open_values.empty()) add_count("open_value_count", model.open_values.size());
    add_count("parameter_count", emitted_parameter_count(model, input_.program));
  }

  /// Adds the value and the position of each parameter, which show that members are in order and
  /// without padding.
  void add_parameters(ScalarKind scalar) {
    const auto arrays = emitted_parameters(input_.model, input_.program);
    if (arrays.empty()) return;
    const std::string type(name_of(scalar));
    const std::string& space = name_space(input_.scene);
    const std::string all = "in_" + type;
    variables_ += fmt::format(fmt::runtime(row_.parameters), space, type, all, upper_case(space));
    const auto address = [&](const std::string& of) {
      return fmt::format(fmt::runtime(row_.address), type, of);
    };
    std::size_t position = 0;
    for (const ParameterArray& array : arrays) {
      const std::vector<cln::cl_R> values = element_values(input_.model, array);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string member =
            array.is_array ? fmt::format("{}[{}]", array.name, i) : array.name;
        const std::string element = fmt::format("{}.{}", all, member);
        add_number(fmt::format("{} ({})", member, type), element, nearest_float(values[i], scalar));
        add_number(fmt::format("the place of {} ({})", member, type),
                   fmt::format("{} - {}", address(element), address(all)),
                   static_cast<double>(position++));
      }
    }
    add_number(fmt::format("the size of the parameters ({})", type),
               fmt::format("sizeof({}) / sizeof({})", all, type), static_cast<double>(position));
  }

  [[nodiscard]] static double nearest_float(const cln::cl_R& value, ScalarKind scalar) {
    return scalar == ScalarKind::single_precision ? ScalarTraits<float>::from_real(value)
                                                  : to_double(value);
  }

  /// Adds sizes and numbers of all arrays. Skips empty arrays in C, which has no arrays of zero
  /// elements.
  void add_arrays() {
    const auto expression = [this](const std::string& name) {
      return fmt::format(fmt::runtime(row_.array), name_space(input_.scene), name);
    };
    for (const DeclaredArray& array : declared_arrays(input_.model, input_.program)) {
      if (array.size() == 0 && row_.header == ArtifactId::c99) continue;
      add_number("the size of " + array.name,
                 fmt::format(fmt::runtime(row_.size), expression(array.name)),
                 static_cast<double>(array.size()));
      for (const DeclaredNumber& number : declared_numbers_of(array)) {
        add_number(number.name, expression(number.name), number.model_value);
      }
    }
  }

  /// Adds the constants of the angle reduction and of the polynomials in functions of packs. In
  /// sampled results a wrong last digit would rarely show.
  void add_trigonometry(ScalarKind scalar) {
    const std::string table = fmt::format("Trigonometry<{}>::", name_of(scalar));
    const Numerics& numerics = input_.scene.numerics;
    const bool is_own = has_batch_sine_tables(input_.scene, input_.program);
    const std::string space =
        fmt::format("::{}::{}detail::", name_space(input_.scene), is_own ? "batch::" : "");
    for (const SineConstant& number : sine_constants(numerics, SineArithmetic::packs, scalar)) {
      add_number(table + number.name, space + table + number.name,
                 nearest_float(exact_value(number.value), scalar));
    }
  }

  const DriverInput& input_;
  const DeclarationRow& row_;
  std::string variables_ = {};
  std::string statements_ = {};
  std::vector<DeclaredNumber> numbers_ = {};
};

}  // namespace

std::vector<DeclaredNumber> declared_numbers_of(const DeclaredArray& array) {
  using Double = ScalarTraits<double>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<DeclaredNumber> all;
  const auto add = [&](std::size_t i, std::string_view bound, double value) {
    all.push_back({fmt::format("{}[{}]{}", array.name, i, bound), 0, value});
  };
  for (std::size_t i = 0; i < array.numbers.size(); ++i) {
    add(i, "", Double::from_real(array.numbers[i]));
  }
  for (std::size_t i = 0; i < array.intervals.size(); ++i) {
    const std::optional<Interval>& interval = array.intervals[i];
    add(i, ".low", interval ? Double::from_real(interval->low) : -infinity);
    add(i, ".high", interval ? Double::from_real(interval->high) : infinity);
  }
  return all;
}

DeclarationReader make_declaration_reader(const DriverInput& input) {
  return DeclarationText(input).build();
}

}  // namespace elgen
