// The equilibria of a system are all combinations of the equilibria of its blocks.
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "analyse/block_roots.hpp"
#include "analyse/chart_breaks.hpp"
#include "analyse/formulas.hpp"
#include "analyse/newton_refinement.hpp"
#include "analyse/searched_range.hpp"
#include "analyse/stability.hpp"
#include "base/reason.hpp"
#include "elgen/choose.hpp"
#include "elgen/fold.hpp"
#include "elgen/references.hpp"
#include "model/requests.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// The largest number of equilibria (else E910). Their number is the product of the numbers of
/// roots of all blocks.
constexpr std::size_t most_points = 256;

class EquilibriumSearch {
 public:
  EquilibriumSearch(const CheckedModel& checked, Program moving, RestProgram rest, State state)
      : model_(checked.model),
        moving_(std::move(moving)),
        rest_(std::move(rest)),
        state_(std::move(state)) {
    result_.inputs = state_.u;
  }

  Result<Equilibria> operator()(const Limits& limits) {
    if (Diagnostics errors = prepare(); !errors.empty()) return errors;
    RestSystem system{model_, rest_.program, result_.forms, result_.kinds, state_};
    Limits left = limits;
    for (const RestBlock& block : blocks_) {
      Result<BlockRoots> roots = block_roots(system, block, left);
      if (!roots) return roots.diagnostics;
      merge_counts(*roots);
      if (!roots->reached_limit.empty()) {
        const bool is_boxes = roots->reached_limit == "boxes";
        result_.limit =
            fmt::format("{}={}", roots->reached_limit, is_boxes ? limits.boxes : limits.enclosures);
      }
      left.boxes -= std::min(left.boxes, roots->boxes);
      left.enclosures -= std::min(left.enclosures, roots->enclosures);
      std::ranges::stable_sort(roots->roots, comes_before);
      roots_.push_back(std::move(*roots));
    }
    const bool is_none = std::ranges::any_of(roots_, [](const BlockRoots& block) {
      return block.roots.empty() && block.completeness == Completeness::proved;
    });
    if (is_none) result_.completeness = Completeness::proved;
    if (Diagnostics errors = make_points(system); !errors.empty()) return errors;
    std::erase_if(result_.points, [this](const RestPoint& point) {
      return find_chart_breaks(rest_, point, result_.chart_singularities) ||
             !is_in_ranges(point.state);
    });
    return std::move(result_);
  }

  /// Analyses only the given state, which must be an equilibrium (else E532).
  Result<Equilibria> analyse_start() {
    if (Diagnostics errors = prepare(); !errors.empty()) return errors;
    if (Diagnostics errors = check_balance(); !errors.empty()) return errors;
    RestSystem system{model_, rest_.program, result_.forms, result_.kinds, state_};
    for (const RestBlock& block : blocks_) {
      roots_.emplace_back().roots.push_back(start_root(system, block));
    }
    result_.completeness = Completeness::searched;
    result_.has_given_point = true;
    if (Diagnostics errors = make_points(system); !errors.empty()) return errors;
    set_free_closed_forms(result_.points.front());
    return std::move(result_);
  }

 private:
  /// Sets the closed form of each coordinate in no equation at rest, if the start value of the
  /// coordinate is 0 or, for an angle, a multiple of a quarter turn.
  void set_free_closed_forms(RestPoint& point) {
    for (std::uint32_t i = 0; i < point.coordinates.size(); ++i) {
      RestCoordinate& coordinate = point.coordinates[i];
      if (!coordinate.is_arbitrary || model_.coordinates[i].rotation) continue;
      const bool turns = is_angle(model_.coordinates[i]);
      const auto plain =
          exact_root(result_.forms, {}, {{i}, {turns ? SearchKind::turn : SearchKind::none}},
                     arguments_at<Real>(point.state));
      if (plain) coordinate.closed_form = plain->front().closed_form;
    }
  }

  Diagnostics prepare() {
    rows_ = coordinate_occurrences(rest_.program, rest_.residual());
    if (const Expression* const kink = find_kink(model_)) {
      return {{Code::E530, kink->span, "a force with a kink has no linear part at rest"}};
    }
    if (std::ranges::any_of(rows_, &CoordinateOccurrence::has_time)) {
      return {
          {Code::E530, {}, "the equations at rest contain t", time_removal_hint(model_, rest_)}};
    }
    result_.forms = present(rest_.program);
    leave_out_coordinates();
    blocks_ = rest_blocks(rows_);
    find_kinds();
    compare_rest_energy();
    return {};
  }

