// solution: forward dynamics of two or three velocities by determinants of M.
//
//     M a = r = B u - bias,   M = L D L^T
//     w_ij: determinant of rows 1 ... j-1, i and columns 1 ... j of M,   w_00 = 1
//     D_k = w_kk/w_(k-1)(k-1),   L_ik = w_ik/w_kk
//
//     before    D_2 = M_22 - M_12^2/M_11     m2 l2^2 - (m2 l1 l2 cos(a - b))^2/((m1 + m2) l1^2)
//     after     D_2 = w_22/M_11              m2 l1^2 l2^2 (m1 + m2 sin(a - b)^2)/((m1 + m2) l1^2)
//
// For nearly aligned links with m1 << m2, the difference cancels. w_kk is homogeneous in sines and
// cosines (forms/write/real_terms.hpp). If none of its terms can be negative, nothing cancels.
// Bareiss, Sylvester's identity and multistep integer-preserving Gaussian elimination, Math. Comp.
// 22 (1968).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "choose/entries.hpp"
#include "choose/finish.hpp"
#include "elgen/choose.hpp"
#include "program/evaluate/subject.hpp"
#include "program/network/instructions.hpp"

namespace elgen {
namespace {

/// Writes one function of w (n x n, by rows, lower triangle), M_ii and r from the functions of M,
/// the bias and B.
class SystemWriter {
 public:
  explicit SystemWriter(const Program& parts) : parts_(parts), instructions_(system_) {}

  /// None if M or the bias is missing.
  std::optional<Function> operator()(std::size_t n) {
    std::vector<std::uint32_t> entries = add_entries(OutputKind::mass_matrix);
    const std::vector<std::uint32_t> bias = add_entries(OutputKind::bias);
    if (bias.size() != n || entries.size() != n * n) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) entries.push_back(entries[i * n + i]);
    replace_by_minors(entries, n);
    append_forces(bias, entries);
    system_.fields.push_back({"", static_cast<std::uint32_t>(entries.size()), 1, entries});
    return std::move(system_);
  }

 private:
  /// Adds the instructions of a function; returns its entries, none without the function.
  std::vector<std::uint32_t> add_entries(OutputKind kind) {
    const Function* const part = find_function(parts_, kind);
    if (part == nullptr) return {};
    const std::vector<std::uint32_t> places = instructions_.add_all(*part);
    std::vector<std::uint32_t> entries = entries_of(*part);
    for (std::uint32_t& entry : entries) entry = places[entry];
    return entries;
  }

  void replace_by_minors(std::vector<std::uint32_t>& w, std::size_t n) {
    const auto multiply = [&](std::uint32_t x, std::uint32_t y) {
      return instructions_.add(Opcode::multiply, x, y);
    };
    for (std::size_t k = 1; k < n; ++k) {
      for (std::size_t i = k; i < n; ++i) {
        for (std::size_t j = k; j <= i; ++j) {
          std::uint32_t& entry = w[i * n + j];
          const std::uint32_t kept = multiply(w[(k - 1) * n + k - 1], entry);
          const std::uint32_t removed = multiply(w[i * n + k - 1], w[j * n + k - 1]);
          entry = instructions_.add(Opcode::subtract, kept, removed);
          if (k > 1) entry = instructions_.add(Opcode::divide, entry, w[(k - 2) * n + k - 2]);
        }
      }
    }
  }

  /// Appends r = B u - bias.
  void append_forces(const std::vector<std::uint32_t>& bias, std::vector<std::uint32_t>& entries) {
    const std::vector<std::uint32_t> b = add_entries(OutputKind::input_matrix);
    const std::size_t inputs = b.size() / bias.size();
    for (std::size_t i = 0; i < bias.size(); ++i) {
      std::uint32_t force = instructions_.add(Opcode::negate, bias[i]);
      for (std::uint32_t j = 0; j < inputs; ++j) {
        const std::uint32_t input = instructions_.add(Opcode::input, j);
        const std::uint32_t term = instructions_.add(Opcode::multiply, b[i * inputs + j], input);
        force = instructions_.add(Opcode::add, force, term);
      }
      entries.push_back(force);
    }
  }

  const Program& parts_;
  Function system_ = {};
  InstructionBuilder instructions_;
};

/// The closed forms of a function of SystemWriter; determinants of two and more rows are
/// homogeneous. None if a form is missing, or if a term of w_kk can be negative.
std::optional<ReadableEntries> read_system(const Program& system, std::size_t n) {
  const ClosedForms forms = present(system);
  ReadableEntries entries = read_entries(system, forms, 0, mixed_magnitude_points(system.leaves));
  if (!is_complete(entries)) return std::nullopt;
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t j = 1; j <= i; ++j) {
      const Fraction& minor = *forms.functions[0].fields[0].entries[i * n + j];
      const bool cancels = i == j && !has_nonnegative_terms(forms.algebra, minor, system.leaves);
      std::vector<CollectedForm> homogeneous = precise_rewritings(forms.algebra, minor);
      if (cancels || homogeneous.empty()) return std::nullopt;
      const auto shortest = std::ranges::min_element(homogeneous, {}, &CollectedForm::length);
      entries[i * n + j]->compact = std::move(shortest->expressions);
    }
  }
  return entries;
}

