// declarations: a function gives the numbers one after another. For two parameters m and l[2] in
// C++:
//
//     const emitted::Parameters<double> in_double{};
//     *to++ = static_cast<double>(in_double.l[1]);
//     *to++ = static_cast<double>(reinterpret_cast<const double*>(&in_double.l[1]) -
//                                 reinterpret_cast<const double*>(&in_double));
#include <fmt/format.h>

#include <limits>
#include <utility>

#include "base/exact_number.hpp"
#include "elgen/artifacts.hpp"
#include "elgen/evaluate.hpp"
#include "evaluate/pack_trigonometry.hpp"
#include "lower/code_interface.hpp"
#include "toolchain/driver.hpp"

namespace elgen {
namespace {

/// A text while it grows, beside the numbers that it has to give.
class DeclarationText {
 public:
  explicit DeclarationText(const DriverInput& input)
      : input_(input), language_(input.scene.emission.language) {}

  [[nodiscard]] Declarations complete() && {
    add_counts();
    for (const ScalarKind scalar : driver_scalars(input_)) add_parameters(scalar);
    if (is_cpp()) add_intervals();
    const bool has_batch = input_.scene.emission.batch;
    if (has_batch) {
      for (const ScalarKind scalar : input_.scene.numerics.scalars) add_trigonometry(scalar);
    }
    const ArtifactId header = !is_cpp()   ? ArtifactId::c99
                              : has_batch ? ArtifactId::batch
                                          : ArtifactId::cpp;
    const std::string linkage = is_cpp() ? "extern \"C\" " : "";
    std::string text =
        fmt::format("#include \"{}\"\n{}", path_of(input_.scene, header), variables_);
    text += fmt::format("{0}void {1}(double* to);\n{0}void {1}(double* to) {{\n{2}}}\n", linkage,
                        declarations_symbol, statements_);
    return {std::move(text), std::move(numbers_)};
  }

 private:
  [[nodiscard]] bool is_cpp() const { return language_ == LanguageId::cpp; }

  void add(std::string name, const std::string& expression, double of_model) {
    const char* const pattern =
        is_cpp() ? "  *to++ = static_cast<double>({});\n" : "  *to++ = (double)({});\n";
    statements_ += fmt::format(fmt::runtime(pattern), expression);
    numbers_.push_back({std::move(name), 0, of_model});
  }

  void add_count(const std::string& name, std::size_t count) {
    const std::string& space = name_space(input_.scene);
    const std::string constant = is_cpp() ? fmt::format("::{}::{}", space, name)
                                          : capitals(fmt::format("{}_{}", space, name));
    add(name, constant, static_cast<double>(count));
  }

  void add_counts() {
    const Model& model = input_.model;
    add_count("coordinate_count", model.coordinates.size());
    add_count("velocity_count", model.velocities.size());
    add_count("input_count", model.inputs.size());
    if (!model.open_values.empty()) add_count("open_value_count", model.open_values.size());
    add_count("parameter_count", emitted_parameter_count(model, input_.program));
  }

  /// The values of the model, in their order and without anything between them.
  void add_parameters(ScalarKind scalar) {
    const auto arrays = emitted_parameters(input_.model, input_.program);
    if (arrays.empty()) return;
    const std::string type(name_of(scalar));
    const std::string& space = name_space(input_.scene);
    const std::string all = "in_" + type;
    variables_ += is_cpp()
                      ? fmt::format("static const ::{}::Parameters<{}> {}{{}};\n", space, type, all)
                      : fmt::format("static const {}_parameters {} = {}_DEFAULT_PARAMETERS;\n",
                                    space, all, capitals(space));
    const auto address = [&](const std::string& of) {
      return is_cpp() ? fmt::format("reinterpret_cast<const {}*>(&{})", type, of)
                      : fmt::format("(const {}*)&{}", type, of);
    };
    std::size_t position = 0;
    for (const ParameterArray& array : arrays) {
      const std::vector<cln::cl_R> values = values_of(input_.model, array);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string member =
            array.is_array ? fmt::format("{}[{}]", array.name, i) : array.name;
        const std::string element = fmt::format("{}.{}", all, member);
        add(fmt::format("{} ({})", member, type), element, nearest(values[i], scalar));
        add(fmt::format("the place of {} ({})", member, type),
            fmt::format("{} - {}", address(element), address(all)),
            static_cast<double>(position++));
      }
    }
    add(fmt::format("the size of the parameters ({})", type),
        fmt::format("sizeof({}) / sizeof({})", all, type), static_cast<double>(position));
  }

  [[nodiscard]] static double nearest(const cln::cl_R& value, ScalarKind scalar) {
    return scalar == ScalarKind::single_precision ? ScalarTraits<float>::from_real(value)
                                                  : ScalarTraits<double>::from_real(value);
  }

  void add_intervals() {
    const std::string space = "::" + name_space(input_.scene) + "::";
    for (const DeclaredArray& array : declared_arrays(input_.model)) {
      add("the size of " + array.name, space + array.name + ".size()",
          static_cast<double>(array.size()));
      for (std::size_t i = 0; i < array.intervals.size(); ++i) {
        const std::optional<Interval>& interval = array.intervals[i];
        const std::string element = fmt::format("{}[{}]", array.name, i);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        add(element + ".low", space + element + ".low",
            interval ? ScalarTraits<double>::from_real(interval->low) : -infinity);
        add(element + ".high", space + element + ".high",
            interval ? ScalarTraits<double>::from_real(interval->high) : infinity);
      }
    }
  }

  /// How packs reduce angles, and their polynomials: a last digit shows in few results.
  void add_trigonometry(ScalarKind scalar) {
    const std::string table = fmt::format("Trigonometry<{}>::", name_of(scalar));
    const std::string space = fmt::format("::{}::batch::detail::", name_space(input_.scene));
    const auto add_number = [&](const std::string& name, double value) {
      add(table + name, space + table + name, nearest(exact_value(value), scalar));
    };
    const AngleReduction& reduction = angle_reduction(scalar);
    add_number("domain", reduction.domain);
    add_number("high", reduction.high);
    add_number("low", reduction.low);
    add_number("inverse", reduction.inverse);
    add_number("shift", reduction.shift);
    const cln::cl_RA error = trigonometry_error(input_.scene.numerics, scalar);
    for (const auto& [name, all] :
         {std::pair("sine", sine_polynomials()), std::pair("cosine", cosine_polynomials())}) {
      const std::vector<double> coefficients = cheapest(all, error, scalar).coefficients;
      for (std::size_t i = 0; i < coefficients.size(); ++i) {
        add_number(fmt::format("{}[{}]", name, i), coefficients[i]);
      }
    }
  }

  const DriverInput& input_;
  LanguageId language_;
  std::string variables_ = {};
  std::string statements_ = {};
  std::vector<DeclaredNumber> numbers_ = {};
};

}  // namespace

Declarations declarations(const DriverInput& input) { return DeclarationText(input).complete(); }

}  // namespace elgen
