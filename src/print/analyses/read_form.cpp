// A closed form is treated like an entry of an output: written as in a book, or by its shortest
// rewriting where it is long, turned into a function, and read from that.
#include "print/analyses/read_form.hpp"

#include "elgen/page.hpp"
#include "elgen/typeset.hpp"

namespace elgen {

std::optional<Formula> read_form(const Model& model, const Algebra& algebra,
                                 const std::optional<Fraction>& form) {
  if (!form) return std::nullopt;
  LeafNames leaves = leaf_names(model);
  leaves.momenta = leaves.v;
  leaves.E = energy_name(model);
  Program program{leaves};
  Function function = typeset_value(model, algebra, *form, program);
  if (function.fields.empty()) return std::nullopt;
  program.functions = {function};
  program.readable = {std::move(function)};
  return first_entry(model, program);
}

}  // namespace elgen
