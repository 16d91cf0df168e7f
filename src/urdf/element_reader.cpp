// Reads attributes and children of an element, and notes the unread content.
#include "urdf/element_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "elgen/wording.hpp"

namespace elgen::urdf {

namespace {

/// True for attributes of XML itself, which do not describe the robot.
bool belongs_to_xml(std::string_view name) {
  return name.starts_with("xmlns") || name.starts_with("xml:");
}

/// An element of another format, or of a simulator, that changes how the robot moves.
struct Extension {
  std::string_view name;  ///< without the prefix of its namespace
  std::string_view remedy;
};
constexpr std::string_view loop_remedy = "a `[[constraint]]` whose points `coincide` closes a loop";
constexpr std::string_view force_remedy = "add it to `[energy] V` or `D`, or as a `[[force]]`";
constexpr auto extensions = std::to_array<Extension>({
    {"constraint", loop_remedy},
    {"loop", loop_remedy},
    {"loop_joint", loop_remedy},
    {"ball_constraint", loop_remedy},
    {"equality", loop_remedy},
    {"joint", loop_remedy},
    {"mimic", "add a `[[constraint]]`"},
    {"inertial", "add a `[[body]]`"},
    {"spring", force_remedy},
    {"damper", force_remedy},
    {"linear_spring_damper", force_remedy},
    {"linear_bushing_rpy", force_remedy},
    {"spring_stiffness", force_remedy},
    {"springStiffness", force_remedy},
    {"dampingFactor", force_remedy},
    {"thruster", force_remedy},
});

const Extension* extension_of(const Element& element) {
  const std::string_view name(element.name);
  const auto row =
      std::ranges::find(extensions, name.substr(name.rfind(':') + 1), &Extension::name);
  // A `<joint>` without `type`, as in `<ros2_control>`, refers to a joint of the robot.
  const bool names_other =
      name == "joint" &&
      std::ranges::find(element.attributes, "type", &Attribute::name) == element.attributes.end();
  return row == extensions.end() || names_other ? nullptr : &*row;
}

Diagnostic loss_warning(const Span& span, const std::string& what, std::string_view remedy) {
  return {Code::E822, span, what + " is not imported",
          fmt::format("the model ignores it: {}", remedy)};
}

std::string child_text(const Element& parent, const Element& child) {
  return fmt::format("{} in `<{}>`", quote_text("<" + child.name + ">"), parent.name);
}

/// Reports E822 if the child or an element inside it affects the motion; false if neither does.
bool warn_of_mechanical_effect(const Element& parent, const Element& child, Diagnostics& found) {
  if (const Extension* extension = extension_of(child)) {
    found.push_back(loss_warning(child.span, child_text(parent, child), extension->remedy));
    return true;
  }
  bool warned = false;
  for (const Element& inner : child.children) {
    warned = warn_of_mechanical_effect(child, inner, found) || warned;
  }
  return warned;
}

/// True if an attribute that URDF does not define declares a spring or a rotor: `stiffness="3"`.
bool changes_mechanics(const Attribute& attribute, const Limits& limits) {
  if (!attribute.name.ends_with("stiffness") && attribute.name != "armature") return false;
  const Result<FileNumber> number = read_decimal(attribute.span, limits);
  return !number || !number->is_zero();
}

}  // namespace

const Attribute* ElementReader::take_attribute(std::string_view name) {
  const auto& all = element_.attributes;
  const auto found = std::ranges::find(all, name, &Attribute::name);
  if (found == all.end()) return nullptr;
  read_items_.insert(&*found);
  return &*found;
}

void ElementReader::report_missing(std::string_view kind, std::string_view name) {
  reading_.diagnostics.push_back(
      {Code::E803, element_.span, fmt::format("`<{}>` has no {} `{}`", element_.name, kind, name)});
}

SpannedText ElementReader::read_text(std::string_view name) {
  const Attribute* found = take_attribute(name);
  return found == nullptr ? SpannedText{} : SpannedText{found->value, found->span};
}

SpannedText ElementReader::require_text(std::string_view name) {
  const Attribute* found = take_attribute(name);
  if (found != nullptr && !found->value.empty()) return {found->value, found->span};
  report_missing("attribute", name);
  return {};
}

std::optional<FileNumber> ElementReader::parse_decimal(const Span& word) {
  Result<FileNumber> number = read_decimal(word, reading_.limits);
  auto& all = reading_.diagnostics;
  all.insert(all.end(), number.diagnostics.begin(), number.diagnostics.end());
  return std::move(number.value);
}

std::optional<FileNumber> ElementReader::read_number(std::string_view name) {
  const Attribute* found = take_attribute(name);
  if (found == nullptr) return std::nullopt;
  const std::vector<Span> words = word_spans(found->span);
  if (words.size() != 1) {
    reading_.diagnostics.push_back(
        {Code::E805, found->span,
         fmt::format("{} numbers, but `{}` is one number", words.size(), name),
         xacro_hint(found->span)});
    return std::nullopt;
  }
  return parse_decimal(words.front());
}

std::optional<FileNumber> ElementReader::require_number(std::string_view name) {
  if (take_attribute(name) != nullptr) return read_number(name);
  report_missing("attribute", name);
  return std::nullopt;
}

bool ElementReader::read_vector(std::string_view name, Vector& vector) {
  const Attribute* found = take_attribute(name);
  if (found == nullptr) return false;
  const std::vector<Span> words = word_spans(found->span);
  if (words.size() != vector.size()) {
    reading_.diagnostics.push_back(
        {Code::E805, found->span,
         fmt::format("{}, but `{}` has 3", count_text(words.size(), "number"), name),
         xacro_hint(found->span)});
    return false;
  }
  Vector read;
  bool is_complete = true;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::optional<FileNumber> number = parse_decimal(words[i]);
    is_complete = is_complete && number;
    read[i] = number.value_or(FileNumber{});
  }
  if (is_complete) vector = read;
  return is_complete;
}

