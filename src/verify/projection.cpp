// Projections against oracle_contraction. Accelerations are checked by what they must satisfy, w.(M
// a + bias) = w.B u, which needs no linear solve; relative pivots by the oracle's own solve for up
// to four coordinates, and for more of them by the program's mass matrix, which is checked itself.
#include "projection.hpp"

#include <fmt/format.h>

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

/// A sum with its bound.
struct Sum {
  Real value = {};
  Real bound = {};
  Real stated = {};  ///< beside rounding: of dropped terms
  void add(const Real& term, const Real& term_bound) {
    value = value + term;
    bound = bound + term_bound;
  }
};

bool agrees(const Sum& sum, const cl_R& truth, const Real& scale) {
  static const Real of_bound(power_of_ten(-50));
  static const Real of_scale(power_of_ten(-52));
  const Real allowed = sum.bound * of_bound + scale * of_scale + sum.stated;
  const Real difference = abs(sum.value - Real(truth));
  return difference.is_defined() && difference.value() <= allowed.value();
}

std::string mismatch(const char* what, const Sum& sum, const cl_R& truth) {
  return fmt::format("{} is {}, the oracle says {}", what, short_text(sum.value.value()),
                     short_text(truth));
}

/// Of the first field, as many entries as w and y have.
Sum contracted(const Subject& subject, const FunctionRun& run, const State& state,
               const Contraction& by) {
  Sum sum;
  const std::size_t columns = by.y.empty() ? 1 : by.y.size();
  for (std::size_t i = 0; i < by.w.size() * columns; ++i) {
    const cl_R factor = by.y.empty() ? by.w[i] : by.w[i / columns] * by.y[i % columns];
    const Bound& entry = run.exact.entries[i];
    const Real size(cln::abs(factor));
    sum.add(entry.value * Real(factor), entry.bound * size);
    sum.stated = sum.stated + stated_error(subject.program, run.function.kind, i, state) * size;
  }
  return sum;
}

Real rounding_scale(const FunctionRun& run, OracleCache& oracle) {
  return run.exact.largest + Real(oracle.energy());
}

std::string compare_field(const Subject& subject, const FunctionRun& run, OracleCache& oracle,
                          Random& random) {
  const Field& field = run.function.fields.front();
  Contraction by{random_direction(field.rows, random), {}};
  const bool is_matrix =
      output_row(run.function.kind).fields.front().columns != Extent::one || field.columns > 1;
  if (is_matrix) {
    by.y = random_direction(field.columns, random);
  }
  OutputRequest request = standard_request(run.function.kind);
  request.user = run.function.user;
  const auto truth = oracle_contraction(subject.model, request, oracle.state(), by);
  if (!truth) return {};
  const Sum sum = contracted(subject, run, oracle.state(), by);
  const Real scale = rounding_scale(run, oracle);
  if (agrees(sum, *truth, scale) || agrees(sum, *truth, scale + Real(oracle.force()))) return {};
  return mismatch(by.y.empty() ? "w.x" : "w.X y", sum, *truth);
}

/// w.(M a + bias) - w.B u at the program's exact acceleration.
std::string compare_acceleration(const Subject& subject, const FunctionRun& run,
                                 OracleCache& oracle, Random& random) {
  const std::size_t n = oracle.state().v.size();
  const Values w = random_direction(n, random);
  State state = oracle.state();
  for (std::size_t i = 0; i < n; ++i) state.a[i] = run.exact.entries[i].value.value();
  const auto force = oracle_projected_inverse_dynamics(subject.model, state, w);
  const auto driven =
      state.u.empty()
          ? std::optional<cl_R>(0)
          : oracle_contraction(subject.model, standard_request(OutputKind::input_matrix), state,
                               {w, state.u});
  if (!force || !driven) return {};
  Sum sum;
  sum.add(Real(*force), Real(cln::abs(*force) + cln::abs(*driven)));
  if (agrees(sum, *driven, rounding_scale(run, oracle))) return {};
  return mismatch("w.(M a + bias)", sum, *driven);
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
    Sum sum;
    sum.add(entry.value, entry.bound);
    const cl_R truth = (*pivots)[i].value();
    if (!agrees(sum, truth, Real(1))) return mismatch("a relative pivot", sum, truth);
  }
  return {};
}

}  // namespace

std::string compare_projection(const Subject& subject, const FunctionRun& run, OracleCache& oracle,
                               Random& random) {
  if (run.function.kind != OutputKind::forward_dynamics) {
    return compare_field(subject, run, oracle, random);
  }
  const std::string mistake = compare_acceleration(subject, run, oracle, random);
  return mistake.empty() ? compare_pivots(subject, run, oracle) : mistake;
}

}  // namespace elgen
