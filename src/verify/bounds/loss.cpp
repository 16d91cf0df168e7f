// loss: running errors at one state, and R, each computed when asked for.
#include "verify/bounds/loss.hpp"

#include <algorithm>
#include <set>

#include "numbers/more_digits.hpp"

namespace elgen {
namespace {

std::vector<bool> entries_in(const std::vector<SolvedColumn>& columns, std::size_t count) {
  std::vector<bool> is_in(count);
  for (const SolvedColumn& column : columns) {
    for (const std::size_t entry : column.entries) is_in[entry] = true;
  }
  return is_in;
}

Real norm(const SolvedColumn& column, const std::vector<Real>& values) {
  Real square;
  for (std::size_t i = 0; i < column.entries.size(); ++i) {
    const Real weighted = values[column.entries[i]] * column.weights[i];
    square = square + weighted * weighted;
  }
  return sqrt(square);
}

/// The magnitudes that errors are compared with: |x*|; the largest of the field where that is 0, or
/// all of its column are.
std::vector<Real> scales_of(const std::vector<Real>& exact,
                            const std::vector<SolvedColumn>& columns) {
  std::vector<Real> scales;
  Real largest;
  for (const Real& x : exact) {
    scales.push_back(abs(x));
    largest = max(largest, abs(x));
  }
  const auto scale = [&](const std::vector<std::size_t>& entries) {
    const auto is_there = [&](std::size_t i) { return scales[i] > Real(); };
    if (std::ranges::any_of(entries, is_there)) return;
    for (const std::size_t i : entries) scales[i] = largest;
  };
  for (const SolvedColumn& column : columns) scale(column.entries);
  const std::vector<bool> by_norm = entries_in(columns, exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!by_norm[i]) scale({i});
  }
  return scales;
}

/// The constants that parameters which a scene fixed may have left, alone or multiplied. Literals
/// of the model are none, powers of two scale without error, and what has pi or a root in it is
/// left by a parameter of that kind alone.
std::vector<bool> constants_of_fixed(const Model& model, const Scene& scene,
                                     const Program& program) {
  const FixedParameters& fixed = scene.specialisation.fixed;
  if (fixed.empty()) return {};
  const bool has_irrational =
      std::ranges::any_of(fixed, [](const auto& x) { return x.second.form.has_value(); });
  std::set<cln::cl_R> literals;
  for (const Expression& x : model.expressions) {
    if (x.kind == ExpressionKind::number) literals.insert(cln::abs(x.number));
  }
  std::vector<bool> result;
  for (const Constant& constant : program.constants) {
    const cln::cl_R magnitude = cln::abs(constant.value);
    const bool is_literal = literals.contains(magnitude) || is_power_of_two(Real(magnitude));
    result.push_back(!is_literal && (has_irrational || is_rational(constant)));
  }
  return result;
}

}  // namespace

Losses::Losses(const Subject& subject, const State& state, const Rounding& rounding)
    : subject_(subject),
      state_(state),
      rounding_(rounding),
      fixed_(constants_of_fixed(subject.model, subject.scene, subject.program)) {}

const std::vector<Running>& Losses::errors(const Function& function) {
  auto known = errors_.find(&function);
  if (known != errors_.end()) return known->second;
  std::vector<Running> values = with_enough_digits([&] {
    const auto leaf = [&](const cln::cl_R& value) {
      const Bound bound = leaf_bound(value, rounding_);
      return Running{bound.value, bound.exact ? Real() : abs(bound.value)};
    };
    return fold<Running>(RunningErrorRules{map_leaves(leaf, state_), rounding_}, subject_.program,
                         function);
  });
  return errors_.emplace(&function, std::move(values)).first->second;
}

/// K of an entry.
Real Losses::conditioning(const FieldPlace& place, std::size_t entry) {
  const Function& function = *place.function;
  const std::vector<Running>& own = errors(function);
  std::unique_ptr<Conditioning>& known = conditioning_[&function];
  if (known == nullptr) {
    known = std::make_unique<Conditioning>(subject_.program, function, values_of(own), fixed_);
  }
  return known->of(place.field().entries[entry]);
}

bool Losses::knows_angles() const {
  static const Real known(cln::cl_RA(1) / 1000);
  for (std::size_t i = 0; i < state_.q.size(); ++i) {
    const bool turns = is_angle(subject_.model.coordinates[i]);
    if (turns && abs(Real(state_.q[i])) * rounding_.roundoff > known) return false;
  }
  return true;
}

Real Losses::norm_of_references(const FieldPlace& place, const SolvedColumn& column,
                                std::vector<Real> scales) {
  for (const std::size_t entry : column.entries) {
    scales[entry] = scales[entry] + conditioning(place, entry);
  }
  return norm(column, scales);
}

double Losses::of_entry(const FieldPlace& place, std::size_t entry, const std::vector<Real>& errors,
                        const std::vector<Real>& scales, const std::vector<SolvedColumn>& columns) {
  static const Real tolerated(cln::cl_RA(static_cast<long>(tolerated_loss)));
  const Real threshold = tolerated * rounding_.roundoff;
  const auto has_entry = [entry](const SolvedColumn& column) {
    return std::ranges::count(column.entries, entry) > 0;
  };
  const auto column = std::ranges::find_if(columns, has_entry);
  const bool by_norm = column != columns.end();
  const Real error = by_norm ? norm(*column, errors) : errors[entry];
  const Real scale = by_norm ? norm(*column, scales) : scales[entry];
  // R is no less than the scale, which costs nothing.
  if (!(error > threshold * scale)) return in_bounds(error, scale, rounding_);
  const Real reference =
      by_norm ? norm_of_references(place, *column, scales) : scale + conditioning(place, entry);
  return reference.is_defined() ? in_bounds(error, reference, rounding_) : 0;
}

LostEntry Losses::of_largest(const std::vector<Real>& errors,
                             const std::vector<Real>& scales) const {
  const auto largest =
      std::ranges::max_element(errors, [](const Real& x, const Real& y) { return x < y; });
  Real value;
  for (const Real& scale : scales) value = max(value, scale);
  if (largest == errors.end() || !(value > Real())) return {};
  return {in_bounds(*largest, value, rounding_),
          static_cast<std::size_t>(largest - errors.begin())};
}

Loss Losses::of_field(const FieldPlace& place, const std::vector<Real>& errors,
                      const std::vector<Real>& exact, const std::vector<SolvedColumn>& columns) {
  const std::vector<Real> scales = scales_of(exact, columns);
  Loss loss{{}, of_largest(errors, scales)};
  LostEntry& worst = loss.of_entry;
  const auto look_at = [&](std::size_t entry) {
    const double figure = of_entry(place, entry, errors, scales, columns);
    if (figure > worst.figure) worst = {figure, entry};
  };
  for (const SolvedColumn& column : columns) look_at(column.entries.front());
  const std::vector<bool> by_norm = entries_in(columns, errors.size());
  std::vector<std::pair<double, std::size_t>> most;  // what each may lose, as R is no less
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!by_norm[i]) most.emplace_back(in_bounds(errors[i], scales[i], rounding_), i);
  }
  std::ranges::sort(most, std::ranges::greater());
  for (const auto& [figure, entry] : most) {
    if (figure <= worst.figure) break;
    look_at(entry);
  }
  return loss;
}

}  // namespace elgen
