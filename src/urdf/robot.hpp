// Robot: the content of a URDF file, with exact numbers, their digits and all spans. Options change
// the Robot before the model is written.
//
// read_robot() checks each element by itself; make_tree() (tree.hpp) checks references between
// elements.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "urdf/numbers.hpp"
#include "urdf/rotations.hpp"
#include "urdf/xml.hpp"

namespace elgen::urdf {

/// A text of the file, with the span for messages.
struct SpannedText {
  std::string text = {};
  Span span = {};
};

struct Pose {
  Vector xyz = {};
  Vector rpy = {};
};

struct Inertial {
  Pose origin = {};
  FileNumber mass = {};
  std::array<FileNumber, 6> inertia = {};  ///< xx yy zz xy xz yz
  Span span = {};                          ///< the word `inertia` in the tag
};

struct Link {
  SpannedText name = {};
  std::optional<Inertial> inertial = {};

  [[nodiscard]] bool has_mass() const { return inertial && !inertial->mass.is_zero(); }
  [[nodiscard]] bool has_inertia() const {
    return inertial && !std::ranges::all_of(inertial->inertia, &FileNumber::is_zero);
  }
};

enum class JointType : unsigned char { revolute, continuous, prismatic, fixed, floating, planar };

[[nodiscard]] std::string_view type_word(JointType type);

/// True for revolute, continuous and prismatic joints.
[[nodiscard]] bool has_one_coordinate(JointType type);

struct JointLimit {
  std::optional<FileNumber> lower = {};
  std::optional<FileNumber> upper = {};
  std::optional<FileNumber> velocity = {};
  std::optional<FileNumber> effort = {};
};

struct Mimic {
  SpannedText joint = {};
  FileNumber multiplier = {};
  FileNumber offset = {};
};

/// The rotor of a motor; it turns gear_ratio times as fast as the joint.
struct Rotor {
  FileNumber inertia = {};
  FileNumber gear_ratio = make_file_number(1);
};

struct Joint {
  SpannedText name = {};
  JointType type = JointType::fixed;
  SpannedText parent = {};
  SpannedText child = {};
  Pose origin = {};
  Vector axis = {make_file_number(1), make_file_number(0),
                 make_file_number(0)};  ///< URDF's default
  Span axis_span = {};
  JointLimit limit = {};
  FileNumber damping = {};
  FileNumber friction = {};
  std::optional<Mimic> mimic = {};
  std::optional<Rotor> rotor = {};
  std::optional<FileNumber> weld_position = {};  ///< the position at which the joint is held
  bool is_angle_welded = false;  ///< planar joint: the angle is held, the lengths are not
  std::size_t rank = 0;          ///< sort key of the coordinates

  [[nodiscard]] bool moves() const { return type != JointType::fixed && !weld_position; }
};

/// True if a rotor resists the acceleration of the joint.
[[nodiscard]] inline bool has_rotor(const Joint& joint) {
  return joint.rotor && !joint.rotor->inertia.is_zero() && !joint.rotor->gear_ratio.is_zero();
}

struct Robot {
  std::string file = {};   ///< name of the file, without its folders
  std::string name = {};   ///< the file's name if the robot has no name
  std::string model = {};  ///< the name of the model
  Span span = {};          ///< the word `robot` in the tag
  bool uses_xacro = false;
  AngleRounding digits = AngleRounding::round;
  std::vector<Link> links = {};
  std::vector<Joint> joints = {};
};

[[nodiscard]] inline bool has_mass(const Robot& robot) {
  return std::ranges::any_of(robot.links, &Link::has_mass);
}

/// Limits and diagnostics shared while a robot is read.
struct RobotReadState {
  const Limits& limits;
  Diagnostics& diagnostics;
  std::string file = {};  ///< the name of the file; empty: the source's name
};

/// Reads a `<robot>`. Errors and warnings: E108, E802 to E806, E811, E813, E814, E822, E903, E904;
/// notes: E815. Missing values keep their defaults.
[[nodiscard]] Robot read_robot(const Element& root, RobotReadState& reading);

}  // namespace elgen::urdf