  /// Removes from each row the coordinates that the row does not contain at the values of the
  /// parameters: (m1 a - m2 b) g cos(theta) does not contain theta if m1 a = m2 b.
  void leave_out_coordinates() {
    const std::optional<Replacements> values = parameter_replacements(state_.parameters);
    for (std::uint32_t row = 0; values && row < rows_.size(); ++row) {
      const OptionalFraction there = substitute(
          result_.forms.algebra, result_.forms.functions[0].fields[0].entries[row], *values);
      if (!there) continue;
      std::erase_if(rows_[row].coordinates, [&](std::uint32_t coordinate) {
        return !contains_coordinate(result_.forms.algebra, *there, coordinate);
      });
    }
  }

  [[nodiscard]] Diagnostics check_balance() const {
    // Start values have 60 digits or more. Sums of forces lose a few digits.
    static const cl_R tolerance = power_of_ten(-40);
    const std::vector<Real> residual =
        evaluate(rest_.program, rest_.residual(), arguments_at<Real>(state_));
    for (std::size_t i = 0; i < residual.size(); ++i) {
      if (residual[i].is_defined() && cln::abs(residual[i].value()) < tolerance) continue;
      const std::string value =
          residual[i].is_defined() ? short_number_text(residual[i].value()) : "undefined";
      return {{Code::E532,
               {},
               fmt::format("`{}` does not stay at rest there: bias - B u is {}",
                           model_.velocities[i].name, value),
               "`elgen show --what equilibria` lists the equilibria"}};
    }
    return {};
  }

  [[nodiscard]] std::vector<RestCoordinate> start_root(RestSystem& system,
                                                       const RestBlock& block) const {
    std::vector<Fraction> rows;
    for (const std::uint32_t row : block.rows) {
      if (system.equation_form(row)) rows.push_back(*system.equation_form(row));
    }
    Unknowns unknowns{block.coordinates, {}};
    std::vector<RestCoordinate> numbers;
    for (const std::uint32_t coordinate : block.coordinates) {
      unknowns.kinds.push_back(result_.kinds[coordinate]);
      numbers.push_back({false, state_.q[coordinate]});
    }
    if (rows.size() != block.rows.size()) return numbers;
    return exact_root(system.forms, rows, unknowns, arguments_at<Real>(state_)).value_or(numbers);
  }

