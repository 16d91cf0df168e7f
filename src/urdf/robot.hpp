// Robot: a URDF file as written, numbers exact and with their digits, every piece with its span.
//
// read_robot() checks what needs no knowledge of other elements; make_tree() (tree.hpp) the rest.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/limits.hpp"
#include "urdf/numbers.hpp"
#include "urdf/xml.hpp"

namespace elgen::urdf {

/// A text of the file, where a message may point.
struct Text {
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
  Span span = {};                          ///< `inertia` in its tag
};

struct Link {
  Text name = {};
  std::optional<Inertial> inertial = {};

  [[nodiscard]] bool has_mass() const { return inertial && !inertial->mass.is_zero(); }
};

enum class JointType : unsigned char { revolute, continuous, prismatic, fixed, floating, planar };

[[nodiscard]] std::string_view word(JointType type);

/// Revolute, continuous and prismatic joints.
[[nodiscard]] bool has_one_coordinate(JointType type);

struct JointLimit {
  std::optional<FileNumber> lower = {};
  std::optional<FileNumber> upper = {};
  std::optional<FileNumber> velocity = {};
  std::optional<FileNumber> effort = {};
};

struct Mimic {
  Text joint = {};
  FileNumber multiplier = {};
  FileNumber offset = {};
};

struct Joint {
  Text name = {};
  JointType type = JointType::fixed;
  Text parent = {};
  Text child = {};
  Pose origin = {};
  Vector axis = {};
  Span axis_span = {};
  JointLimit limit = {};
  FileNumber damping = {};
  FileNumber friction = {};
  std::optional<Mimic> mimic = {};
};

struct Robot {
  std::string file = {};  ///< name of the file, without its folders
  std::string name = {};
  Span span = {};  ///< `robot` in its tag
  std::vector<Link> links = {};
  std::vector<Joint> joints = {};
};

/// What reading needs on the way.
struct RobotReading {
  const Limits& limits;
  Diagnostics& found;
};

/// E802 to E806, E811, E813, E814; notes E815. What is missing is left at its default.
[[nodiscard]] Robot read_robot(const Element& root, RobotReading& reading);
[[nodiscard]] Link read_link(const Element& element, RobotReading& reading);
[[nodiscard]] Joint read_joint(const Element& element, RobotReading& reading);

}  // namespace elgen::urdf
