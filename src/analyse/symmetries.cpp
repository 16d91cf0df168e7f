// Finds a basis of generators by closed forms, else by sampling. For each generator, computes the
// conserved quantity and proves dL = dF/dt, with L = v.dL/dv - E.
#include <cln/integer.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analyse/exact_generators.hpp"
#include "analyse/formulas.hpp"
#include "analyse/sampled_generators.hpp"
#include "analyse/symmetry_basis.hpp"
#include "analyse/total_integral.hpp"
#include "elgen/analyse.hpp"
#include "forms/present/polynomial.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using cln::cl_RA;
constexpr std::size_t most_unknowns = 500;

using Entries = std::vector<OptionalFraction>;

/// The closed forms of the functions of a motion.
struct MotionForms {
  const Model& model;
  const Program& program;
  ClosedForms& forms;

  /// The entries of a function, or `count` zeros if the program does not have the function.
  [[nodiscard]] Entries entries(OutputKind kind, std::size_t count = 1) const {
    for (std::size_t i = 0; i < program.functions.size(); ++i) {
      if (program.functions[i].kind != kind) continue;
      const ClosedField& field = forms.functions[i].fields[0];
      return {field.entries.begin(), field.entries.end()};
    }
    return Entries(count, Fraction{});
  }
  [[nodiscard]] Entries velocity_entries(OutputKind kind) const {
    return entries(kind, model.velocities.size());
  }
};

void negate_symmetry(const FormField& field, Symmetry& symmetry) {
  symmetry.momentum_form = field.negate(symmetry.momentum_form).value();
  for (OptionalFraction* const value : {&symmetry.velocity_form, &symmetry.gauge_function,
                                        &symmetry.unforced_rate, &symmetry.rate}) {
    *value = field.negate(*value);
  }
}

/// p.dq - E dt.
OptionalFraction noether_integral(FormField& field, const Entries& displacement,
                                  const Entries& momentum, const Fraction& time,
                                  const OptionalFraction& energy) {
  OptionalFraction sum =
      field.negate(FormField::is_zero(time) ? FormField::integer(0) : field.multiply(time, energy));
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    if (FormField::is_zero(displacement[i])) continue;
    sum = field.add(sum, field.multiply(displacement[i], momentum[i]));
  }
  return sum;
}

/// The power of an atom, reduced by w^2 = 1 - x^2 - y^2 - z^2 for each rotation.
OptionalFraction reduce_quaternion_power(FormField& field, const Algebra& algebra,
                                         const GeneratorLayout& all, AtomPower power) {
  const Atom& atom = algebra.atoms[power.atom];
  const bool is_scalar_part =
      atom.kind == AtomKind::leaf && atom.leaf == Opcode::coordinate &&
      std::ranges::any_of(all.rotations, [&](const GeneratorLayout::RotationIndices& place) {
        return place.first_coordinate == atom.index;
      });
  const std::uint32_t first = atom.index;
  OptionalFraction result = FormField::integer(1);
  for (; is_scalar_part && power.exponent >= 2; power.exponent -= 2) {
    OptionalFraction rest = FormField::integer(1);
    for (std::uint32_t i = 1; i <= axis_count; ++i) {
      const OptionalFraction x = field.leaf(Opcode::coordinate, first + i);
      rest = field.subtract(rest, field.multiply(x, x));
    }
    result = field.multiply(result, rest);
  }
  if (power.exponent == 0) return result;
  return field.multiply(result, fraction_of(Polynomial{{Monomial{power}, GaussianRational{1, 0}}}));
}

/// Reduces the numerator by w^2 = 1 - x^2 - y^2 - z^2.
OptionalFraction reduce_quaternions(Algebra& algebra, const GeneratorLayout& all,
                                    const Fraction& form) {
  if (all.rotations.empty()) return form;
  FormField field(algebra);
  Fraction over{{{Monomial{}, GaussianRational{1, 0}}}, form.denominator};
  OptionalFraction sum = Fraction{};
  for (const auto& [monomial, coefficient] : form.numerator) {
    OptionalFraction term = fraction_of(Polynomial{{Monomial{}, coefficient}});
    for (const AtomPower& power : monomial)
      term = field.multiply(term, reduce_quaternion_power(field, algebra, all, power));
    sum = field.add(sum, term);
  }
  return field.multiply(sum, over);
}

