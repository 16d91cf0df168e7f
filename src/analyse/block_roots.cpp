// Solves linear equations in closed form. Searches boxes for the roots of all other equations:
// Newton's method starts at the middle of a box and computes the root to 58 digits.
#include "analyse/block_roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analyse/formulas.hpp"
#include "analyse/newton_refinement.hpp"
#include "analyse/searched_range.hpp"
#include "numbers/exact_number.hpp"
#include "program/evaluate/subject.hpp"

namespace elgen {
namespace {

using cln::cl_R;

/// The searched turn starts at this angle, so that halving the turn never splits it at a multiple
/// of a quarter turn.
constexpr double first_angle = -2.6;
constexpr double two_pi_bound = 0x1.921fb54442d19p2;  // more than 2 pi

/// Undecided boxes are joined if their distance along every coordinate is at most this multiple of
/// the length of one box along this coordinate.
constexpr double join_distance_factor = 10;

/// The largest number of Newton starts in open boxes, and the largest number of places. A place is
/// a union of undecided boxes that touch.
constexpr std::size_t most_starts = 64;
constexpr std::size_t most_places = 16;

/// The highest order of a zero that is recognised.
constexpr std::uint32_t most_order = 8;

/// `angle`, shifted by whole turns into (-pi, pi].
Real wrap_angle(const Real& angle) { return -wrap_above(-angle, -whole_turn() / Real(2)); }

class BlockSearch {
 public:
  BlockSearch(RestSystem& system, const RestBlock& block) : system_(system), block_(block) {
    for (const std::uint32_t coordinate : block.coordinates) {
      unknowns_.kinds.push_back(system.kinds[coordinate]);
      velocities_.push_back(system.model.coordinates[coordinate].velocity);
    }
    unknowns_.coordinates = block.coordinates;
    for (const std::uint32_t row : block.rows) {
      if (system.equation_form(row)) forms_.push_back(*system.equation_form(row));
    }
    std::ranges::sort(velocities_);
    velocities_.erase(std::unique(velocities_.begin(), velocities_.end()), velocities_.end());
    choose_rows();
    rows_ = select_rows(block.rows);
    square_ = select_rows(chosen_rows_);
  }

