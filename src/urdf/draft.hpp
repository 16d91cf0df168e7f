// ModelDraft: the tables of a model file, collected from the joints and links of a robot. Values
// are expressions of the model language, or the digits of numbers; "0" means absent.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/toml_text.hpp"
#include "urdf/glossary.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

/// A position as a function of a coordinate: factor*coordinate + offset; constant if factor is "0".
struct Coupling {
  std::string coordinate = {};
  std::string factor = "1";  ///< "1", "-1", "0" or parameters
  std::string offset = "0";

  [[nodiscard]] bool is_constant() const { return factor == "0"; }
  [[nodiscard]] bool has_sign_only() const { return factor == "1" || factor == "-1"; }

  [[nodiscard]] std::string position_text() const;
  [[nodiscard]] std::string rate_text() const;  ///< factor*dot(coordinate)
};

// Expressions of the model language as text; zero terms and factors of 1 are omitted.
[[nodiscard]] std::string sum_text(const std::string& left, const std::string& right);
[[nodiscard]] std::string negated_text(const std::string& expression);
[[nodiscard]] std::string product_text(const std::string& factor, const std::string& expression);
[[nodiscard]] std::string quotient_text(const std::string& expression, const std::string& divisor);

/// The table of a coordinate or an input, and the index of its joint.
struct JointTable {
  std::size_t joint = 0;
  TomlTable table;
};

/// The texts of the model's tables, each list in the order of the file, and the terms of D.
struct ModelDraft {
  const Robot& robot;
  const LinkTree& tree;
  Glossary glossary;
  std::vector<JointTable> coordinates = {};
  std::vector<std::string> link_tables = {};  ///< frames and bodies, parents first
  std::vector<std::string> dissipation = {};
  std::vector<std::string> forces = {};
  std::vector<JointTable> inputs = {};
  std::map<std::size_t, Coupling> couplings = {};     ///< by joint
  std::map<std::size_t, std::string> armatures = {};  ///< by the joint that has the coordinate
};

using Components = std::array<std::string, 3>;

/// The motion of a joint, in the axes of its origin.
struct JointMotion {
  Components translate = {"0", "0", "0"};
  std::vector<std::string> turn = {};  ///< empty or one step, ["z", "q"]
  std::string attitude = {};           ///< a coordinate of kind rotation
};

struct FrameDraft {
  std::vector<std::string> comments = {};
  std::string name = {};
  std::string parent = {};
  Components translate = {"0", "0", "0"};
  std::vector<std::string> rotate = {};  ///< steps: ["z", "-pi/2"]
  std::string rotation = {};             ///< a coordinate of kind rotation
};

/// "x" for 0, "y" for 1, "z" for 2.
[[nodiscard]] std::string axis_letter(std::size_t axis);

/// ["0", "0.1", "l"]
[[nodiscard]] std::string vector_text(const Components& components);

/// ["z", "-pi/2"]; `axis` is a TOML value.
[[nodiscard]] std::string turn_text(const std::string& axis, const std::string& angle);

/// "0 0 1.57", with the digits of the file.
[[nodiscard]] std::string numbers_text(const Vector& numbers);

/// The components of a position as parameters. `name` is the pattern of their names: "c{}_arm".
[[nodiscard]] Components position_components(Glossary& glossary, std::string_view name,
                                             const Vector& xyz);

/// The comments above a table, one per line.
[[nodiscard]] std::string comment_lines(const std::vector<std::string>& lines);

/// Steps of a constant rotation, in the order z, y, x: R = Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] std::vector<std::string> turn_texts(const RollPitchYaw& rotation);

/// The title; if angles were rounded, also "rpy in the URDF: 1.57079632679 0 0".
[[nodiscard]] std::vector<std::string> frame_comments(const std::string& title,
                                                      const RollPitchYaw& rotation,
                                                      const Vector& rpy);

[[nodiscard]] std::string frame_table(const FrameDraft& frame);

/// Units of a revolute or prismatic coordinate, its rate, force and damping.
struct JointUnits {
  std::string_view position;
  std::string_view rate;
  std::string_view force;
  std::string_view damping;
};

[[nodiscard]] JointUnits joint_units(JointType type);

/// The position of a joint that has one coordinate. The first call for a joint adds its parameters.
[[nodiscard]] const Coupling& find_or_add_coupling(ModelDraft& draft, std::size_t joint);

/// Adds the damping, the friction and the rotor of a joint that has one coordinate.
void draft_joint_dynamics(ModelDraft& draft, std::size_t joint);

/// Adds the coordinates, inputs, damping and friction of a joint; returns its motion.
[[nodiscard]] JointMotion draft_joint(ModelDraft& draft, const Branch& branch);

/// Adds the frame of the branch's child. If the joint slides and its origin is rotated, a frame for
/// the origin comes first.
void draft_frames(ModelDraft& draft, const Branch& branch, const JointMotion& motion);

/// Adds the body of a link in its frame. If the inertia cannot be rotated exactly, a frame in the
/// axes of the inertia comes first.
void draft_body(ModelDraft& draft, std::size_t link);

/// The text of the model file; the robot must have no errors.
[[nodiscard]] std::string model_text(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
