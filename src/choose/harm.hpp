// harm: the errors of one function's entries, in every form of it, at its points.
//
//     E > 64 max(E of the text, |x|)      the form harms an entry x that the text keeps, as it does
//                                         where it has another value or none
//     E / max(least known E, |x|)         the loss: digits that another known way keeps
//
// E is the running error in u (accuracy/running_errors.hpp). The text is the recursive form: the
// energies as they were typed, differentiated. At the extremes of accuracy, where one way or
// another is lucky, K stands in the place of the least E (accuracy/conditioning.hpp). Harm is
// decided in double first, and where that is not sure in 64 digits, so that every machine decides
// alike; losses are compared in double, where they have one.
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

/// Whether one way loses so much more than another, and more than `tolerated`, that it does not
/// matter which is cheaper.
[[nodiscard]] bool loses_more(double loss, double other, double tolerated = tolerated_loss);

/// The magnitude |x| that errors are compared with in a loss.
enum class Scale : std::uint8_t {
  entry,  ///< the entry itself
  field,  ///< the largest entry of its field: one that vanishes among others may be noise
};

/// By point, E; not a number where the way has no value.
using ErrorsAtPoints = std::vector<double>;

class TextErrors {
 public:
  /// Harm is looked for at `points`, loss at these and at `extremes`. `program` and `text` outlive
  /// it. Cost: one operation of double per instruction and point.
  TextErrors(const Program& program, const Function& text, Points points, Scale scale,
             const Points& extremes = {});

  /// Whether a way harms one entry of the text, by its number among all.
  [[nodiscard]] bool is_harmed_by(const Expressions& way, std::size_t entry) const;

  /// The first entry of another form that is harmed; none where no entry is.
  [[nodiscard]] std::optional<std::size_t> harmed_entry(const Program& program,
                                                        const Function& form) const;

  /// E of a way to write one entry.
  [[nodiscard]] ErrorsAtPoints errors_of(const Expressions& way) const;

  /// Whether errors of a way may be a loss, if another way has less.
  [[nodiscard]] bool may_lose(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// From now on the errors of this way are known, too.
  void add_way(const ErrorsAtPoints& errors, std::size_t entry);

  /// The largest loss at any point; infinite where there is no value but the text has one.
  [[nodiscard]] double loss_of(const ErrorsAtPoints& errors, std::size_t entry) const;

  /// The largest loss of all entries of a form.
  [[nodiscard]] double worst_loss(const Program& program, const Function& form) const;

 private:
  [[nodiscard]] std::optional<std::size_t> harmed(const Program& program, const Function& form,
                                                  std::size_t first, std::size_t point) const;
  [[nodiscard]] const std::vector<Running<Real>>& exact_text(std::size_t point) const;
  [[nodiscard]] std::vector<double> errors_at(const Program& program, const Function& form,
                                              std::size_t point) const;
  [[nodiscard]] std::vector<double> conditions_at(std::size_t point) const;
  [[nodiscard]] std::vector<double> magnitudes_at(std::size_t point, Scale scale) const;

  const Program& program_;
  const Function& text_;
  std::size_t harm_points_;  ///< the first so many points
  Points points_;
  std::vector<std::vector<Running<double>>> rough_ = {};  ///< of the text, by point and entry
  mutable std::map<std::size_t, std::vector<Running<Real>>> exact_ = {};  ///< once it is asked for
  std::vector<std::vector<double>> magnitudes_ = {};  ///< by point and entry; NaN: no value
  std::vector<std::vector<double>> least_ = {};       ///< E of all known ways, or K, likewise
};

}  // namespace elgen