  Result<BlockRoots> operator()(const Limits& most) {
    if (block_.coordinates.empty()) return solve_constant_equation();
    if (has_all_forms()) {
      const auto linear = linear_solution(system_.forms, forms_, unknowns_, start());
      if (linear) return accept_linear_solution(*linear);
    }
    if (std::ranges::find(unknowns_.kinds, SearchKind::start) != unknowns_.kinds.end()) {
      result_.completeness = Completeness::searched;
      add_newton_root(start());
      return std::move(result_);
    }
    for (const std::uint32_t coordinate : block_.coordinates) {
      const Coordinate& searched = system_.model.coordinates[coordinate];
      if (system_.kinds[coordinate] == SearchKind::range && !searched.range) {
        return Diagnostic{Code::E531, searched.span,
                          fmt::format("`{}` has no range to search for equilibria", searched.name),
                          "give it one, as in `range = [-1, 1]`"};
      }
    }
    search_domain_boxes(most);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool has_all_forms() const { return forms_.size() == block_.rows.size(); }

  [[nodiscard]] Arguments<Real> start() const { return arguments_at<Real>(system_.state); }

  [[nodiscard]] Function select_rows(const std::vector<std::uint32_t>& rows) const {
    std::vector<std::uint32_t> entries;
    const std::vector<std::uint32_t> all = entries_of(system_.residual());
    for (const std::uint32_t row : rows) entries.push_back(all[row]);
    return with_entries(system_.residual(), entries);
  }

  /// The roots of an equation without coordinates: none, or one root without values. Only rational
  /// values of the parameters can prove that the left side is 0. A left side that is 0 in 64 digits
  /// proves nothing.
  BlockRoots solve_constant_equation() {
    const Real value = evaluate(system_.program, rows_, start())[0];
    if (value.is_defined() && !is_near(value, Real(), root_digits)) return std::move(result_);
    result_.roots.emplace_back();
    result_.is_identity = has_all_forms() && forms_[0].numerator.empty();
    const std::optional<Replacements> values = parameter_replacements(system_.state.parameters);
    const OptionalFraction there = has_all_forms() && values
                                       ? substitute(system_.forms.algebra, forms_[0], *values)
                                       : OptionalFraction();
    if (!there || !there->numerator.empty()) result_.completeness = Completeness::undecided;
    return std::move(result_);
  }

  BlockRoots accept_linear_solution(const LinearSolution& solution) {
    if (!solution.is_solvable) return std::move(result_);
    for (std::size_t i = 0; i < solution.values.size(); ++i) {
      const RestCoordinate& value = solution.values[i];
      if (!value.is_arbitrary && !is_in_search_range(i, Real(value.value)))
        return std::move(result_);
    }
    result_.roots.push_back(solution.values);
    return std::move(result_);
  }

  [[nodiscard]] bool is_in_search_range(std::size_t unknown, const Real& highest,
                                        const Real& width = {}) const {
    return is_in_range(system_.model.coordinates[unknowns_.coordinates[unknown]],
                       unknowns_.kinds[unknown], highest, width);
  }

  [[nodiscard]] Box domain() const {
    Box result;
    for (std::size_t i = 0; i < unknowns_.coordinates.size(); ++i) {
      const Coordinate& coordinate = system_.model.coordinates[unknowns_.coordinates[i]];
      if (unknowns_.kinds[i] == SearchKind::turn) {
        result.push_back({first_angle, first_angle + two_pi_bound + 1e-9});
      } else {
        result.push_back({ScalarTraits<Enclosure>::from_real(coordinate.range->low).low,
                          ScalarTraits<Enclosure>::from_real(coordinate.range->high).high});
      }
    }
    return result;
  }

  [[nodiscard]] LeafValues<Enclosure> known_leaves() const {
    return map_leaves([](const cl_R& value) { return ScalarTraits<Enclosure>::from_real(value); },
                      system_.state);
  }

  /// The number of enclosures computed per box: two evaluations of f, an evaluation of f with its
  /// slope for every unknown, and the matrix products of Krawczyk's test.
  [[nodiscard]] std::uint64_t enclosures_of_box() const {
    const std::uint64_t n = unknowns_.coordinates.size();
    return 1 + square_.instructions.size() * (2 * n + 2) + 2 * n * n * n;
  }

  void search_domain_boxes(const Limits& most) {
    const IntervalEquations equations{system_.program, square_, unknowns_.coordinates,
                                      known_leaves()};
    const std::uint64_t affordable = most.enclosures / enclosures_of_box();
    BoxSearchResult found = search_boxes(equations, domain(), std::min(most.boxes, affordable));
    result_.boxes = found.examined;
    result_.enclosures = found.examined * enclosures_of_box();
    if (!found.open_boxes.empty())
      result_.reached_limit = affordable < most.boxes ? "enclosures" : "boxes";
    for (const Box& box : found.single) add_box_root(box);
    for (const Box& place : join_undecided_boxes(found)) decide_box(equations, place);
    if (found.open_boxes.empty()) return;
    result_.completeness = Completeness::searched;
    const std::size_t step = std::max<std::size_t>(found.open_boxes.size() / most_starts, 1);
    for (std::size_t i = 0; i < found.open_boxes.size() && result_.starts < most_starts;
         i += step) {
      ++result_.starts;
      add_newton_root(middle_of(found.open_boxes[i]));
    }
  }

  [[nodiscard]] Arguments<Real> middle_of(const Box& box) const {
    Arguments<Real> at = start();
    for (std::size_t i = 0; i < box.size(); ++i) {
      const double middle = box[i].low + (box[i].high - box[i].low) / 2;
      at.q[unknowns_.coordinates[i]] = Real(exact_value(middle));
    }
    return at;
  }

  /// Chooses at most one equation per unknown; equations of the unknowns' velocities are preferred.
  void choose_rows() {
    chosen_rows_ = block_.rows;
    std::stable_partition(chosen_rows_.begin(), chosen_rows_.end(), [this](std::uint32_t row) {
      return std::ranges::find(velocities_, row) != velocities_.end();
    });
    if (chosen_rows_.size() > velocities_.size()) chosen_rows_.resize(velocities_.size());
  }

  /// The root to which Newton's method converges from `first`; none without convergence.
  [[nodiscard]] std::optional<Arguments<Real>> newton_root(const Arguments<Real>& first) const {
    return newton_solution(system_.model, system_.program, square_, first, velocities_);
  }

  void add_newton_root(const Arguments<Real>& first) {
    if (const auto root = newton_root(first)) add_root(*root);
  }

  /// Adds the root of a box. If Newton's method leaves the box, the box is undecided.
  void add_box_root(const Box& box) {
    const auto root = newton_root(middle_of(box));
    if (root && is_in_box(box, *root)) {
      add_root(*root);
    } else {
      record_undecided_box(box);
    }
  }

  [[nodiscard]] bool is_in_box(const Box& box, const Arguments<Real>& root) const {
    for (std::size_t i = 0; i < box.size(); ++i) {
      // The root is accurate to 58 digits, so 1e-40 covers its error.
      static const cl_R slack = power_of_ten(-40);
      const cl_R value = root.q[unknowns_.coordinates[i]].value();
      if (value < exact_value(box[i].low) - slack || value > exact_value(box[i].high) + slack)
        return false;
    }
    return true;
  }

  void add_root(Arguments<Real> root) {
    for (std::size_t i = 0; i < unknowns_.coordinates.size(); ++i) {
      Real& q = root.q[unknowns_.coordinates[i]];
      // An angle outside its range is kept, because the chart may break there.
      if (unknowns_.kinds[i] == SearchKind::turn) q = wrap_angle(q);
      if (unknowns_.kinds[i] == SearchKind::range && !is_in_search_range(i, q)) return;
    }
    for (const Real& value : evaluate(system_.program, rows_, root)) {
      if (!is_near(value, Real(), root_digits)) return;
    }
    if (is_known(root)) return;
    std::optional<std::vector<RestCoordinate>> exact;
    if (has_all_forms()) exact = exact_root(system_.forms, forms_, unknowns_, root);
    if (!exact) {
      exact.emplace();
      for (const std::uint32_t coordinate : unknowns_.coordinates) {
        exact->push_back({false, root.q[coordinate].value()});
      }
    }
    result_.roots.push_back(std::move(*exact));
  }

  [[nodiscard]] bool is_known(const Arguments<Real>& root) const {
    return std::ranges::any_of(result_.roots, [&](const auto& known) {
      for (std::size_t i = 0; i < known.size(); ++i) {
        const Real& own = root.q[unknowns_.coordinates[i]];
        if (!is_near(Real(known[i].value), own, root_digits)) return false;
      }
      return true;
    });
  }

  /// Joins undecided boxes that touch each other. Boxes inside a box with one root are dropped.
  [[nodiscard]] std::vector<Box> join_undecided_boxes(const BoxSearchResult& found) const {
    std::vector<Box> places;
    for (const Box& box : found.undecided) {
      const bool is_decided = std::ranges::any_of(
          found.single, [&](const Box& single) { return contains_or_touches(single, box, 0); });
      if (!is_decided) join_box(places, box);
    }
    for (const Box& box : found.open_boxes) join_box(places, box);
    return places;
  }

  /// Joins a box with all places that it touches, or with every place if there are `most_places`
  /// places already.
  static void join_box(std::vector<Box>& places, Box whole) {
    const bool is_crowded = places.size() >= most_places;
    const auto joins = [&](const Box& place) {
      if (!is_crowded && !contains_or_touches(place, whole, 1)) return false;
      for (std::size_t i = 0; i < whole.size(); ++i) {
        whole[i] = {std::min(whole[i].low, place[i].low), std::max(whole[i].high, place[i].high)};
      }
      return true;
    };
    while (std::erase_if(places, joins) > 0) {
    }
    places.push_back(std::move(whole));
  }

  /// True if `outer` contains `inner`; if `slack` is 1, true if the boxes intersect or nearly
  /// touch.
  static bool contains_or_touches(const Box& outer, const Box& inner, int slack) {
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const double length = join_distance_factor * (inner[i].high - inner[i].low);
      const bool is_apart =
          slack > 0 ? inner[i].low > outer[i].high + length || inner[i].high < outer[i].low - length
                    : inner[i].low < outer[i].low || inner[i].high > outer[i].high;
      if (is_apart) return false;
    }
    return true;
  }

