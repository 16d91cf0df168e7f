// E508: an inertia that no body has; a planar one is a number that is not negative.
#include <fmt/format.h>

#include "elgen/inertia.hpp"
#include "elgen/oracle.hpp"
#include "inspect/checks.hpp"
#include "inspect/readable.hpp"

namespace elgen {
namespace {

using cln::cl_R;

std::optional<std::vector<cl_R>> values_of(const Inspected& subject, const Body& body) {
  const State state = nominal_state(subject.model, subject.scene);
  std::vector<cl_R> values;
  for (const ExpressionId id : body.inertia) {
    const auto value = oracle_expression(subject.model, id, state);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

bool is_possible(const std::vector<cl_R>& inertia) {
  if (inertia.size() < 6) return inertia[0] >= 0;
  return is_of_a_body({inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]});
}

std::string listed(const std::vector<cl_R>& values) {
  std::string text;
  for (const cl_R& value : values) text += (text.empty() ? "" : ", ") + as_typed(value);
  return text;
}

}  // namespace

Diagnostics inspect_inertias(const Inspected& subject) {
  Diagnostics diagnostics;
  for (const Body& body : subject.model.bodies) {
    if (body.inertia.empty()) continue;
    const auto inertia = values_of(subject, body);
    if (!inertia || is_possible(*inertia)) continue;
    diagnostics.push_back(
        {Code::E508, body.span,
         fmt::format("inertia {} of `{}` belongs to no body", listed(*inertia), body.name),
         body.inertia.size() < 6 ? "it is negative"
                                 : "a principal inertia exceeds the sum of the other two"});
  }
  return diagnostics;
}

}  // namespace elgen
