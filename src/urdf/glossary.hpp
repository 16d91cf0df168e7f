// Glossary: the names of a model being made, and the parameters that its numbers become. URDF names
// may be any text; those of a model are letters, digits and underscores, no word of C++ or of the
// language, and all different. In formulas, joints of long names are q_1, q_2, … in the order of
// the coordinates, and what belongs to one has its number: m_1, I_{xx,1}.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "urdf/tree.hpp"

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

/// The parameters of one link and of the joint that carries it, as cells of a table.
struct ParameterGroup {
  std::string title = {};
  std::vector<std::vector<std::string>> rows = {};
};

class Glossary {
 public:
  Glossary(const Robot& robot, const LinkTree& tree);

  /// "world", or the frame of a link.
  [[nodiscard]] const std::string& frame(std::size_t link) const { return frames_[link]; }
  /// The one coordinate of a joint; of other joints, what their names start with.
  [[nodiscard]] const std::string& joint(std::size_t joint) const { return joints_[joint]; }
  /// The symbol of a joint's coordinate; empty where the names of all are short.
  [[nodiscard]] std::string symbol(std::size_t joint) const;
  /// Names the URDF has otherwise: "`left-leg` is called left_leg".
  [[nodiscard]] const std::vector<std::string>& renamed() const { return renamed_; }

  std::string claim(const std::string& wanted, const std::string& kind) {
    return names_.claim(wanted, kind);
  }

  /// Parameters go into this group from now on, that of a joint and the link it carries.
  void open_group(std::string title, const Branch& branch);
  /// A parameter of the open group; "0" for the number 0, so that it stays a zero of the equations.
  /// `more`: `key = value, …`
  std::string parameter(const std::string& name, const FileNumber& number, const std::string& unit,
                        const std::string& more = {});
  [[nodiscard]] const std::vector<ParameterGroup>& groups() const { return groups_; }

 private:
  void number_joints(const Robot& robot, std::vector<std::size_t> coordinates);
  [[nodiscard]] std::string parameter_symbol(const std::string& name) const;
  void note_change(const std::string& from, const std::string& to);

  Names names_ = {};
  std::vector<std::string> frames_;
  std::vector<std::string> joints_;
  std::vector<std::string> numbers_;  ///< of the coordinates of joints
  Branch open_ = {};                  ///< whose group is open
  std::vector<std::string> renamed_ = {};
  std::vector<ParameterGroup> groups_ = {};
};

}  // namespace elgen::urdf