  /// True if x comes before y in the list: closed forms without acos and asin come first, by value;
  /// then all other values, by magnitude.
  static bool comes_before(const std::vector<RestCoordinate>& x,
                           const std::vector<RestCoordinate>& y) {
    static const cl_R noise = power_of_ten(-40);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto is_plain = [](const RestCoordinate& value) {
        return value.closed_form && !value.inverse_argument;
      };
      if (is_plain(x[i]) != is_plain(y[i])) return is_plain(x[i]);
      const cl_R difference =
          is_plain(x[i]) ? x[i].value - y[i].value : cln::abs(x[i].value) - cln::abs(y[i].value);
      if (cln::abs(difference) > noise) return cln::minusp(difference);
      if (cln::abs(x[i].value - y[i].value) > noise) return x[i].value > y[i].value;
    }
    return false;
  }

  void find_kinds() {
    result_.kinds.resize(model_.coordinates.size(), SearchKind::none);
    for (const RestBlock& block : blocks_) {
      const bool turns = std::ranges::any_of(block.coordinates, [&](std::uint32_t coordinate) {
        return model_.coordinates[coordinate].rotation.has_value();
      });
      for (const std::uint32_t coordinate : block.coordinates) {
        // If the chart breaks within a turn, only the declared range is searched.
        const Coordinate& searched = model_.coordinates[coordinate];
        const bool is_periodic = !(searched.singular_condition && searched.range) &&
                                 std::ranges::none_of(rows_, [&](const CoordinateOccurrence& row) {
                                   return row.outside_sinusoids.contains(coordinate);
                                 });
        result_.kinds[coordinate] = turns         ? SearchKind::start
                                    : is_periodic ? SearchKind::turn
                                                  : SearchKind::range;
      }
    }
  }

  void compare_rest_energy() {
    const Function* const potential = find_function(moving_, OutputKind::potential_energy);
    if (potential == nullptr) return;
    // At rest W is V0, unless the kinetic energy has a term T0 without velocities.
    Program both{rest_.program.leaves, moving_.constants, {*potential}};
    ClosedForms known = present(both);
    const auto& v0 = known.functions[0].fields[0].entries[0];
    Arithmetic arithmetic(known.algebra);
    const Function& rest_energy = rest_.program.functions[2];
    const OptionalFraction w =
        entries_of(rest_energy, fold<OptionalFraction>(arithmetic, rest_.program, rest_energy))[0];
    result_.has_rest_kinetic_energy = !v0 || !w || !is_proved_equal(known, *v0, *w);
  }

  void merge_counts(const BlockRoots& roots) {
    result_.completeness = std::max(result_.completeness, roots.completeness);
    result_.boxes += roots.boxes;
    result_.starts += roots.starts;
    result_.undecided_boxes.insert(result_.undecided_boxes.end(), roots.undecided.begin(),
                                   roots.undecided.end());
  }

  /// Adds a point for each combination of roots. The root of the last block varies fastest.
  Diagnostics make_points(RestSystem& system) {
    std::size_t count = 1;
    for (const BlockRoots& block : roots_) {
      count *= block.roots.size();
      if (count > most_points) {
        return {{Code::E910,
                 {},
                 fmt::format("there are more than {} equilibria", most_points),
                 "show the modes at one of them by `--at`"}};
      }
    }
    conditions_.is_conservative = is_conservative(moving_, state_);
    std::vector<std::size_t> chosen(blocks_.size(), 0);
    for (std::size_t n = 0; n < count; ++n) {
      std::size_t rest = n;
      for (std::size_t b = blocks_.size(); b-- > 0;) {
        chosen[b] = rest % roots_[b].roots.size();
        rest /= roots_[b].roots.size();
      }
      result_.points.push_back(rest_point(system, chosen));
    }
    return {};
  }

  RestPoint rest_point(RestSystem& system, const std::vector<std::size_t>& chosen) {
    RestPoint point;
    point.state = state_;
    point.coordinates.resize(model_.coordinates.size());
    for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
      point.coordinates[i] = {true, state_.q[i]};
    }
    LagrangeDirichletPremises here = conditions_;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const std::vector<RestCoordinate>& root = roots_[b].roots[chosen[b]];
      if (root.empty() && !roots_[b].is_identity) point.is_exact = false;
      for (std::size_t i = 0; i < root.size(); ++i) {
        const std::uint32_t coordinate = blocks_[b].coordinates[i];
        point.coordinates[coordinate] = root[i];
        if (!root[i].is_arbitrary && !root[i].closed_form) point.is_exact = false;
        point.state.q[coordinate] = root[i].value;
      }
    }
    for (const RestCoordinate& coordinate : point.coordinates) {
      if (coordinate.is_arbitrary) ++here.free_count;
    }
    fill_matrices(point);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (blocks_[b].coordinates.size() == 1 && blocks_[b].rows.size() == 1) {
        add_degenerate_term(system, blocks_[b], roots_[b].roots[chosen[b]][0], point, here);
      }
    }
    point.stability = stability_of(point, here);
    return point;
  }

  [[nodiscard]] bool is_in_ranges(const State& state) const {
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      if (!is_in_range(model_.coordinates[i], result_.kinds[i], Real(state.q[i]))) return false;
    }
    return true;
  }

  void fill_matrices(RestPoint& point) const {
    const Arguments<Real> at = arguments_at<Real>(point.state);
    std::vector<std::uint32_t> velocities(model_.velocities.size());
    for (std::uint32_t i = 0; i < velocities.size(); ++i) velocities[i] = i;
    point.mass = mass_matrix_at(rest_, point.state);
    point.stiffness =
        values_or_zero(position_slopes(model_, rest_.program, rest_.residual(), at, velocities));
    point.damping = values_or_zero(velocity_slopes(moving_, OutputKind::bias, at));
    if (!model_.inputs.empty()) {
      point.input_matrix =
          values_or_zero(evaluate(moving_, *find_function(moving_, OutputKind::input_matrix), at));
    }
  }

  /// Adds the leading term of W to `here` if K is exactly 0 along the coordinate of the block.
  void add_degenerate_term(RestSystem& system, const RestBlock& block, const RestCoordinate& root,
                           const RestPoint& point, LagrangeDirichletPremises& here) {
    const std::uint32_t coordinate = block.coordinates[0];
    const auto order = leading_derivative(system, block.rows[0], coordinate, root);
    if (!order || order->order == 1) return;
    // W = r^(m) (q - q0)^(m + 1)/(m + 1)! + ...
    cln::cl_RA factorial = 1;
    for (std::uint32_t i = 2; i <= order->order + 1; ++i) factorial = factorial * i;
    const OptionalFraction there = substitute(system.forms.algebra, order->derivative,
                                              coordinate_replacements({coordinate}, {root}));
    Arithmetic arithmetic(system.forms.algebra);
    const OptionalFraction coefficient = arithmetic.multiply(there, fraction_of(1 / factorial));
    if (!coefficient) return;
    const Real number =
        evaluate_form(system.forms.algebra, *coefficient, arguments_at<Real>(point.state));
    here.degenerate.push_back({coordinate, order->order + 1, *coefficient});
    here.is_positive.push_back(number.is_defined() && cln::plusp(number.value()));
  }

  const Model& model_;
  Program moving_;
  RestProgram rest_;
  State state_ = {};
  std::vector<CoordinateOccurrence> rows_ = {};
  std::vector<RestBlock> blocks_ = {};
  std::vector<BlockRoots> roots_ = {};
  LagrangeDirichletPremises conditions_ = {};
  Equilibria result_ = {};
};

