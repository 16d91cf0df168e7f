// Projections against oracle_contraction. Accelerations are checked by what they must satisfy, w.(M
// a + bias) = w.B u, which needs no linear solve; relative pivots by the oracle's own solve for up
// to four coordinates, and for more of them by the program's mass matrix, which is checked itself.
#include "projection.hpp"

#include <fmt/format.h>

#include "agreement.hpp"
#include "elgen/outputs.hpp"
#include "pivots.hpp"
#include "stated_error.hpp"

namespace elgen {
namespace {

using cln::cl_R;
using Values = std::vector<cl_R>;

/// Up to so many coordinates the oracle solves for the pivots itself.
constexpr std::size_t directly_solved = 4;

Values random_direction(std::size_t size, Random& random) {
  Values direction;
  for (std::size_t i = 0; i < size; ++i) direction.emplace_back(random.rational());
  return direction;
}

std::string mismatch(const std::string& what, const Real& value, const cl_R& truth) {
  return fmt::format("{} is {}, the oracle says {}", what, short_text(value), short_text(truth));
}

/// Of the field whose entries start at `first`, as many as w and y have.
Measured contracted(const Subject& subject, const FunctionRun& run, std::size_t first,
                    const Contraction& by, const State& state) {
  Measured sum;
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  for (std::size_t i = 0; i < by.w.size() * columns; ++i) {
    const cl_R factor = by.y.empty() ? by.w[i] : by.w[i / columns] * by.y[i % columns];
    const Bound& entry = run.exact.entries[first + i];
    const Real size(cln::abs(factor));
    sum.value = sum.value + entry.value * Real(factor);
    sum.bound = sum.bound + entry.bound * size;
    sum.stated =
        sum.stated + stated_error(subject.program, run.function.kind, first + i, state) * size;
  }
  return sum;
}

/// Random directions of the function's field number `index`.
Contraction directions(const Function& function, std::size_t index, Random& random) {
  const Field& field = function.fields[index];
  Contraction by{random_direction(field.rows, random), {}, index};
  const bool is_matrix =
      output_row(function.kind).fields[index].columns != Extent::one || field.columns > 1;
  if (is_matrix) by.y = random_direction(field.columns, random);
  return by;
}

std::string compare_fields(const Subject& subject, const FunctionRun& run, OracleCache& oracle,
                           Random& random) {
  OutputRequest request = standard_request(run.function.kind);
  request.user = run.function.user;
  std::size_t first = 0;
  for (std::size_t index = 0; index < run.function.fields.size(); ++index) {
    const Field& field = run.function.fields[index];
    if (field.entries.empty()) continue;
    const Contraction by = directions(run.function, index, random);
    const Measured sum = contracted(subject, run, first, by, oracle.state());
    first += field.entries.size();
    const auto truth = oracle_contraction(subject.model, request, oracle.state(), by);
    if (!truth || agrees_with_oracle(sum, *truth, run.exact.largest, oracle)) continue;
    const std::string of_field = field.name.empty() ? "" : " of " + field.name;
    return mismatch((by.y.empty() ? "w.x" : "w.X y") + of_field, sum.value, *truth);
  }
  return {};
}

/// The accelerations are undefined: a mistake where the oracle solves for them.
std::string compare_undefined(const FunctionRun& run, OracleCache& oracle) {
  const OracleValues& truth = oracle.values(standard_request(run.function.kind));
  return truth ? mismatch("an acceleration", Real::undefined(), truth->front()) : "";
}

/// w.(M a + bias) - w.B u at the program's exact acceleration.
std::string compare_acceleration(const Subject& subject, const FunctionRun& run,
                                 OracleCache& oracle, Random& random) {
  const std::size_t n = oracle.state().v.size();
  const Values w = random_direction(n, random);
  State state = oracle.state();
  for (std::size_t i = 0; i < n; ++i) {
    if (!run.exact.entries[i].value.is_defined()) return compare_undefined(run, oracle);
    state.a[i] = run.exact.entries[i].value.value();
  }
  const auto force = oracle_projected_inverse_dynamics(subject.model, state, w);
  const auto driven =
      state.u.empty()
          ? std::optional<cl_R>(0)
          : oracle_contraction(subject.model, standard_request(OutputKind::input_matrix), state,
                               {w, state.u});
  if (!force || !driven) return {};
  const Measured sum{Real(*force), Real(cln::abs(*force) + cln::abs(*driven)), {}};
  const Real scale = run.exact.largest + Real(oracle.energy());
  if (agrees(sum, Real(*driven), scale)) return {};
  return mismatch("w.(M a + bias)", sum.value, *driven);
}

/// M of the program where it has one and the model is big, else the oracle's.
std::vector<Real> mass_matrix(const Subject& subject, OracleCache& oracle) {
  const Function* function = find_function(subject.program, OutputKind::mass_matrix);
  if (function != nullptr && oracle.state().v.size() > directly_solved) {
    return evaluate(subject.program, *function, arguments_at<Real>(oracle.state()));
  }
  std::vector<Real> m;
  const OracleValues& values = oracle.values(standard_request(OutputKind::mass_matrix));
  if (!values) return m;
  for (const cl_R& value : *values) m.emplace_back(value);
  return m;
}

std::string compare_pivots(const Subject& subject, const FunctionRun& run, OracleCache& oracle) {
  const std::size_t n = oracle.state().v.size();
  const auto pivots =
      relative_pivots(mass_matrix(subject, oracle), n, eliminates_last_first(subject.model));
  if (!pivots) return {};
  for (std::size_t i = 0; i < n; ++i) {
    const Bound& entry = run.exact.entries[n + i];
    const Real& truth = (*pivots)[i];
    if (agrees({entry.value, entry.bound, {}}, truth, Real(1))) continue;
    return mismatch("a relative pivot", entry.value, truth.value());
  }
  return {};
}

}  // namespace

std::string compare_projection(const Subject& subject, const FunctionRun& run, OracleCache& oracle,
                               Random& random) {
  if (run.function.kind != OutputKind::forward_dynamics) {
    return compare_fields(subject, run, oracle, random);
  }
  const std::string mistake = compare_acceleration(subject, run, oracle, random);
  return mistake.empty() ? compare_pivots(subject, run, oracle) : mistake;
}

}  // namespace elgen
