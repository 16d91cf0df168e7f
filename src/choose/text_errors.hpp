// text_errors: the errors of one function's entries, in all its forms, at its points.
//
//     E > 64 max(E of the text, |x|)      the form loses an entry x that the text keeps, as it does
//                                         where it has another value or none
//     E / max(least known E, |x|)         the loss: digits that another rewriting keeps
//
// E is the running error in u (accuracy/running_errors.hpp). The text is the recursive form: the
// energies as they were typed, differentiated. Accuracy is decided in double, or where that is not
// sure in 64 digits, so that all machines decide alike; losses are compared in double.
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

/// Whether one rewriting loses so many more digits than another, and more than `tolerated`, that
/// costs do not count.
[[nodiscard]] bool loses_more(double loss, double other, double tolerated = tolerated_loss);

/// The magnitude |x| that errors are compared with in a loss.
enum class Scale : std::uint8_t {
  entry,  ///< the entry itself
  field,  ///< the largest entry of its field: one that vanishes among others may be noise
};

/// By point, E; not a number where the rewriting has no value.
using ErrorsAtPoints = std::vector<double>;

class TextErrors {
 public:
  /// `program` and `text` outlive it. Cost: one operation of double per instruction and point.
  TextErrors(const Program& program, const Function& text, Points points,
             Scale scale = Scale::field);

  /// E of a rewriting of one entry, by its number among all; none where it is less accurate than
  /// the text.
  [[nodiscard]] std::optional<ErrorsAtPoints> accurate_errors(const Expressions& rewriting,
                                                              std::size_t entry) const;

  /// The first inaccurate entry of another form; none where all are accurate.
  [[nodiscard]] std::optional<std::size_t> inaccurate_entry(const Program& program,
                                                            const Function& form) const;

  /// E of a rewriting of one entry.
  [[nodiscard]] ErrorsAtPoints errors_of(const Expressions& rewriting) const;

  /// Whether the errors are so large that a better rewriting is worth looking for.
  [[nodiscard]] bool may_lose(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// Adds the errors of one rewriting to the known ones.
  void add_rewriting(const ErrorsAtPoints& errors, std::size_t entry);

  /// Adds those of all entries of a form.
  void add_form(const Program& program, const Function& form);

  /// The largest loss at any point; infinite where there is no value but the text has one.
  [[nodiscard]] double loss_of(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// The largest loss of all entries of a form.
  [[nodiscard]] double worst_loss(const Program& program, const Function& form) const;

 private:
  using Entries = std::vector<Running<double>>;  ///< of a form, in double

  /// The first of the entries that is less accurate than the text's, of which it is the `first`.
  [[nodiscard]] std::optional<std::size_t> inaccurate_entry_at(const Program& program,
                                                               const Function& form,
                                                               std::size_t point,
                                                               const Entries& rough,
                                                               std::size_t first) const;
  [[nodiscard]] std::vector<double> errors_at(const Program& program, const Function& form,
                                              std::size_t point) const;
  [[nodiscard]] std::vector<double> errors_at(const Program& program, const Function& form,
                                              std::size_t point, const Entries& rough) const;
  [[nodiscard]] const std::vector<Running<Real>>& exact_text(std::size_t point) const;
  [[nodiscard]] std::vector<double> magnitudes_at(std::size_t point, Scale scale) const;

  const Program& program_;
  const Function& text_;
  Points points_;
  std::vector<RunningErrorRules<double>> rules_ = {};  ///< by point
  std::vector<Entries> rough_ = {};                    ///< of the text, by point and entry
  mutable std::map<std::size_t, std::vector<Running<Real>>> exact_ = {};  ///< once it is asked for
  std::vector<std::vector<double>> magnitudes_ = {};  ///< by point and entry; NaN: no value
  std::vector<std::vector<double>> least_ = {};       ///< E of all rewritings, likewise
};

}  // namespace elgen
