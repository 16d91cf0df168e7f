// Krawczyk's test uses a slightly enlarged box, so that a solution on the border of two boxes is
// inside both.
#include "analyse/boxes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "numbers/dual.hpp"

namespace elgen {
namespace {

double middle(const Enclosure& x) { return x.low + (x.high - x.low) / 2; }
double length(const Enclosure& x) { return x.high - x.low; }

/// The relative enlargement of a tested box on each side.
constexpr double margin = 0.05;

/// If all undecided boxes are smaller than the resolution, this number divides the resolution.
/// Thus boxes along a curve of solutions have equal sizes when the limit of boxes is reached.
constexpr double refinement = 16;

Box enlarge_box(const Box& box) {
  Box result;
  for (const Enclosure& side : box) {
    const double by = margin * length(side) + 1e-300;
    result.push_back({side.low - by, side.high + by});
  }
  return result;
}

Box middle_of(const Box& box) {
  Box result;
  for (const Enclosure& side : box) result.push_back(point_enclosure(middle(side)));
  return result;
}

/// The box of all common points; none if the boxes do not intersect.
std::optional<Box> intersection(const Box& x, const Box& y) {
  Box result;
  for (std::size_t i = 0; i < x.size(); ++i) {
    result.push_back({std::max(x[i].low, y[i].low), std::min(x[i].high, y[i].high)});
    if (result.back().low > result.back().high) return std::nullopt;
  }
  return result;
}

bool is_inside(const Box& inner, const Box& outer) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i].low <= outer[i].low || inner[i].high >= outer[i].high) return false;
  }
  return true;
}

bool are_all_finite(const std::vector<Enclosure>& values) {
  return std::ranges::all_of(values, [](const Enclosure& value) {
    return value.definedness == Definedness::everywhere && std::isfinite(value.low) &&
           std::isfinite(value.high);
  });
}

class KrawczykSearch {
 public:
  KrawczykSearch(const IntervalEquations& equations, const Box& domain)
      : equations_(equations), domain_(domain), size_(domain.size()) {
    rows_ = entries_of(equations.function).size();
  }

  BoxSearchResult operator()(std::uint64_t most) {
    std::vector<Box> open{domain_};
    while (true) {
      while (!open.empty() && result_.examined < most) {
        const Box box = std::move(open.back());
        open.pop_back();
        ++result_.examined;
        examine(box, open);
      }
      if (!open.empty() || resolution_ <= box_resolution) break;
      resolution_ /= refinement;
      open = std::exchange(result_.undecided, {});
    }
    result_.open_boxes = std::move(open);
    return std::move(result_);
  }

 private:
  void examine(Box box, std::vector<Box>& open) {
    const std::vector<Enclosure> values = enclose_values(equations_, box);
    if (!std::ranges::all_of(values,
                             [](const Enclosure& value) { return may_contain(value, 0); })) {
      return;
    }
    const Box tested = enlarge_box(box);
    if (const std::optional<Box> image = krawczyk_image(tested)) {
      const std::optional<Box> rest = intersection(*image, box);
      if (is_inside(*image, tested)) {
        result_.single.push_back(*image);
        return;
      }
      if (!rest) return;
      box = *rest;
    }
    const std::size_t longest = longest_side(box);
    if (length(box[longest]) < resolution_ * length(domain_[longest])) {
      result_.undecided.push_back(std::move(box));
      return;
    }
    Box half = box;
    half[longest].high = middle(box[longest]);
    box[longest].low = half[longest].high;
    open.push_back(std::move(box));
    open.push_back(std::move(half));
  }

  /// The index of the side of `box` that is longest relative to the same side of the domain.
  [[nodiscard]] std::size_t longest_side(const Box& box) const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < size_; ++i) {
      if (length(box[i]) * length(domain_[longest]) > length(box[longest]) * length(domain_[i])) {
        longest = i;
      }
    }
    return longest;
  }

  /// K(box) of the first n equations, n the number of unknowns; none if J has no inverse, or if a
  /// value is undefined.
  [[nodiscard]] std::optional<Box> krawczyk_image(const Box& box) const {
    if (rows_ < size_) return std::nullopt;
    const std::optional<std::vector<Enclosure>> slopes = enclose_jacobian(box);
    const Box centre = middle_of(box);
    const std::vector<Enclosure> values = enclose_values(equations_, centre);
    if (!slopes || !are_all_finite(values)) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(size_);
    Eigen::MatrixXd jacobian(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index k = 0; k < n; ++k) {
        jacobian(i, k) = middle((*slopes)[static_cast<std::size_t>(i * n + k)]);
      }
    }
    const Eigen::MatrixXd inverse = jacobian.inverse();
    if (!inverse.allFinite()) return std::nullopt;
    Box image;
    for (std::size_t i = 0; i < size_; ++i) {
      const auto weight = [&](std::size_t j) {
        return point_enclosure(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      };
      Enclosure sum = centre[i];
      for (std::size_t j = 0; j < size_; ++j) sum = sum - weight(j) * values[j];
      for (std::size_t k = 0; k < size_; ++k) {
        Enclosure rest = point_enclosure(i == k ? 1 : 0);
        for (std::size_t j = 0; j < size_; ++j) {
          rest = rest - weight(j) * (*slopes)[j * size_ + k];
        }
        sum = sum + rest * (box[k] - centre[k]);
      }
      image.push_back(sum);
    }
    if (!are_all_finite(image)) return std::nullopt;
    return image;
  }

  /// df/dq, row-major; none if an entry is undefined.
  [[nodiscard]] std::optional<std::vector<Enclosure>> enclose_jacobian(const Box& box) const {
    LeafValues<Dual<Enclosure>> leaves = map_leaves(
        [](const Enclosure& x) {
          return Dual<Enclosure>{x, point_enclosure(0)};
        },
        equations_.leaves);
    for (std::size_t i = 0; i < size_; ++i) leaves.q[equations_.unknowns[i]].value = box[i];
    std::vector<Enclosure> slopes(rows_ * size_);
    for (std::size_t k = 0; k < size_; ++k) {
      Enclosure& along = leaves.q[equations_.unknowns[k]].slope;
      along = point_enclosure(1);
      const auto entries = evaluate(equations_.program, equations_.function, leaves);
      along = point_enclosure(0);
      for (std::size_t i = 0; i < rows_; ++i) slopes[i * size_ + k] = entries[i].slope;
    }
    if (!are_all_finite(slopes)) return std::nullopt;
    return slopes;
  }

  const IntervalEquations& equations_;
  const Box& domain_;
  std::size_t size_;
  std::size_t rows_ = 0;
  double resolution_ = box_resolution * (refinement * refinement * refinement * refinement);
  BoxSearchResult result_;
};

}  // namespace

std::vector<Enclosure> enclose_values(const IntervalEquations& equations, const Box& box) {
  LeafValues<Enclosure> leaves = equations.leaves;
  for (std::size_t i = 0; i < box.size(); ++i) leaves.q[equations.unknowns[i]] = box[i];
  return evaluate(equations.program, equations.function, leaves);
}

BoxSearchResult search_boxes(const IntervalEquations& equations, const Box& domain,
                             std::uint64_t max_boxes) {
  return KrawczykSearch(equations, domain)(max_boxes);
}

}  // namespace elgen