bool keeps_lagrangian_at(const SystemUnderTest& subject, const Algebra& algebra,
                         const Generator& generator, const State& state) {
  constexpr double noise = 1e-90;
  RealField field;
  ExactValues values(subject, state);
  std::vector<Real> unknowns;
  for (const Fraction& entry : generator) {
    unknowns.push_back(evaluate_form(algebra, entry, values.arguments()));
  }
  const PointChange<Real> change =
      apply_generator(field, GeneratorLayout(subject.model), motion_point_at(values), unknowns);
  Arguments<Real> direction = values.zero_direction();
  direction.q = values.coordinate_rates(change.position);
  direction.v = change.velocity;
  direction.t = unknowns.back();
  const Arguments<Real>& at = values.arguments();
  const std::vector<Real>& momentum = values.entries(OutputKind::momentum);
  const std::vector<Real> slopes = values.directional_derivatives(OutputKind::momentum, direction);
  Real size = abs(values.entries_at(OutputKind::energy_function, at)[0]);
  ResidualSums balance(1);
  balance.add(0, -values.directional_derivatives(OutputKind::energy_function, direction)[0]);
  for (std::size_t i = 0; i < momentum.size(); ++i) {
    size = size + abs(at.v[i] * momentum[i]);
    balance.add(0, change.velocity[i] * momentum[i]);
    balance.add(0, at.v[i] * slopes[i]);
  }
  const std::optional<double> figure =
      balance.relative_residual(size);  // |dL| relative to v.p and E
  return figure && *figure < noise;
}

/// True if dL = 0 at all `states`: the generator does not change L, so F = 0.
bool keeps_lagrangian(const SystemUnderTest& subject, const Algebra& algebra,
                      const Generator& generator, const std::vector<State>& states) {
  return with_digits(sampling_digits, [&] {
    return std::ranges::all_of(states, [&](const State& state) {
      return keeps_lagrangian_at(subject, algebra, generator, state);
    });
  });
}

/// The generator with the unknowns `numbers`. A number that equals a simple fraction to 35 digits
/// becomes the fraction. Any other number is rounded to six digits, and `is_rounded` is set.
Generator rationalise_generator(const std::vector<cl_R>& numbers, bool& is_rounded) {
  static const cln::cl_I largest = cln::expt_pos(cln::cl_I(10), 9);
  static const cl_RA near = power_of_ten(-35);
  Generator generator;
  for (const cl_R& number : numbers) {
    const std::optional<cl_RA> exact = simple_fraction(number, largest, near);
    is_rounded = is_rounded || !exact;
    generator.push_back(fraction_of(exact ? *exact : round_to_digits(number, 6)));
  }
  return generator;
}

/// Sets `rate` to (dq - v dt).(B u + Q - dD/dv), and `unforced_rate` to the same without B u.
void add_rates(FormField& field, const MotionForms& motion, const Entries& displacement,
               Symmetry& symmetry) {
  const std::size_t n = motion.model.velocities.size();
  const std::size_t inputs = motion.model.inputs.size();
  const Entries dissipation = motion.velocity_entries(OutputKind::dissipation);
  const Entries force = motion.velocity_entries(OutputKind::applied_force);
  const Entries by_input = motion.entries(OutputKind::input_matrix, n * inputs);
  OptionalFraction loss = Fraction{};
  OptionalFraction work = Fraction{};
  for (std::uint32_t i = 0; i < n; ++i) {
    const OptionalFraction passed =
        field.multiply(symmetry.generator.back(), field.leaf(Opcode::velocity, i));
    const OptionalFraction along = field.subtract(displacement[i], passed);
    if (FormField::is_zero(along)) continue;
    const OptionalFraction own = field.subtract(force[i], dissipation[i]);
    loss = field.add(loss, field.multiply(along, own));
    for (std::uint32_t k = 0; k < inputs; ++k) {
      const OptionalFraction input =
          field.multiply(by_input[i * inputs + k], field.leaf(Opcode::input, k));
      work = field.add(work, field.multiply(along, input));
    }
  }
  symmetry.rate = field.add(loss, work);
  symmetry.unforced_rate = std::move(loss);
}

/// True if a generator with rational unknowns satisfies all sampled conditions; false if `sets` is
/// empty.
bool solves_all(const std::vector<SampledGenerators>& sets, const Generator& generator) {
  std::vector<cl_R> numbers;
  for (const Fraction& entry : generator) {
    numbers.push_back(rational_value(entry.numerator).value());
  }
  return !sets.empty() && std::ranges::all_of(sets, [&](const SampledGenerators& set) {
    return satisfies_conditions(set, numbers);
  });
}

