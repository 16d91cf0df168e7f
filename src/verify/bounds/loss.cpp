// loss: running errors of all ways at one state, and R, each computed when asked for.
#include "verify/bounds/loss.hpp"

#include <algorithm>

#include "base/more_digits.hpp"
#include "lower/graph/prune.hpp"

namespace elgen {
namespace {

/// The function of this name.
const Function* find_named(const std::vector<Function>& functions, const std::string& name) {
  const auto found = std::ranges::find(functions, name, &Function::name);
  return found == functions.end() || found->fields.empty() ? nullptr : &*found;
}

bool is_same(const Function& x, const Function& y) {
  return x.instructions == y.instructions && entries_of(x) == entries_of(y);
}

/// How badly digits have been lost so far: the error by |x|.
Real lost_digits(const Running& x) {
  return x.value.is_defined() && cln::zerop(x.value.value()) ? x.error : x.error / abs(x.value);
}

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

std::vector<FieldWay> field_ways(const Subject& subject, const FieldPlace& place,
                                 const std::vector<Way>& ways) {
  const Program& program = subject.program;
  std::vector<FieldWay> all{{"as emitted", &program, place.function, place.first}};
  const auto add = [&all](const FieldWay& way) {
    const auto same = [&way](const FieldWay& known) {
      return is_same(*known.function, *way.function);
    };
    if (std::ranges::none_of(all, same)) all.push_back(way);
  };
  const bool repeats = output_row(place.function->kind).repeats;
  const std::string& name = repeats ? place.field().name : place.function->name;
  if (const Function* readable = find_named(program.readable, name)) {
    add({"closed form", &program, readable, repeats ? 0 : place.first});
  }
  for (const Way& way : ways) {
    const Function* function = find_named(way.program.functions, place.function->name);
    if (function != nullptr) add({way.name, &way.program, function, place.first});
  }
  return all;
}

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
  if (!exceeds(error, threshold * value)) return 0;  // R >= |x*|, which costs nothing
  const Real reference =
      by_norm ? norm_of_references(place, *column) : this->reference(place, entry);
  return reference.is_defined() ? in_bounds(error, reference, rounding_) : 0;
}

Loss Losses::of_field(const FieldPlace& place, const std::vector<Real>& errors,
                      const std::vector<Real>& exact, const std::vector<SolvedColumn>& columns) {
  Loss worst;
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
    if (figure <= std::max(worst.figure, tolerated_loss)) break;
    look_at(entry);
  }
  return worst;
}

std::uint32_t Losses::culprit(const FieldPlace& place, std::size_t entry) {
  const Function& function = *place.function;
  const std::vector<Running>& values = errors(function);
  const std::vector<bool> needed = needed_for(function, {place.field().entries[entry]});
  std::uint32_t worst = place.field().entries[entry];
  Real growth;
  for (std::uint32_t at = 0; at < needed.size(); ++at) {
    const Instruction& i = function.instructions[at];
    const std::size_t operands = operand_count(i);
    if (!needed[at] || operands == 0) continue;
    Real before = lost_digits(values[i.a]);
    if (operands > 1) before = max(before, lost_digits(values[i.b]));
    const Real grown = lost_digits(values[at]) / before;
    if (!exceeds(grown, growth)) continue;
    growth = grown;
    worst = at;
  }
  return worst;
}

}  // namespace elgen
