// Glossary: the names of the new model, and the parameters for its numbers. URDF names may be any
// text. Model names consist of letters, digits and underscores, are no words of C++ or of the model
// language, and are unique. If any coordinate has a long name, formulas call the coordinates q_1,
// q_2, … in their order, and parameters get the number of their joint: m_1, I_{xx,1}.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "urdf/tree.hpp"

namespace elgen::urdf {

class NameRegistry {
 public:
  /// Returns `wanted` or a similar name that is not in use yet, and reserves it. If `wanted` is
  /// reserved or in use, `kind` is prepended: `union` becomes `link_union`.
  std::string claim(std::string_view wanted, std::string_view kind);

 private:
  std::set<std::string> used_ = {};
};

/// A well-formed name made from `text`: other characters become underscores, and a first digit gets
/// the prefix n. "left-leg.1" becomes "left_leg_1". The name may be in use.
[[nodiscard]] std::string well_formed_name(std::string_view text);

/// `robot` as the name of a model: well-formed, in lower case, and no reserved word.
[[nodiscard]] std::string model_name(std::string_view robot);

/// The parameters of one link and of its joint, as cells of a table.
struct ParameterGroup {
  std::string title = {};
  std::vector<std::vector<std::string>> rows = {};
};

class Glossary {
 public:
  Glossary(const Robot& robot, const LinkTree& tree);

  /// "world", or the frame of a link.
  [[nodiscard]] const std::string& frame_name(std::size_t link) const { return frames_[link]; }
  /// The name of the joint's coordinate. For a joint with several coordinates or none: the prefix
  /// of the names that belong to it.
  [[nodiscard]] const std::string& joint_name(std::size_t joint) const { return joints_[joint]; }
  /// The symbol of a joint's coordinate; empty if all names are short.
  [[nodiscard]] std::string joint_symbol(std::size_t joint) const;
  /// Names that differ from the URDF: "`left-leg` is called left_leg".
  [[nodiscard]] const std::vector<std::string>& name_changes() const { return name_changes_; }

  std::string claim(const std::string& wanted, const std::string& kind) {
    return names_.claim(wanted, kind);
  }

  /// Starts the group of parameters of a joint and the link that it carries.
  void open_group(std::string title, const Branch& branch);
  /// Adds a parameter to the open group and returns its name. For the number 0 it adds nothing and
  /// returns "0". `more`: further keys of the parameter, `key = value, …`
  std::string add_parameter(const std::string& name, const FileNumber& number,
                            const std::string& unit, const std::string& more = {});
  [[nodiscard]] const std::vector<ParameterGroup>& groups() const { return groups_; }

 private:
  void number_joints(const Robot& robot, std::vector<std::size_t> coordinates);
  [[nodiscard]] std::string parameter_symbol(const std::string& name) const;
  void record_name_change(const std::string& from, const std::string& to);

  NameRegistry names_ = {};
  std::vector<std::string> frames_;
  std::vector<std::string> joints_;
  std::vector<std::string> numbers_;  ///< number of the joint's coordinate in symbols, by joint
  Branch open_ = {};                  ///< the branch of the open group
  std::vector<std::string> name_changes_ = {};
  std::vector<ParameterGroup> groups_ = {};
};

}  // namespace elgen::urdf