/// True if E is conserved, but T + V is not. If T1 = 0, T + V - E is 2 T0, which is constant unless
/// T0 contains q or t. If T1 is not 0, returns false.
bool has_varying_total_energy(Symmetries& found, const MotionForms& motion) {
  const bool has_time = std::ranges::any_of(found.symmetries, [](const Symmetry& symmetry) {
    return symmetry.kind == SymmetryKind::time;
  });
  if (!has_time || find_function(motion.program, OutputKind::total_energy) == nullptr) return false;
  FormField field(found.forms.algebra);
  const OptionalFraction difference = field.subtract(
      motion.entries(OutputKind::total_energy)[0], motion.entries(OutputKind::energy_function)[0]);
  if (!difference) return false;
  const auto holds = [&](bool (*wanted)(const Atom&)) {
    return LeafSearch(found.forms.algebra, wanted).contains(*difference);
  };
  return !holds([](const Atom& leaf) { return leaf.leaf == Opcode::velocity; }) &&
         holds([](const Atom& leaf) { return leaf.leaf != Opcode::parameter; });
}

class SymmetrySearch {
 public:
  SymmetrySearch(const CheckedModel& checked, const Program& moving)
      : checked_(checked), model_(checked.model), moving_(moving), all_(checked.model) {}

  Symmetries operator()() {
    result_.unknowns = all_.size();
    result_.forms = present(moving_, budget);
    open_values_ = open_value_rates(result_.forms, model_, checked_.scene.specialisation.fixed);
    rates_ = coordinate_rates(result_.forms, model_);
    sampled_ = sample_generators(checked_, moving_, nominal_state(model_, checked_.scene));
    if (sampled_) {
      result_.sampled = sampled_->basis.size();
      result_.states = sampled_->states.size();
    }
    std::vector<Generator> basis = find_basis();
    prefer_common_rotations(result_.forms, all_, basis);
    for (Generator& generator : basis) {
      add_symmetry(without_divisors(result_.forms, std::move(generator)));
    }
    std::ranges::stable_sort(result_.symmetries, {}, &Symmetry::kind);
    result_.loses_energy = has_varying_total_energy(result_, motion_);
    return std::move(result_);
  }

 private:
  static constexpr ClosedFormBudget budget{300'000, 1'500'000, 50'000};

  std::vector<Generator> find_basis() {
    FormField field(result_.forms.algebra);
    Entries residual = motion_.velocity_entries(OutputKind::inverse_dynamics);
    const Entries dissipation = motion_.velocity_entries(OutputKind::dissipation);
    const Entries force = motion_.velocity_entries(OutputKind::applied_force);
    for (std::size_t i = 0; i < residual.size(); ++i) {
      residual[i] = field.add(residual[i], field.subtract(force[i], dissipation[i]));
    }
    const auto exact = exact_generators(result_.forms, model_, open_values_, residual);
    // The root of a square can hide symmetries from closed forms, but not from samples.
    const bool is_open =
        exact && exact->has_root && sampled_ && sampled_->basis.size() > exact->basis.size();
    result_.is_complete = exact && exact->is_complete && !is_open;
    if (!result_.is_complete) other_parameters_ = sample_other_parameters(checked_, moving_);
    for (const SampledGenerators& set : other_parameters_) {
      const std::size_t count = set.basis.size();
      result_.sampled_elsewhere = std::min(count, result_.sampled_elsewhere.value_or(count));
    }
    // Closed forms miss symmetries that need an unknown relation between functions.
    const std::size_t hidden = result_.sampled_elsewhere.value_or(0);
    result_.is_exact = exact && (result_.is_complete || hidden <= exact->basis.size());
    if (result_.is_exact) return exact->basis;
    std::vector<Generator> basis;
    for (std::size_t k = 0; sampled_ && k < sampled_->basis.size(); ++k) {
      bool is_rounded = false;
      basis.push_back(rationalise_generator(sampled_->basis[k], is_rounded));
      if (is_rounded) rounded_.insert(k);
    }
    return basis;
  }

