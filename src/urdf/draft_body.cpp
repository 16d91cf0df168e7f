// An <inertial> as a body of the model.
#include <fmt/format.h>

#include <algorithm>

#include "base/toml_text.hpp"
#include "urdf/draft.hpp"

namespace elgen::urdf {

namespace {

constexpr std::array<std::string_view, 6> inertia_names{"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};

std::vector<std::string> inertia_of(Glossary& glossary, const std::string& link,
                                    const std::array<FileNumber, 6>& numbers) {
  const auto is_zero = [](const FileNumber& number) { return number.is_zero(); };
  if (std::all_of(numbers.begin(), numbers.end(), is_zero)) return {};
  const std::size_t count = std::all_of(numbers.begin() + 3, numbers.end(), is_zero) ? 3 : 6;
  std::vector<std::string> inertia;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string sign = i < 3 ? "assume = \"positive\"" : "";
    inertia.push_back(glossary.parameter(fmt::format("{}_{}", inertia_names[i], link), numbers[i],
                                         "kg*m^2", sign));
  }
  return inertia;
}

/// Six inertias on two lines: first the diagonal.
std::string inertia_text(const std::vector<std::string>& inertia) {
  std::string text;
  for (std::size_t i = 0; i < inertia.size(); ++i) {
    text += (i == 0 ? "" : i == 3 ? ",\n           " : ", ") + toml_string(inertia[i]);
  }
  return "[" + text + "]";
}

/// Adds a frame in the axes of the inertia; its name.
std::string add_axes(Draft& draft, const std::string& link, const Inertial& inertial,
                     const Components& com) {
  const RollPitchYaw rotation = rotation_of(inertial.origin.rpy, draft.robot.digits);
  FrameDraft axes;
  axes.comments = frame_comments("axes of the inertia of " + link, rotation, inertial.origin.rpy);
  axes.name = draft.glossary.claim(link + "_inertial", "frame");
  axes.parent = link;
  axes.translate = com;
  axes.rotate = steps_of(rotation);
  draft.links.push_back(frame_table(axes));
  return axes.name;
}

}  // namespace

void draft_body(Draft& draft, std::size_t link) {
  const auto& inertial = draft.robot.links[link].inertial;
  if (!inertial) return;
  Glossary& glossary = draft.glossary;
  const std::string& name = glossary.frame(link);
  const auto& [xyz, rpy] = inertial->origin;
  const std::string mass =
      glossary.parameter("m_" + name, inertial->mass, "kg", "assume = \"positive\"");
  Components com = place_of(glossary, "c{}_" + name, xyz);
  const RollPitchYaw rotation = rotation_of(rpy, draft.robot.digits);
  const auto turned = rotated(rotation, inertial->inertia);
  const auto inertia = inertia_of(glossary, name, turned.value_or(inertial->inertia));
  if (mass == "0" && inertia.empty()) return;
  const bool has_axes = !turned && !inertia.empty();
  TomlTable body("[[body]]");
  body.add("name", toml_string(name));
  body.add("frame", toml_string(has_axes ? add_axes(draft, name, *inertial, com) : name));
  if (has_axes) com = {"0", "0", "0"};
  if (mass != "0") {
    body.add("mass", toml_string(mass));
    body.add("com", vector_text(com));
  }
  if (!inertia.empty()) body.add("inertia", inertia_text(inertia));
  const bool is_turned = turned && !rotation.is_zero() && !inertia.empty();
  draft.links.push_back(
      (is_turned ? toml_comment("inertia turned from axes of rpy " + listed(rpy)) : "") +
      body.text());
}

}  // namespace elgen::urdf
