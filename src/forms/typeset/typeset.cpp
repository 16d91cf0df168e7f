// typeset: see elgen/typeset.hpp. This file decides the content of each sum. arrange.hpp arranges
// sums, and write.hpp converts them to instructions.
#include "elgen/typeset.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "forms/present/arithmetic.hpp"
#include "forms/typeset/equations.hpp"
#include "forms/typeset/write.hpp"
#include "forms/write/rewritings.hpp"

namespace elgen {
namespace {

bool is_short_when_expanded(const Function& function) {
  const std::vector<std::size_t> sizes = expanded_sizes(function, longest_textbook_entry);
  return std::ranges::all_of(entries_of(function), [&sizes](std::uint32_t entry) {
    return sizes[entry] <= longest_textbook_entry;
  });
}

/// `like` with the fields that `write` adds; without fields if an entry is too long to be read.
template <class Write>
Function write_function(const Function& like, const Write& write) {
  Function result = without_body(like);
  result.form = Form::closed;
  try {
    write(result);
    if (!is_short_when_expanded(result)) throw TextbookLengthError();
  } catch (const std::length_error&) {
    result.fields.clear();
    result.instructions.clear();
    result.names.clear();
    return result;
  }
  return eliminate_dead_code(result);
}

/// The most terms of a typeset form, counted as exponentials: about twice as many terms as anyone
/// reads. Longer entries, such as accelerations of arms and their derivatives, keep the shortest
/// form that choose() found.
constexpr std::size_t longest_form = 120;

bool is_short_form(const std::optional<Fraction>& form) {
  return form && form->numerator.size() <= longest_form;
}

const Fraction& readable_form_or_throw(const std::optional<Fraction>& form) {
  if (!is_short_form(form)) throw TextbookLengthError();
  return *form;
}

/// True for an output of forces, which is set like an equation: collected by rates, without common
/// factors.
bool is_sum_of_forces(OutputKind kind) {
  const std::span<const FieldRow> fields = output_row(kind).fields;
  return fields.size() == 1 && fields.front().type == "Forces<Scalar>";
}

/// `fields[place]` if this field has the name `name`, which may be empty; otherwise the first field
/// with this name. `place` counts fields of a program, which may lack fields that readers do not
/// see. Throws TextbookLengthError if no field has the name.
const ClosedField& find_closed_field(const std::vector<ClosedField>& fields, std::size_t place,
                                     const std::string& name) {
  if (place < fields.size() && fields[place].name == name) return fields[place];
  const auto found = std::ranges::find(fields, name, &ClosedField::name);
  if (found == fields.end()) throw TextbookLengthError();
  return *found;
}

std::vector<Fraction> summands(const ClosedField& field) {
  std::vector<Fraction> result;
  for (const std::optional<Fraction>& entry : field.entries) {
    result.push_back(readable_form_or_throw(entry));
  }
  return result;
}

void add_scalar_field(Function& function, const std::string& name, std::uint32_t entry) {
  function.fields.push_back({name, 1, 1, {entry}});
}

/// An acceleration of more written factors than this is not easier to read than its equation.
constexpr std::size_t longest_solution = 40;

class Typesetter {
 public:
  Typesetter(const CheckedModel& checked, const ClosedForms& forms, Program& program)
      : model_(checked.model),
        forms_(forms),
        program_(program),
        algebra_(forms.algebra),
        typed_(typed_forms(algebra_, model_, checked.scene.specialisation.fixed)) {}

  /// Writes an output. An entry that is too long keeps its readable form.
  Function write_output(std::size_t index) {
    const Function& function = program_.functions[index];
    const bool is_read =
        index < program_.readable.size() && !program_.readable[index].fields.empty();
    const std::vector<ClosedField>& fields = forms_.functions[index].fields;
    return write_function(function, [&](Function& result) {
      TextbookWriter write(model_, algebra_, typed_, program_, result);
      for (std::size_t f = 0; f < function.fields.size(); ++f) {
        Field& field = result.fields.emplace_back(function.fields[f]);
        const ClosedField& closed = find_closed_field(fields, f, field.name);
        for (std::uint32_t i = 0; i < field.entries.size(); ++i) {
          const std::optional<std::uint32_t> entry =
              write_entry(write, closed.entries[i], function.kind, i);
          if (!entry && !is_read) throw TextbookLengthError();
          field.entries[i] = entry ? *entry : copy_entry(write, index, f, i);
        }
      }
      write.name_shared_divisors();
    });
  }