  void add_symmetry(Generator generator) {
    Symmetry symmetry;
    symmetry.is_rounded = rounded_.contains(result_.symmetries.size());
    symmetry.is_at_values_only =
        symmetry.is_rounded || (!result_.is_exact && !solves_all(other_parameters_, generator));
    symmetry.kind = kind_of(result_.forms, all_, generator);
    FormField field(result_.forms.algebra);
    const Entries unknowns(generator.begin(), generator.end());
    const MotionPoint<OptionalFraction> at =
        symbolic_motion_point(field, model_, Entries(all_.velocity_count, Fraction{}));
    const PointChange<OptionalFraction> change = apply_generator(field, all_, at, unknowns);
    for (const OptionalFraction& x : change.position) symmetry.displacement.push_back(x.value());
    symmetry.generator = std::move(generator);
    const Fraction& time = symmetry.generator.back();
    Entries names;
    for (std::uint32_t i = 0; i < all_.velocity_count; ++i) {
      names.push_back(field.leaf(Opcode::momentum, i));
    }
    symmetry.momentum_form =
        noether_integral(field, change.position, names, time, field.leaf(Opcode::energy, 0))
            .value();
    const OptionalFraction energy = motion_.entries(OutputKind::energy_function)[0];
    symmetry.velocity_form = noether_integral(
        field, change.position, motion_.velocity_entries(OutputKind::momentum), time, energy);
    symmetry.gauge_function = find_gauge_function(change, time);
    symmetry.is_proved = symmetry.gauge_function && !symmetry.is_rounded;
    if (!symmetry.gauge_function && sampled_ &&
        keeps_lagrangian({model_, checked_.scene, moving_}, result_.forms.algebra,
                         symmetry.generator, sampled_->states)) {
      symmetry.gauge_function = Fraction{};
    }
    add_rates(field, motion_, change.position, symmetry);
    if (symmetry.kind == SymmetryKind::time) negate_symmetry(field, symmetry);
    result_.symmetries.push_back(std::move(symmetry));
  }

  /// L = v.p - E.
  const OptionalFraction& lagrangian() {
    if (lagrangian_) return *lagrangian_;
    FormField field(result_.forms.algebra);
    OptionalFraction sum = field.negate(motion_.entries(OutputKind::energy_function)[0]);
    const Entries momentum = motion_.velocity_entries(OutputKind::momentum);
    for (std::uint32_t i = 0; i < all_.velocity_count; ++i) {
      sum = field.add(sum, field.multiply(field.leaf(Opcode::velocity, i), momentum[i]));
    }
    return lagrangian_.emplace(std::move(sum));
  }

  /// F with dL = dF/dt; none if it is not found.
  OptionalFraction find_gauge_function(const PointChange<OptionalFraction>& change,
                                       const Fraction& time) {
    if (!lagrangian()) return std::nullopt;
    LeafRates moved{{}, {}, {}, open_values_, time};
    for (std::uint32_t i = 0; i < model_.coordinates.size(); ++i) {
      const OptionalFraction rate =
          rates_.empty() ? change.position[i] : coordinate_change(i, change.position);
      if (!rate) return std::nullopt;
      moved.coordinates.push_back(*rate);
    }
    for (const OptionalFraction& velocity : change.velocity)
      moved.velocities.push_back(velocity.value());
    OptionalFraction slope = directional_derivative(result_.forms, *lagrangian(), moved);
    if (slope) slope = reduce_quaternions(result_.forms.algebra, all_, *slope);
    if (!slope) return std::nullopt;
    return integrate_total_derivative(result_.forms, model_, rates_, open_values_, *slope);
  }

  /// (N x)_i, from dq/dt = N v with x in place of v.
  OptionalFraction coordinate_change(std::uint32_t i, const Entries& x) {
    Replacements replacements;
    for (std::uint32_t k = 0; k < x.size(); ++k) {
      if (!x[k]) return std::nullopt;
      replacements[{Opcode::velocity, k}].value = *x[k];
    }
    return substitute(result_.forms.algebra, rates_[i], replacements);
  }

  const CheckedModel& checked_;
  const Model& model_;
  const Program& moving_;
  GeneratorLayout all_;
  OpenValueRates open_values_ = {};
  std::vector<Fraction> rates_ = {};  ///< dq/dt; empty if dq/dt = v
  std::optional<OptionalFraction> lagrangian_ = {};
  std::optional<SampledGenerators> sampled_ = {};
  std::vector<SampledGenerators> other_parameters_ = {};  ///< empty if the exact basis is complete
  std::set<std::size_t> rounded_ = {};
  Symmetries result_ = {};
  MotionForms motion_{model_, moving_, result_.forms};
};

}  // namespace

std::vector<OutputRequest> outputs_for_symmetries(const Model& model) {
  return available_requests(
      model, {OutputKind::dissipation, OutputKind::applied_force, OutputKind::momentum,
              OutputKind::total_energy, OutputKind::energy_function, OutputKind::input_matrix,
              OutputKind::inverse_dynamics});
}

Result<Symmetries> find_symmetries(const AnalysisInput& input) {
  const CheckedModel& checked = input.checked;
  const std::size_t unknowns = GeneratorLayout(checked.model).size();
  if (unknowns > most_unknowns) {
    return Diagnostic{Code::E910,
                      {},
                      fmt::format("symmetries of {} velocities have {} unknowns, more than {}",
                                  checked.model.velocities.size(), unknowns, most_unknowns)};
  }
  return {SymmetrySearch(checked, input.recursive)(), {}};
}

}  // namespace elgen
