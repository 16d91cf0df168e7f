// loss: running errors at one state, and R, each computed when asked for.
#include "verify/bounds/loss.hpp"

#include <algorithm>

#include "base/more_digits.hpp"

namespace elgen {
namespace {

bool exceeds(const Real& x, const Real& y) {
  return x.is_defined() && y.is_defined() && x.value() > y.value();
}

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

}  // namespace

const std::vector<Running>& Losses::errors(const Function& function) {
  auto known = errors_.find(&function);
  if (known != errors_.end()) return known->second;
  MoreDigits digits;
  std::vector<Running> values;
  do {
    const auto leaf = [&](const cln::cl_R& value) {
      const Bound bound = leaf_bound(value, rounding_);
      return Running{bound.value, bound.exact ? Real() : abs(bound.value)};
    };
    values = fold<Running>(RunningErrorRules{map_leaves(leaf, state_), rounding_}, subject_.program,
                           function);
  } while (digits.grow());
  return errors_.emplace(&function, std::move(values)).first->second;
}

/// R of an entry.
Real Losses::reference(const FieldPlace& place, std::size_t entry) {
  const Function& function = *place.function;
  const std::vector<Running>& own = errors(function);
  std::unique_ptr<Conditioning>& conditioning = conditioning_[&function];
  if (conditioning == nullptr) {
    const bool has_fixed = !subject_.scene.specialisation.fixed.empty();
    conditioning =
        std::make_unique<Conditioning>(subject_.program, function, values_of(own), rounding_,
                                       has_fixed ? Literals::all : Literals::not_binary);
  }
  return conditioning->reference(place.field().entries[entry]);
}

bool Losses::knows_angles() const {
  static const Real known(cln::cl_RA(1) / 1000);
  for (std::size_t i = 0; i < state_.q.size(); ++i) {
    const bool is_angle = subject_.model.coordinates[i].unit_text == "rad";
    if (is_angle && exceeds(abs(Real(state_.q[i])) * rounding_.roundoff, known)) return false;
  }
  return true;
}

Real Losses::norm_of_references(const FieldPlace& place, const SolvedColumn& column) {
  std::vector<Real> references(place.field().entries.size());
  for (const std::size_t entry : column.entries) references[entry] = reference(place, entry);
  return norm(column, references);
}

double Losses::of_entry(const FieldPlace& place, std::size_t entry, const std::vector<Real>& errors,
                        const std::vector<Real>& exact, const std::vector<SolvedColumn>& columns) {
  static const Real tolerated(cln::cl_RA(static_cast<long>(tolerated_loss)));
  const Real threshold = tolerated * rounding_.roundoff;
  const auto has_entry = [entry](const SolvedColumn& column) {
    return std::ranges::count(column.entries, entry) > 0;
  };
  const auto column = std::ranges::find_if(columns, has_entry);
  const bool by_norm = column != columns.end();
  const Real error = by_norm ? norm(*column, errors) : errors[entry];
  const Real value = by_norm ? norm(*column, exact) : abs(exact[entry]);
  // R >= |x*|, which costs nothing.
  if (!exceeds(error, threshold * value)) return in_bounds(error, value, rounding_);
  const Real reference =
      by_norm ? norm_of_references(place, *column) : this->reference(place, entry);
  return reference.is_defined() ? in_bounds(error, reference, rounding_) : 0;
}

LostEntry Losses::of_largest(const std::vector<Real>& errors,
                             const std::vector<Real>& exact) const {
  const auto largest =
      std::ranges::max_element(errors, [](const Real& x, const Real& y) { return exceeds(y, x); });
  Real value;
  for (const Real& x : exact) value = max(value, abs(x));
  if (largest == errors.end() || !exceeds(value, Real())) return {};
  return {in_bounds(*largest, value, rounding_),
          static_cast<std::size_t>(largest - errors.begin())};
}

Loss Losses::of_field(const FieldPlace& place, const std::vector<Real>& errors,
                      const std::vector<Real>& exact, const std::vector<SolvedColumn>& columns) {
  Loss loss{{}, of_largest(errors, exact)};
  LostEntry& worst = loss.of_entry;
  const auto look_at = [&](std::size_t entry) {
    const double figure = of_entry(place, entry, errors, exact, columns);
    if (figure > worst.figure) worst = {figure, entry};
  };
  for (const SolvedColumn& column : columns) look_at(column.entries.front());
  const std::vector<bool> by_norm = entries_in(columns, errors.size());
  std::vector<std::pair<double, std::size_t>> most;  // what each may lose, as R >= |x*|
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!by_norm[i]) most.emplace_back(in_bounds(errors[i], abs(exact[i]), rounding_), i);
  }
  std::ranges::sort(most, std::ranges::greater());
  for (const auto& [figure, entry] : most) {
    if (figure <= worst.figure) break;
    look_at(entry);
  }
  return loss;
}

}  // namespace elgen