const Element* ElementReader::take_first_child(std::string_view name) {
  const auto& all = element_.children;
  const auto found = std::ranges::find(all, name, &Element::name);
  if (found == all.end()) return nullptr;
  read_items_.insert(&*found);
  return &*found;
}

std::vector<const Element*> ElementReader::take_children(std::string_view name) {
  std::vector<const Element*> found;
  for (const Element& element : element_.children) {
    if (element.name != name) continue;
    read_items_.insert(&element);
    found.push_back(&element);
  }
  return found;
}

void ElementReader::ignore(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    (void)take_attribute(name);
    (void)take_children(name);
  }
}

void ElementReader::report_unread() const {
  for (const Attribute& attribute : element_.attributes) {
    if (read_items_.count(&attribute) > 0 || belongs_to_xml(attribute.name)) continue;
    const std::string what =
        fmt::format("attribute {} of `<{}>`", quote_text(attribute.name), element_.name);
    if (changes_mechanics(attribute, reading_.limits)) {
      reading_.diagnostics.push_back(loss_warning(attribute.name_span, what, force_remedy));
    } else {
      reading_.diagnostics.push_back({Code::E815, attribute.name_span, what + " is not imported"});
    }
  }
  for (const Element& child : element_.children) {
    if (read_items_.count(&child) > 0 ||
        warn_of_mechanical_effect(element_, child, reading_.diagnostics))
      continue;
    reading_.diagnostics.push_back(
        {Code::E815, child.span, child_text(element_, child) + " is not imported"});
  }
}

Pose read_origin(ElementReader& parent) {
  Pose pose;
  parent.read_child("origin", [&](ElementReader& origin) {
    (void)origin.read_vector("xyz", pose.xyz);
    (void)origin.read_vector("rpy", pose.rpy);
  });
  return pose;
}

}  // namespace elgen::urdf
