// text_errors: the errors of all forms of a function's entries at its points.
//
//     E > 64 max(E of the text, |x|)      the form loses an entry x that the text keeps, as it does
//                                         where it has another value or none
//     E / max(least known E, |x|)         the loss: digits that another rewriting keeps
//
// E is the running error in u (accuracy/running_errors.hpp). The text is the recursive form: the
// typed energies, differentiated. Accuracy is decided in double, or in 64 digits if that is
// uncertain, so that all machines agree. Losses are compared in double.
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
/// costs are ignored.
[[nodiscard]] bool loses_more(double loss, double other, double tolerated = tolerated_loss);

/// The magnitude |x| with which a loss compares errors.
enum class Scale : std::uint8_t {
  entry,  ///< the entry itself
  field,  ///< the largest entry of its field: one that vanishes among others may be noise
};

/// E by point; not a number if the rewriting has no value there.
using ErrorsAtPoints = std::vector<double>;

class TextErrors {
 public:
  /// `program` and `text` must outlive it. Cost: one operation in double per instruction and point.
  TextErrors(const Program& program, const Function& text, Points points,
             Scale scale = Scale::field);

  /// E of a rewriting of entry number `entry`; none if it is less accurate than the text.
  [[nodiscard]] std::optional<ErrorsAtPoints> accurate_errors(const Expressions& rewriting,
                                                              std::size_t entry) const;

  /// The first inaccurate entry of another form; none if all are accurate.
  [[nodiscard]] std::optional<std::size_t> inaccurate_entry(const Program& program,
                                                            const Function& form) const;

  /// E of a rewriting of one entry.
  [[nodiscard]] ErrorsAtPoints errors_of(const Expressions& rewriting) const;

  /// Whether the errors are so large that a better rewriting should be searched.
  [[nodiscard]] bool may_lose(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// Adds the errors of one rewriting to the known ones.
  void add_rewriting(const ErrorsAtPoints& errors, std::size_t entry);

  /// Adds the errors of all entries of a form.
  void add_form(const Program& program, const Function& form);

  /// The largest loss at any point; infinite if only the text has a value.
  [[nodiscard]] double loss_of(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// The largest loss of the entries of a form.
  [[nodiscard]] double worst_loss(const Program& program, const Function& form) const;

 private:
  using Entries = std::vector<Running<double>>;  ///< of a form, in double

  /// The first entry less accurate than the text's; `first` is the number of the first of them.
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
  mutable std::map<std::size_t, std::vector<Running<Real>>> exact_ = {};  ///< computed on demand
  std::vector<std::vector<double>> magnitudes_ = {};  ///< by point and entry; NaN: no value
  std::vector<std::vector<double>> least_ = {};       ///< least E of all rewritings
};

}  // namespace elgen
