// Draft: the tables of a model file, as the joints and links of a robot make them one after
// another. Values are expressions of the model language, or the digits of numbers; "0" is what is
// not there.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/toml_text.hpp"
#include "urdf/glossary.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

/// A position that a coordinate gives: factor*coordinate + offset; a constant where factor is "0".
struct Coupling {
  std::string coordinate = {};
  std::string factor = "1";  ///< "1", "-1", "0" or parameters
  std::string offset = "0";

  [[nodiscard]] bool is_constant() const { return factor == "0"; }
  [[nodiscard]] bool has_sign_only() const { return factor == "1" || factor == "-1"; }

  [[nodiscard]] std::string position() const;
  [[nodiscard]] std::string rate() const;  ///< factor*dot(coordinate)
};

// Expressions of the model language as text, with what is 0 or 1 left out.
[[nodiscard]] std::string sum(const std::string& left, const std::string& right);
[[nodiscard]] std::string negated(const std::string& expression);
[[nodiscard]] std::string product(const std::string& factor, const std::string& expression);
[[nodiscard]] std::string quotient(const std::string& expression, const std::string& divisor);

/// A coordinate or an input of a joint.
struct JointTable {
  std::size_t joint = 0;
  TomlTable table;
};

/// Texts of tables, in the order of the file, and the terms of D.
struct Draft {
  const Robot& robot;
  const LinkTree& tree;
  Glossary glossary;
  std::vector<JointTable> coordinates = {};
  std::vector<std::string> links = {};  ///< frames and bodies, parents first
  std::vector<std::string> dissipation = {};
  std::vector<std::string> forces = {};
  std::vector<JointTable> inputs = {};
  std::map<std::size_t, Coupling> couplings = {};     ///< by joint
  std::map<std::size_t, std::string> armatures = {};  ///< of the coordinates of joints
};

using Components = std::array<std::string, 3>;

/// How a joint moves, in the axes of its origin.
struct JointMotion {
  Components translate = {"0", "0", "0"};
  std::vector<std::string> turn = {};  ///< at most one step
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

/// "x" of 0, "y" of 1, "z" of 2.
[[nodiscard]] std::string axis_letter(std::size_t axis);

/// ["0", "0.1", "l"]
[[nodiscard]] std::string vector_text(const Components& components);

/// ["z", "-pi/2"], of an axis as a TOML value
[[nodiscard]] std::string step_text(const std::string& axis, const std::string& angle);

/// "0 0 1.57": as the file has it.
[[nodiscard]] std::string listed(const Vector& numbers);

/// The components of a place; "c{}_arm" are the names of their parameters.
[[nodiscard]] Components place_of(Glossary& glossary, std::string_view name, const Vector& xyz);

/// The comments above a table, one a line.
[[nodiscard]] std::string comments(const std::vector<std::string>& lines);

/// Constant turns, z y x: R = Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] std::vector<std::string> steps_of(const RollPitchYaw& rotation);

/// The title, and "rpy in the URDF: 1.57079632679 0 0" where angles were rounded.
[[nodiscard]] std::vector<std::string> frame_comments(const std::string& title,
                                                      const RollPitchYaw& rotation,
                                                      const Vector& rpy);

[[nodiscard]] std::string frame_table(const FrameDraft& frame);

/// Units of what belongs to a coordinate that turns or slides.
struct JointUnits {
  std::string_view position;
  std::string_view rate;
  std::string_view force;
  std::string_view damping;
};

[[nodiscard]] JointUnits units_of(JointType type);

/// The position of a joint that turns or slides; parameters of a chain of mimics are added once.
[[nodiscard]] const Coupling& coupling_of(Draft& draft, std::size_t joint);

/// Adds what brakes such a joint, and the rotor that turns with it.
void draft_resistance(Draft& draft, std::size_t joint);

/// Adds the coordinates, inputs, damping and friction of a joint.
[[nodiscard]] JointMotion draft_joint(Draft& draft, const Branch& branch);

/// Adds the frame of the branch's child, after one for the joint's origin where one does not do.
void draft_frames(Draft& draft, const Branch& branch, const JointMotion& motion);

/// Adds the body of a link in its frame, after a frame in its principal axes where it needs one.
void draft_body(Draft& draft, std::size_t link);

/// The text of the model file of a robot without errors.
[[nodiscard]] std::string model_text(const Robot& robot, const LinkTree& tree);

}  // namespace elgen::urdf