  Function write_energies(std::size_t index) {
    return write_function(program_.functions[index], [&](Function& result) {
      TextbookWriter write(model_, algebra_, typed_, program_, result);
      const std::vector<ClosedField>& fields = forms_.functions[index].fields;
      TextbookSum whole;
      for (const ClosedField& field : fields) {
        TextbookSum sum = write.arranger.factor_out_each(summands(field));
        add_scalar_field(result, field.name, write(sum));
        for (TextbookProduct& term : sum.terms) {
          if (field.name == "V") term.number = -term.number;
          whole.terms.push_back(std::move(term));
        }
      }
      if (fields.size() > 1) add_scalar_field(result, "L", write(whole));
    });
  }

  /// Writes the fields (LagrangeStepField) of Lagrange's equation for one velocity. A field that is
  /// too long has no entries; if all are too long, the function has no fields.
  Function write_equation(std::size_t index, std::uint32_t velocity) {
    Function result = without_body(program_.functions[index]);
    result.form = Form::closed;
    TextbookWriter write(model_, algebra_, typed_, program_, result);
    EquationArranger equations(algebra_, write.arranger);
    const auto add_field = [&](const std::string& name, const auto& arrange) {
      Field& field = result.fields.emplace_back(Field{name, 1, 1, {}});
      try {
        const std::uint32_t entry = write(arrange());
        const std::size_t size = expanded_sizes(result, longest_textbook_entry)[entry];
        if (size <= longest_textbook_entry) field.entries = {entry};
      } catch (const std::length_error&) {
        // The field keeps the definitions of the derivation.
      }
    };
    for (const ClosedField& field : forms_.functions[index].fields) {
      add_field(field.name, [&] { return equations.arrange_row(summands(field), velocity); });
    }
    add_field("left", [&] {
      const auto row = equations.read_row(forms_.functions[index]);
      if (!row) throw TextbookLengthError();
      return equations.arrange_left_side(*row, velocity);
    });
    if (entries_of(result).empty()) result.fields.clear();
    return eliminate_dead_code(result);
  }

  Function write_accelerations(std::size_t first) {
    Function like;
    like.kind = OutputKind::user_value;
    like.name = "accelerations";
    return write_function(like, [&](Function& result) {
      TextbookWriter write(model_, algebra_, typed_, program_, result);
      EquationArranger equations(algebra_, write.arranger);
      const auto rows = equation_rows(equations, first);
      for (std::uint32_t i = 0; i < rows.size(); ++i) {
        Field& field = result.fields.emplace_back(Field{model_.velocities[i].name, 0, 1, {}});
        // An expanded model gets no accelerations, because a quotient would need the dropped terms.
        // A model with constraints gets no accelerations, because the multipliers are unknown.
        if (model_.approximation || !model_.constraints.empty()) continue;
        const std::optional<TextbookSum> solution = equations.solve_acceleration(rows, i);
        if (!solution || count_written_factors(*solution) > longest_solution) continue;
        field.rows = 1;
        field.entries = {write(*solution)};
      }
      write.name_shared_divisors();
    });
  }

  Function write_invariants(std::size_t index) {
    return write_function(program_.functions[index], [&](Function& result) {
      TextbookWriter write(model_, algebra_, typed_, program_, result);
      EquationArranger equations(algebra_, write.arranger);
      for (const ClosedField& field : forms_.functions[index].fields) {
        add_scalar_field(result, field.name, write(equations.arrange_summands(summands(field))));
      }
    });
  }

 private:
  [[nodiscard]] std::uint32_t copy_entry(TextbookWriter& write, std::size_t index,
                                         std::size_t field, std::size_t entry) const {
    const Function& known = program_.readable[index];
    return write.copy_instruction(known, known.fields[field].entries[entry]);
  }

