// Lagrangian -> text, for --dump formulate and specialise.
#include "elgen/lagrangian.hpp"
#include "formulate/print.hpp"

namespace elgen {

namespace {

void append_terms(std::string& text, const char* name, const std::vector<GiNaC::ex>& terms,
                  const ExpressionPrinter& print) {
  if (terms.empty()) return;
  text += std::string(name) + " =";
  const char* separator = " ";
  for (const GiNaC::ex& term : terms) {
    text += separator + print(term);
    separator = "\n    + ";
  }
  text += '\n';
}

}  // namespace

std::string dump(const Lagrangian& lagrangian) {
  const ExpressionPrinter print(lagrangian.definitions);
  std::string text = dump(lagrangian.definitions);
  for (const PointMass& mass : lagrangian.masses) {
    text += "mass " + print(mass.mass) + " at (" + print(mass.position[0]) + ", " +
            print(mass.position[1]) + ", " + print(mass.position[2]) + ")\n";
  }
  if (lagrangian.gravity) {
    const auto& g = *lagrangian.gravity;
    text += "gravity (" + print(g[0]) + ", " + print(g[1]) + ", " + print(g[2]) + ")\n";
  }
  append_terms(text, "T", lagrangian.kinetic, print);
  append_terms(text, "V", lagrangian.potential, print);
  append_terms(text, "D", lagrangian.dissipation, print);
  append_terms(text, "L", lagrangian.lagrangian, print);
  for (std::size_t i = 0; i < lagrangian.forces.size(); ++i) {
    if (lagrangian.forces[i].is_zero()) continue;
    text += "force on " + lagrangian.leaves.v[i] + " = " + print(lagrangian.forces[i]);
    text += '\n';
  }
  for (const NamedOutput& output : lagrangian.outputs) {
    append_terms(text, output.name.c_str(), output.values, print);
  }
  return text;
}

}  // namespace elgen
