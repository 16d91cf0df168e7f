// eigen_dialect: sizes are numbers, because a model has several of one size.
#include "eigen_dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "definition.hpp"
#include "fields.hpp"

namespace elgen {
namespace {

constexpr std::array<std::string_view, 5> names{"eigen", "Eigen", "Argument", "Matrix", "Vector"};

}  // namespace

bool is_eigen_name(const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string EigenDialect::temporary(const std::string& name) const {
  return is_eigen_name(name) ? name + "_" : CppDialect::temporary(name);
}

/// std::array's braces mean something else to Eigen: every entry is assigned.
std::string EigenDialect::returned(const Function& function, const Function& ordered,
                                   const FunctionBody& body) const {
  const bool is_number =
      !gives_struct(function) && is_scalar(function.kind, function.fields.front());
  if (is_number || !is_returned(function)) {
    return CppDialect::returned(function, ordered, body);
  }
  return fmt::format("  {} result;\n{}  return result;\n", result_type(function),
                     assignments(*this, ordered, body));
}

std::string EigenDialect::element(std::uint32_t index) const { return fmt::format("({})", index); }

std::string EigenDialect::type_of_field(OutputKind kind, const Field& field) const {
  if (is_scalar(kind, field)) return "Scalar";
  if (field.columns == 1) return fmt::format("Vector<Scalar, {}>", field.rows);
  return fmt::format("Matrix<Scalar, {}, {}>", field.rows, field.columns);
}

std::string EigenDialect::type_of_argument(Argument argument) const {
  if (argument == Argument::parameters || argument == Argument::time) {
    return CppDialect::type_of_argument(argument);
  }
  return fmt::format("const Argument<Scalar, {}>&", argument_size(model(), argument));
}

}  // namespace elgen
