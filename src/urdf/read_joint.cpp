// <joint>: how a link moves in its parent, and what limits, brakes and drives it.
#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"
#include "urdf/element_reader.hpp"
#include "urdf/rotations.hpp"

namespace elgen::urdf {

namespace {

struct TypeRow {
  JointType type;
  std::string_view word;
};

constexpr std::array types{
    TypeRow{JointType::revolute, "revolute"},   TypeRow{JointType::continuous, "continuous"},
    TypeRow{JointType::prismatic, "prismatic"}, TypeRow{JointType::fixed, "fixed"},
    TypeRow{JointType::floating, "floating"},   TypeRow{JointType::planar, "planar"},
};

/// Joints of Bullet and Drake that turn in all directions.
constexpr std::array<std::string_view, 2> balls{"spherical", "ball"};

std::string type_hint(const std::string& type) {
  std::vector<std::string> words;
  for (const TypeRow& row : types) words.emplace_back(row.word);
  const std::string near = suggestion(type, words);
  if (!near.empty()) return near;
  const std::string known = fmt::format("there are {}", fmt::join(words, ", "));
  if (std::ranges::find(balls, type) == balls.end()) return known;
  return known + "; a `floating` one, imported, has a rotation: leave out its three lengths";
}

JointType read_type(ElementReader& joint, RobotReading& reading) {
  const Text text = joint.required_text("type");
  const auto row = std::ranges::find(types, text.text, &TypeRow::word);
  if (row != types.end()) return row->type;
  if (text.text.empty()) return JointType::fixed;  // E803 was said
  reading.found.push_back({Code::E806, text.span,
                           fmt::format("{} is no type of joint", in_backticks(text.text)),
                           type_hint(text.text)});
  return JointType::fixed;
}

Text read_link_name(ElementReader& joint, std::string_view role) {
  Text name;
  joint.required_child(role, [&](ElementReader& link) { name = link.required_text("link"); });
  return name;
}

void read_axis(ElementReader& reader, Joint& joint, RobotReading& reading) {
  if (joint.type == JointType::fixed || joint.type == JointType::floating) return;
  bool is_read = false;
  reader.child("axis", [&](ElementReader& axis) {
    joint.axis_span = axis.required_text("xyz").span;
    is_read = axis.vector("xyz", joint.axis);
  });
  if (!is_read) return;
  const bool is_zero = std::ranges::all_of(joint.axis, &FileNumber::is_zero);
  if (is_zero) reading.found.push_back({Code::E813, joint.axis_span, "the axis has no direction"});
  if (joint.type == JointType::planar && !is_zero &&
      !axis_of(joint.axis, AngleDigits::rounded).along) {
    reading.found.push_back({Code::E108, joint.axis_span,
                             "a planar joint is imported only with an axis along x, y or z"});
  }
}

constexpr const char* no_limit = "the model has no such limit";

/// Limits are no part of the equations: one that cannot be means that there is none.
std::optional<FileNumber> read_bound(ElementReader& limit, std::string_view name, bool is_signed,
                                     Diagnostics& found) {
  const Text text = limit.text(name);
  const bool is_finite = !is_not_finite(text.text);
  const std::optional<FileNumber> number = is_finite ? limit.number(name) : std::nullopt;
  if (is_finite && (is_signed || !number || !cln::minusp(number->value))) return number;
  found.push_back({Code::E814, text.span,
                   fmt::format("{} {} is {}", name, in_backticks(text.text),
                               is_finite ? "negative" : "not finite"),
                   no_limit});
  return std::nullopt;
}

void read_limit(ElementReader& reader, JointLimit& limit, Diagnostics& found) {
  reader.child("limit", [&](ElementReader& numbers) {
    const std::size_t known = found.size();
    limit.lower = read_bound(numbers, "lower", true, found);
    limit.upper = read_bound(numbers, "upper", true, found);
    if (limit.lower && limit.upper && limit.lower->value > limit.upper->value) {
      found.push_back(
          {Code::E814, limit.lower->span,
           fmt::format("lower `{}` is above upper `{}`", limit.lower->text, limit.upper->text),
           no_limit});
    }
    if (found.size() > known) limit = {};
    limit.velocity = read_bound(numbers, "velocity", false, found);
    limit.effort = read_bound(numbers, "effort", false, found);
  });
}

void read_dynamics(ElementReader& reader, Joint& joint) {
  reader.child("dynamics", [&](ElementReader& dynamics) {
    joint.damping = dynamics.number("damping").value_or(FileNumber{});
    joint.friction = dynamics.number("friction").value_or(FileNumber{});
  });
}

/// Robots whose grippers were made fixed keep the element.
void note_mimic_of_fixed(ElementReader& reader, RobotReading& reading) {
  for (const Element* mimic : reader.children("mimic")) {
    reading.found.push_back({Code::E815, mimic->span,
                             "`<mimic>` in a fixed `<joint>` is not imported",
                             "the joint has no coordinate"});
  }
}

void read_mimic(ElementReader& reader, Joint& joint) {
  reader.child("mimic", [&](ElementReader& mimic) {
    joint.mimic =
        Mimic{mimic.required_text("joint"), mimic.number("multiplier").value_or(decimal_of(1)),
              mimic.number("offset").value_or(FileNumber{})};
  });
}

}  // namespace

std::string_view word(JointType type) {
  return std::ranges::find(types, type, &TypeRow::type)->word;
}

bool has_one_coordinate(JointType type) {
  return type == JointType::revolute || type == JointType::continuous ||
         type == JointType::prismatic;
}

Joint read_joint(const Element& element, RobotReading& reading) {
  ElementReader reader(element, reading);
  Joint joint;
  joint.name = reader.required_text("name");
  joint.type = read_type(reader, reading);
  joint.parent = read_link_name(reader, "parent");
  joint.child = read_link_name(reader, "child");
  joint.origin = read_origin(reader);
  if (has_one_coordinate(joint.type)) {
    read_limit(reader, joint.limit, reading.found);
    read_dynamics(reader, joint);
  }
  if (joint.type == JointType::fixed) reader.ignore({"axis", "limit", "dynamics"});
  if (joint.type == JointType::floating) reader.ignore({"axis"});
  read_axis(reader, joint, reading);
  if (joint.type == JointType::fixed) {
    note_mimic_of_fixed(reader, reading);
  } else {
    read_mimic(reader, joint);
  }
  reader.ignore({"calibration", "safety_controller"});
  reader.note_the_rest();
  return joint;
}

}  // namespace elgen::urdf