/// Solves M a = r in a graph. The entries are those of a function of SystemWriter.
class SystemSolver {
 public:
  SystemSolver(const ReadableEntries& entries, std::size_t size) : size_(size) {
    for (const auto& entry : entries) known_.push_back(copy_value(graph_, entry->compact));
  }

  /// The accelerations and, if `has_pivots`, the relative pivots and the diagonal of M.
  [[nodiscard]] ReadableEntries solve(bool has_pivots) {
    const auto diagonal = known_.begin() + static_cast<std::ptrdiff_t>(size_ * size_);
    std::vector<SignedNode> values = accelerations({diagonal + ssize(), known_.end()});
    if (has_pivots) {
      for (std::size_t i = 0; i < size_; ++i)
        values.push_back(quotient(pivot(i), known_[size_ * size_ + i]));
      values.insert(values.end(), diagonal, diagonal + ssize());
    }
    ReadableEntries entries;
    for (const SignedNode value : values) {
      entries.emplace_back(
          ReadableForm{.compact = Expressions{graph_, {value}}, .is_rewritten = true});
    }
    return entries;
  }

 private:
  [[nodiscard]] std::ptrdiff_t ssize() const { return static_cast<std::ptrdiff_t>(size_); }
  [[nodiscard]] SignedNode minor(std::size_t i, std::size_t j) const {
    return known_[i * size_ + j];
  }
  SignedNode quotient(SignedNode x, SignedNode y) { return graph_.product({{x, 1}, {y, -1}}); }
  SignedNode pivot(std::size_t k) {
    return k == 0 ? minor(0, 0) : quotient(minor(k, k), minor(k - 1, k - 1));
  }
  /// x - L_ik y
  SignedNode eliminate(SignedNode x, std::size_t i, std::size_t k, SignedNode y) {
    return graph_.sum({x, -graph_.product({{quotient(minor(i, k), minor(k, k)), 1}, {y, 1}})});
  }

  /// a, from r in `x`.
  std::vector<SignedNode> accelerations(std::vector<SignedNode> x) {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] = eliminate(x[i], i, k, x[k]);
    }
    for (std::size_t i = size_; i-- > 0;) {
      x[i] = quotient(x[i], pivot(i));
      for (std::size_t k = i + 1; k < size_; ++k) x[i] = eliminate(x[i], k, i, x[k]);
    }
    return x;
  }

  Graph graph_ = {};
  std::size_t size_;
  std::vector<SignedNode> known_ = {};
};

}  // namespace

bool may_solve_by_minors(const Scene& scene, const FormChoice& choice, std::size_t index) {
  const FormCosts& costs = choice.costs[index];
  const bool is_closed = costs.chosen_form == Form::closed;
  const std::optional<double>& loss = is_closed ? costs.closed_loss : costs.recursive_loss;
  return scene.numerics.prefer != Preference::speed && !costs.is_demanded &&
         is_small_solution(choice.program, choice.program.functions[index]) &&
         !(loss && *loss <= tolerated_loss);
}

void solve_by_minors(const Program& parts, const Program& recursive, const Domain& domain,
                     std::size_t index, FormChoice& choice) {
  const std::size_t size = recursive.leaves.v.size();
  std::optional<Function> system = SystemWriter(parts)(size);
  if (!system) return;
  const auto entries = read_system({parts.leaves, parts.constants, {std::move(*system)}}, size);
  if (!entries) return;
  const Function& text = recursive.functions[index];
  FormErrors errors(recursive, text, comparison_points(recursive, text, domain));
  const Function& own = choice.program.functions[index];
  errors.add_form(choice.program, own);
  const LoweringRequirements aim{.splits = ExpandedAngles::sums,
                                 .text = &errors,
                                 .max_loss = tolerated_loss,
                                 .most_quarters = quarters_for_balance};
  LoweredEntries solved = lower_jointly(SystemSolver(*entries, size).solve(has_pivots(text)), text,
                                        choice.program, aim);
  if (solved.first_inaccurate) return;
  Function form = with_trigonometry_first(
      with_guarded_pivots(std::move(solved.function), choice.program.constants));
  errors.add_form(choice.program, form);
  const double loss = errors.worst_loss(choice.program, form);
  FormCosts& costs = choice.costs[index];
  const OperationCounts operations = count_operations(form);
  const std::size_t least =
      std::min(cost(costs.recursive), cost(costs.closed.value_or(costs.recursive)));
  if (!loses_more(errors.worst_loss(choice.program, own), loss) ||
      !is_affordable(cost(operations), least, quarters_for_balance))
    return;
  costs.chosen_form = Form::closed;
  costs.closed = operations;
  costs.closed_loss = loss;
  costs.inaccurate_entry.reset();
  form.rewritten.resize(entry_count(form));
  std::iota(form.rewritten.begin(), form.rewritten.end(), 0U);
  choice.program.functions[index] = std::move(form);
}

}  // namespace elgen