  /// Writes an entry and returns its instruction; none if the entry is too long.
  static std::optional<std::uint32_t> write_entry(TextbookWriter& write,
                                                  const std::optional<Fraction>& form,
                                                  OutputKind kind, std::uint32_t row) {
    if (!is_short_form(form)) return std::nullopt;
    try {
      return write(is_sum_of_forces(kind) ? write.arranger.collect_by_rates(*form, row)
                                          : write.arranger.split_by_motion(*form));
    } catch (const TextbookLengthError&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] std::vector<std::optional<EquationRow>> equation_rows(EquationArranger& equations,
                                                                      std::size_t first) const {
    std::vector<std::optional<EquationRow>> rows;
    for (std::size_t i = 0; i < model_.velocities.size(); ++i) {
      rows.push_back(equations.read_row(forms_.functions[first + i]));
    }
    return rows;
  }

  const Model& model_;
  const ClosedForms& forms_;
  Program& program_;
  Algebra algebra_;
  TypedForms typed_;
};

}  // namespace

bool is_readable(const ClosedFunction& function) {
  return std::ranges::all_of(function.fields, [](const ClosedField& field) {
    return std::ranges::all_of(field.entries, is_short_form);
  });
}

bool has_short_entry(const ClosedFunction& function) {
  return std::ranges::any_of(function.fields, [](const ClosedField& field) {
    return std::ranges::any_of(field.entries, is_short_form);
  });
}

Program typeset(const CheckedModel& checked, const ClosedForms& forms, Program program) {
  if (checked.model.approximation || has_routhian(checked.model)) return program;
  if (std::ranges::none_of(forms.functions, has_short_entry)) return program;
  Typesetter typesetting(checked, forms, program);
  program.readable.resize(program.functions.size());
  for (std::size_t i = 0; i < forms.functions.size(); ++i) {
    Function read = typesetting.write_output(i);
    if (!read.fields.empty()) program.readable[i] = std::move(read);
  }
  return program;
}

namespace {

/// Replaces the summands of each field by their sum, and appends d/dt dL/dv - dL/dq + dD/dv for a
/// velocity, or L = T - V for energies. Pages print these sums if there is no closed form.
Function replace_summands_by_sum(Program& program, Function function, bool is_velocity) {
  InstructionBuilder instructions(function);
  const auto zero = intern_constant(rational_constant(0), program.constants);
  for (Field& field : function.fields) {
    std::optional<std::uint32_t> total;
    for (const std::uint32_t term : field.entries) {
      if (loads_zero(program, function.instructions[term])) continue;
      total = total ? instructions.add(Opcode::add, *total, term) : term;
    }
    field = {field.name, 1, 1, {total ? *total : instructions.add(Opcode::constant, zero)}};
  }
  const auto entry = [&function](std::size_t field) { return function.fields[field].entries[0]; };
  if (is_velocity) {
    const auto of = [&entry](LagrangeStepField line) {
      return entry(static_cast<std::size_t>(line));
    };
    const auto with_term = [&](Opcode sign, std::uint32_t sum, std::uint32_t term) {
      const bool is_zero = loads_zero(program, function.instructions[term]);
      return is_zero ? sum : instructions.add(sign, sum, term);
    };
    const std::uint32_t inertia = with_term(Opcode::subtract, of(LagrangeStepField::momentum_rate),
                                            of(LagrangeStepField::partial));
    const std::uint32_t left = with_term(Opcode::add, inertia, of(LagrangeStepField::dissipation));
    function.fields.push_back({"left", 1, 1, {left}});
  } else if (function.fields.size() == 2 && function.fields[1].name == "V") {
    const std::uint32_t whole = instructions.add(Opcode::subtract, entry(0), entry(1));
    function.fields.push_back({"L", 1, 1, {whole}});
  }
  return eliminate_dead_code(function);
}

}  // namespace

Program typeset_derivation(const CheckedModel& checked, const ClosedForms& forms, Program derived) {
  Typesetter typesetting(checked, forms, derived);
  const std::size_t count = derived.functions.size();
  const std::size_t velocities = checked.model.velocities.size();
  const std::size_t first = count - 1 - velocities;
  for (std::size_t i = 0; i + 1 < first; ++i)
    derived.readable.push_back(typesetting.write_output(i));
  derived.readable.push_back(typesetting.write_energies(first - 1));
  for (std::size_t i = 0; i < velocities; ++i) {
    derived.readable.push_back(
        typesetting.write_equation(first + i, static_cast<std::uint32_t>(i)));
  }
  derived.readable.push_back(typesetting.write_invariants(count - 1));
  derived.readable.push_back(typesetting.write_accelerations(first));
  for (std::size_t i = first - 1; i < count; ++i) {
    derived.functions[i] = replace_summands_by_sum(derived, std::move(derived.functions[i]),
                                                   i >= first && i + 1 < count);
  }
  Function unsolved = derived.readable.back();
  if (unsolved.fields.empty()) unsolved.fields.resize(velocities, Field{"", 0, 1, {}});
  derived.functions.push_back(std::move(unsolved));
  return derived;
}

Function typeset_value(const Model& model, const Algebra& algebra, const Fraction& form,
                       Program& program) {
  Algebra own = algebra;
  TypedForms typed = typed_forms(own, model, {});
  for (TypedSum& sum : typed.sums) sum.definition.reset();
  typed.prescribed_values.clear();
  const Function shape{.fields = {Field{"", 1, 1, {0}}}};
  Function book = write_function(shape, [&](Function& result) {
    TextbookWriter write(model, own, typed, program, result);
    add_scalar_field(result, "", write(write.arranger.split_by_motion(form)));
  });
  if (!book.fields.empty()) return book;
  const auto read = choose_readable_form(rewritings_of(algebra, form).collected, nullptr,
                                         mixed_magnitude_points(program.leaves));
  return read ? lower_separately({read}, shape, program) : book;
}

}  // namespace elgen