  /// Adds the point of quarter_turn_point() as a root if the point solves the equations. The place
  /// stays undecided, unless the place has one coordinate and this root, of any order, is proved to
  /// be the only root in the place.
  void decide_box(const IntervalEquations& equations, const Box& place) {
    if (const auto root = quarter_turn_point(place)) {
      add_root(*root);
      if (is_only_root(equations, place, *root)) return;
    }
    record_undecided_box(place);
  }

  void record_undecided_box(const Box& place) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      const Real low(exact_value(place[i].low));
      const Real high(exact_value(place[i].high));
      if (!is_in_search_range(i, high, high - low)) return;
    }
    result_.completeness = std::max(result_.completeness, Completeness::undecided);
    UndecidedBox& box = result_.undecided.emplace_back();
    for (std::size_t i = 0; i < place.size(); ++i) {
      const cl_R length = exact_value(place[i].high) - exact_value(place[i].low);
      const Real middle(exact_value(place[i].low) + length / 2);
      const bool turns = unknowns_.kinds[i] == SearchKind::turn;
      const cl_R at = (turns ? wrap_angle(middle) : middle).value();
      box[unknowns_.coordinates[i]] = {at - length / 2, at + length / 2};
    }
  }

  /// The point of the place whose angles are multiples of a quarter turn and whose other
  /// coordinates are 0, if it exists. add_root() tests whether the point solves the equations.
  [[nodiscard]] std::optional<Arguments<Real>> quarter_turn_point(const Box& place) const {
    Arguments<Real> root = start();
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double quarter = to_double(whole_turn().value()) / 4;
      const bool turns = unknowns_.kinds[i] == SearchKind::turn;
      const double count = turns ? std::round(place[i].low / quarter + 0.01) : 0;
      if (count * quarter < place[i].low || count * quarter > place[i].high) return std::nullopt;
      root.q[unknowns_.coordinates[i]] =
          whole_turn() * Real(cln::cl_RA(static_cast<int>(count)) / 4);
    }
    return root;
  }

  [[nodiscard]] bool is_only_root(const IntervalEquations& equations, const Box& place,
                                  const Arguments<Real>& root) {
    if (place.size() != 1 || !has_all_forms() || block_.rows.size() != 1) return false;
    const std::uint32_t coordinate = block_.coordinates[0];
    const auto exact = exact_root(system_.forms, forms_, unknowns_, root);
    const auto order = exact
                           ? leading_derivative(system_, block_.rows[0], coordinate, exact->front())
                           : std::nullopt;
    const auto derivative =
        order ? form_program(system_.program.leaves, system_.forms.algebra, order->derivative)
              : std::nullopt;
    if (!derivative) return false;
    const IntervalEquations slope{derivative->program, derivative->function, equations.unknowns,
                                  equations.leaves};
    const Enclosure over_place = enclose_values(slope, place)[0];
    return over_place.definedness == Definedness::everywhere && !may_contain(over_place, 0);
  }

  RestSystem& system_;
  const RestBlock& block_;
  Unknowns unknowns_ = {};
  std::vector<std::uint32_t> velocities_ = {};   ///< velocities of the unknowns
  std::vector<std::uint32_t> chosen_rows_ = {};  ///< at most one per unknown
  std::vector<Fraction> forms_ = {};             ///< the closed form of each row that has a form
  Function rows_ = {};
  Function square_ = {};  ///< the chosen rows
  BlockRoots result_ = {};
};

}  // namespace

std::optional<LeadingDerivative> leading_derivative(RestSystem& system, std::uint32_t row,
                                                    std::uint32_t coordinate,
                                                    const RestCoordinate& root) {
  std::optional<Replacements> values = parameter_replacements(system.state.parameters);
  if (!values || !root.closed_form || !system.equation_form(row)) return std::nullopt;
  const Replacements place = coordinate_replacements({coordinate}, {root});
  LeadingDerivative result{1, *system.equation_form(row)};
  for (; result.order <= most_order; ++result.order) {
    const auto next =
        partial_derivative(system.forms, result.derivative, coordinate, system.state.q.size());
    if (!next) return std::nullopt;
    result.derivative = *next;
    const OptionalFraction number =
        substitute(system.forms.algebra, substitute(system.forms.algebra, *next, place), *values);
    if (!number) return std::nullopt;
    if (!number->numerator.empty()) return result;
  }
  return std::nullopt;
}

Result<BlockRoots> block_roots(RestSystem& system, const RestBlock& block, const Limits& limits) {
  return BlockSearch(system, block)(limits);
}

}  // namespace elgen
