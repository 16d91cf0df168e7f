// from_ginac: imports the needed definitions in the order of the list, each as a signed reference
// to a node. The node keeps the definition's name; later uses of the symbol refer to the node.
#include "derive/lower/from_ginac.hpp"

#include <cln/number.h>
#include <cln/real.h>
#include <fmt/core.h>

#include <algorithm>

#include "base/reason.hpp"
#include "elgen/equations_of_motion.hpp"

namespace elgen {
namespace {

class Importer {
 public:
  Importer(const EquationsOfMotion& equations, const OutputRequest& request)
      : equations_(equations), request_(request) {
    for_each_leaf(
        [this](Opcode kind, std::uint32_t number, const GiNaC::ex& symbol) {
          refs_by_symbol_[symbol] = graph.leaf(kind, number);
        },
        equations.symbols);
  }

  void import_definition(std::uint32_t position) {
    const Definition& definition = equations_.definitions.list[position];
    graph.set_creation_rank(position);
    const SignedNode value = import_expression(definition.value);
    graph.set_name(value, definition.name);
    refs_by_symbol_[definition.symbol] = value;
  }

  SignedNode import_expression(const GiNaC::ex& e) {
    if (GiNaC::is_a<GiNaC::symbol>(e)) return import_symbol(e);
    if (GiNaC::is_a<GiNaC::numeric>(e)) return import_number(GiNaC::ex_to<GiNaC::numeric>(e));
    if (GiNaC::is_a<GiNaC::add>(e)) return import_sum(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return import_product(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return graph.product(import_powers(e));
    if (GiNaC::is_a<GiNaC::function>(e)) return import_call(e);
    if (e.is_equal(GiNaC::Pi)) return graph.pi();
    return report_error(Reason::foreign_expression,
                        fmt::format("cannot import the GiNaC class `{}`", class_name(e)));
  }

  Graph graph = {};
  std::optional<Diagnostic> problem = {};  ///< the first error

 private:
  static std::string class_name(const GiNaC::ex& e) {
    return GiNaC::ex_to<GiNaC::basic>(e).class_name();
  }

  SignedNode report_error(Code code, std::string message) {
    if (!problem) problem = Diagnostic{code, request_.span, std::move(message)};
    return graph.rational(0);
  }

  SignedNode import_symbol(const GiNaC::ex& e) {
    const auto it = refs_by_symbol_.find(e);
    if (it != refs_by_symbol_.end()) return it->second;
    return report_error(Reason::foreign_expression,
                        fmt::format("symbol `{}` is not defined before its use",
                                    GiNaC::ex_to<GiNaC::symbol>(e).get_name()));
  }

  SignedNode import_number(const GiNaC::numeric& number) {
    if (!number.is_real())
      return report_error(Reason::unreal_number, "a complex number reached the equations");
    if (!number.is_rational())
      return report_error(Reason::unreal_number, "a rounded number reached the equations");
    return graph.rational(cln::the<cln::cl_RA>(number.to_cl_N()));
  }

  SignedNode import_sum(const GiNaC::ex& e) {
    std::vector<SignedNode> terms;
    for (std::size_t i = 0; i < e.nops(); ++i) terms.push_back(import_expression(e.op(i)));
    return graph.sum(terms);
  }

  SignedNode import_product(const GiNaC::ex& e) {
    std::vector<Power> factors;
    for (std::size_t i = 0; i < e.nops(); ++i) {
      const std::vector<Power> factor = import_powers(e.op(i));
      factors.insert(factors.end(), factor.begin(), factor.end());
    }
    return graph.product(factors);
  }

  /// The factors of a power: x^(5/2) = x^2 sqrt(x) for a half-integer exponent, else
  /// x^y = exp(y log x).
  std::vector<Power> import_powers(const GiNaC::ex& e) {
    if (!GiNaC::is_a<GiNaC::power>(e)) return {{import_expression(e), 1}};
    const SignedNode base = import_expression(e.op(0));
    const GiNaC::ex exponent = e.op(1);
    const bool is_half_integer =
        GiNaC::is_a<GiNaC::numeric>(exponent) && (exponent * 2).info(GiNaC::info_flags::integer);
    if (!is_half_integer) {
      const SignedNode log = graph.call(FunctionId::log, {base});
      return {{graph.call(FunctionId::exp, {graph.product({{import_expression(exponent)}, {log}})}),
               1}};
    }
    const int halves = GiNaC::ex_to<GiNaC::numeric>(exponent * 2).to_int();
    if (halves < 0 && graph.is_zero(base.node)) {
      report_error(Code::E312, "a denominator is 0");
      return {};
    }
    std::vector<Power> result;
    if (halves / 2 != 0) result.push_back({base, halves / 2});
    if (halves % 2 != 0) result.push_back({graph.square_root(base), halves % 2});
    return result;
  }

  SignedNode import_call(const GiNaC::ex& e) {
    std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    constexpr std::string_view own = "elgen_";
    if (name.rfind(own, 0) == 0) name.erase(0, own.size());
    if (name == "open") return import_open_value(e);
    std::vector<SignedNode> arguments;
    for (std::size_t i = 0; i < e.nops(); ++i) arguments.push_back(import_expression(e.op(i)));
    const FunctionRow* row = find_function(name);
    if (row != nullptr && row->arity == arguments.size()) return graph.call(row->id, arguments);
    return report_error(Reason::foreign_expression,
                        fmt::format("cannot import the GiNaC function `{}`", name));
  }

  /// Imports the value of an open function as a leaf; the arguments are not imported.
  SignedNode import_open_value(const GiNaC::ex& e) {
    const std::optional<std::uint32_t> number = open_value_number(e);
    if (number) return graph.leaf(Opcode::open_value, *number);
    return report_error(Reason::foreign_expression,
                        "a third derivative of an open function reached the equations");
  }

  const EquationsOfMotion& equations_;
  const OutputRequest& request_;
  ExpressionMap<SignedNode> refs_by_symbol_;
};

/// Marks the definitions whose symbols occur in e.
void mark_used_definitions(const GiNaC::ex& e, const ExpressionMap<std::uint32_t>& positions,
                           std::vector<bool>& needed) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    const auto it = positions.find(e);
    if (it != positions.end()) needed[it->second] = true;
    return;
  }
  for (std::size_t i = 0; i < e.nops(); ++i) mark_used_definitions(e.op(i), positions, needed);
}

std::vector<bool> needed_definitions(const Definitions& definitions,
                                     const std::vector<const OutputEquations*>& outputs) {
  ExpressionMap<std::uint32_t> positions;
  for (std::uint32_t i = 0; i < definitions.list.size(); ++i) {
    positions[definitions.list[i].symbol] = i;
  }
  std::vector<bool> needed(definitions.list.size(), false);
  for (const OutputEquations* output : outputs) {
    for (const FieldEquations& field : output->fields) {
      for (const GiNaC::ex& entry : field.entries) mark_used_definitions(entry, positions, needed);
    }
  }
  for (std::size_t i = needed.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (const std::uint32_t used : definitions.list[i].used_definitions) needed[used] = true;
  }
  return needed;
}

/// The outputs whose entries a request contains: the requested output itself, or for `dynamics` all
/// outputs that `dynamics` repeats.
std::vector<const OutputEquations*> requested_equations(const EquationsOfMotion& equations,
                                                        const OutputRequest& request) {
  std::vector<const OutputEquations*> wanted;
  for (const OutputEquations& output : equations.outputs) {
    const bool is_wanted =
        output_row(request.kind).is_summary
            ? is_in_dynamics(output.request.kind, output.request.argument_kinds)
            : output.request.kind == request.kind && output.request.user == request.user;
    if (is_wanted) wanted.push_back(&output);
  }
  return wanted;
}

/// Appends the entries of `outputs` to `values`, and returns the fields. A field keeps its name; a
/// field of `dynamics` gets the name of the repeated output.
std::vector<Field> import_fields(Importer& importer, const OutputRequest& request,
                                 const std::vector<const OutputEquations*>& outputs,
                                 std::vector<SignedNode>& values) {
  const bool repeats = output_row(request.kind).is_summary;
  std::vector<Field> fields;
  for (const OutputEquations* output : outputs) {
    for (const FieldEquations& equations : output->fields) {
      Field& field = fields.emplace_back(Field{
          repeats ? output->request.name : equations.name, equations.rows, equations.columns, {}});
      for (const GiNaC::ex& entry : equations.entries) {
        field.entries.push_back(static_cast<std::uint32_t>(values.size()));
        values.push_back(importer.import_expression(entry));
      }
    }
  }
  return fields;
}

}  // namespace

Result<ImportedOutput> from_ginac(const EquationsOfMotion& equations, const OutputRequest& request,
                                  std::uint64_t maximum_nodes) {
  const std::vector<const OutputEquations*> outputs = requested_equations(equations, request);
  if (outputs.empty()) {
    return Diagnostic{Reason::not_derived, request.span,
                      fmt::format("`{}` was not derived", request.name)};
  }
  Importer importer(equations, request);
  const std::vector<bool> needed = needed_definitions(equations.definitions, outputs);
  for (std::uint32_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) importer.import_definition(i);
    if (importer.problem) return *importer.problem;
    if (importer.graph.size() > maximum_nodes) return too_many_nodes_error(request, maximum_nodes);
  }
  importer.graph.set_creation_rank(static_cast<std::uint32_t>(needed.size()));
  ImportedOutput imported;
  imported.fields = import_fields(importer, request, outputs, imported.values);
  if (importer.problem) return *importer.problem;
  for (const OutputEquations* output : outputs) {
    const bool repeats = output_row(request.kind).is_summary;
    for (std::uint32_t i = 0; i < needed.size(); ++i) {
      const GiNaC::ex& symbol = equations.definitions.list[i].symbol;
      const auto value_name = output->value_names.find(symbol);
      if (!needed[i] || value_name == output->value_names.end()) continue;
      imported.intermediate_values.push_back(importer.import_expression(symbol));
      imported.value_names.push_back((repeats ? output->request.name + "_" : "") +
                                     value_name->second);
    }
  }
  imported.elimination = outputs.front()->elimination_order;
  imported.graph = std::move(importer.graph);
  return imported;
}

std::vector<const EquationsOfMotion*> find_routes(const EquationsOfMotion& equations,
                                                  const OutputRequest& request) {
  const auto has_output = [&](const EquationsOfMotion& route) {
    return std::ranges::any_of(route.outputs, [&](const OutputEquations& output) {
      return output.request.kind == request.kind;
    });
  };
  std::vector<const EquationsOfMotion*> routes;
  for (const EquationsOfMotion& other : equations.alternatives) {
    if (has_output(other)) routes.push_back(&other);
  }
  if (routes.empty() || has_output(equations)) routes.insert(routes.begin(), &equations);
  return routes;
}

Diagnostic too_many_nodes_error(const OutputRequest& request, std::uint64_t limit) {
  return {Code::E908, request.span,
          fmt::format("`{}` takes more than {} derived nodes", request.name, limit),
          "`--limit derived_nodes=N` raises the limit"};
}

LeafNames leaf_names(const EquationsOfMotion& equations) { return equations.leaves; }

}  // namespace elgen
