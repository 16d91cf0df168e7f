// Names: URDF names may be any text; those of a model are letters, digits and underscores, no word
// of C++ or of the language, and all different.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace elgen::urdf {

class Names {
 public:
  /// A name like `wanted` that was not given before; where it means something else already, with
  /// `kind` before it: `union` becomes `link_union`.
  std::string claim(std::string_view wanted, std::string_view kind);

 private:
  std::set<std::string> taken_ = {};
};

/// `text` as a name, but for its being free: "left-leg.1" becomes "left_leg_1".
[[nodiscard]] std::string well_formed(std::string_view text);

/// The model's name: in lower case.
[[nodiscard]] std::string model_name(std::string_view robot);

}  // namespace elgen::urdf
