// text_errors: the errors of all forms of a function's entries at the points of comparison.
//
// The recursive form of a function, called the text here, consists of derivatives of the typed
// energies. E is the running error in u (accuracy/running_errors.hpp) of an entry x:
//
//     E > c max(E of the text, |x|)     the form is inaccurate in x; also if it has no value or its
//                                       value differs from the value of the text; c is 32 for V and
//                                       its derivatives, and 64 for all other functions
//     E / max(least known E, |x|)       the loss: digits that another rewriting keeps
//
// A point counts only if the text is finite in double there. At an exact zero the loss is 0,
// because points near the zero decide.
//
// Accuracy is decided in double, or in 64 digits if double is uncertain, so that all machines
// agree. Losses are compared in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "accuracy/conditioning.hpp"
#include "accuracy/running_errors.hpp"
#include "choose/points.hpp"
#include "program/graph/rebuild.hpp"

namespace elgen {

/// True if loss > max(tolerated, loss_equality_factor * other): the form with this loss loses many
/// more digits than the form with the loss `other`.
[[nodiscard]] bool loses_more(double loss, double other, double tolerated = tolerated_loss);

/// True for V and gravity, which must keep more digits than other functions.
[[nodiscard]] bool is_potential_or_gravity(const Function& text);

/// The magnitude |x| with which the error of an entry is compared.
enum class MagnitudeScope : std::uint8_t {
  entry,  ///< the entry itself
  field,  ///< the largest entry of its field, because a much smaller entry may be noise
};

/// E at each point; NaN if the rewriting has no value there.
using ErrorsAtPoints = std::vector<double>;

class FormErrors {
 public:
  /// Keeps references to `program` and `text`. Cost: one operation in double per instruction and
  /// point.
  FormErrors(const Program& program, const Function& text, Points points,
             MagnitudeScope scale = MagnitudeScope::field);

  /// E of a rewriting of entry number `entry`; none if the rewriting is inaccurate at a point.
  [[nodiscard]] std::optional<ErrorsAtPoints> errors_if_accurate(const Expressions& rewriting,
                                                                 std::size_t entry) const;

  /// The first inaccurate entry of another form; none if all are accurate.
  [[nodiscard]] std::optional<std::size_t> first_inaccurate_entry(const Program& program,
                                                                  const Function& form) const;

  /// E of a rewriting of one entry.
  [[nodiscard]] ErrorsAtPoints errors_of(const Expressions& rewriting) const;

  /// True if the errors are so large that a search for a better rewriting is worthwhile.
  [[nodiscard]] bool may_lose_digits(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// Updates the least known E of an entry at each point: min(least E, E of the rewriting).
  void add_rewriting(const ErrorsAtPoints& errors, std::size_t entry);

  /// Updates the least known E of each entry at each point: min(least E, E of `form`).
  void add_form(const Program& program, const Function& form);

  /// The largest loss of a rewriting at any point; infinite if only the text has a value there.
  [[nodiscard]] double loss_of(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// The largest loss of any entry of a form at any point.
  [[nodiscard]] double worst_loss(const Program& program, const Function& form) const;

 private:
  using RoughEntries = std::vector<RunningValue<double>>;  ///< entries of a form in double

  /// The number, in the text, of the first entry of `form` that is inaccurate at `point`; none if
  /// all are accurate. `form` starts with entry number `first` of the text.
  [[nodiscard]] std::optional<std::size_t> first_inaccurate_entry_at(const Program& program,
                                                                     const Function& form,
                                                                     std::size_t point,
                                                                     const RoughEntries& rough,
                                                                     std::size_t first) const;
  [[nodiscard]] std::vector<double> errors_at(const Program& program, const Function& form,
                                              std::size_t point) const;
  [[nodiscard]] std::vector<double> errors_at(const Program& program, const Function& form,
                                              std::size_t point, const RoughEntries& rough) const;
  [[nodiscard]] const std::vector<RunningValue<Real>>& exact_recursive_entries(
      std::size_t point) const;
  [[nodiscard]] std::vector<double> magnitudes_at(std::size_t point, MagnitudeScope scale) const;

  const Program& program_;
  const Function& text_;
  Points points_;
  std::vector<RunningErrorRules<double>> rules_ = {};  ///< by point
  std::vector<RoughEntries> rough_entries_ = {};       ///< of the text, by point and entry
  /// Entries of the text in 64 digits by point, computed on demand.
  mutable std::map<std::size_t, std::vector<RunningValue<Real>>> exact_entries_ = {};
  std::vector<std::vector<double>> magnitudes_ = {};  ///< by point and entry; NaN: no value
  /// Least E of all rewritings, by point and entry.
  std::vector<std::vector<double>> least_errors_ = {};
};

}  // namespace elgen