/// The start state. Inputs have the values of their laws, or 0.
Result<State> start_state(const CheckedModel& checked) {
  const Model& model = checked.model;
  State state = nominal_state(model, checked.scene);
  for (std::size_t i = 0; i < model.coordinates.size(); ++i) {
    state.q[i] = model.coordinates[i].start_value;
  }
  Result<std::vector<cl_R>> inputs = rest_inputs(checked, state);
  if (!inputs) return inputs.diagnostics;
  state.u = std::move(*inputs);
  return state;
}

/// The state of an [[equilibrium]], or the start state if `name` is empty. Coordinates that the
/// [[equilibrium]] does not set have their start value.
Result<State> named_state(const CheckedModel& checked, const std::string& name) {
  Result<State> state = start_state(checked);
  if (!state || name.empty()) return state;
  const Model& model = checked.model;
  const auto found = std::ranges::find(model.equilibria, name, &Equilibrium::name);
  if (found == model.equilibria.end()) {
    std::vector<std::string> names;
    for (const Equilibrium& known : model.equilibria) names.push_back(known.name);
    return Diagnostic{Reason::unknown_equilibrium,
                      {},
                      fmt::format("no [[equilibrium]] is called `{}`", name),
                      names.empty() ? "give a point: `--at theta=0`"
                                    : fmt::format("there are: {}", fmt::join(names, ", "))};
  }
  std::optional<State> there = oracle_rest_state(model, *found, std::move(*state));
  if (there) return std::move(*there);
  return Diagnostic{Code::E532, found->span, "the point has no value at these parameters"};
}

Result<EquilibriumSearch> make_equilibrium_search(const AnalysisInput& input) {
  const CheckedModel& checked = input.checked;
  const Result<State> state =
      input.equilibrium_name ? named_state(checked, *input.equilibrium_name) : start_state(checked);
  if (!state) return state.diagnostics;
  Program moving =
      with_closed_forms(input.recursive, Audience::code);  // contains no leaves that cancel
  Result<RestProgram> rest = rest_program(moving, state->u);
  if (!rest) return rest.diagnostics;
  return EquilibriumSearch(checked, std::move(moving), std::move(*rest), *state);
}

}  // namespace

std::vector<OutputRequest> outputs_for_equilibria(const Model& model) {
  return available_requests(
      model, {OutputKind::mass_matrix, OutputKind::potential_energy, OutputKind::dissipation,
              OutputKind::applied_force, OutputKind::bias, OutputKind::energy_function,
              OutputKind::input_matrix});
}

Result<Equilibria> find_equilibria(const AnalysisInput& input) {
  Result<EquilibriumSearch> search = make_equilibrium_search(input);
  if (!search) return search.diagnostics;
  return input.equilibrium_name ? search->analyse_start() : (*search)(input.limits);
}

}  // namespace elgen
