// An <inertial> as a body of the model.
#include <fmt/format.h>

#include <algorithm>

#include "urdf/drafting.hpp"

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

}  // namespace

void draft_body(Drafting& drafting, std::size_t link, LinkDraft& to) {
  const auto& inertial = drafting.robot.links[link].inertial;
  if (!inertial) return;
  Glossary& glossary = drafting.glossary;
  BodyDraft body;
  body.name = glossary.frame(link);
  body.frame = body.name;
  body.mass = glossary.parameter("m_" + body.name, inertial->mass, "kg", "assume = \"positive\"");
  for (std::size_t i = 0; i < 3; ++i) {
    body.com[i] = glossary.parameter(fmt::format("c{}_{}", axis_letter(i), body.name),
                                     inertial->origin.xyz[i], "m");
  }
  const RollPitchYaw rotation = rotation_of(inertial->origin.rpy);
  const auto turned = rotated(rotation, inertial->inertia);
  body.inertia = inertia_of(glossary, body.name, turned.value_or(inertial->inertia));
  if (body.mass == "0" && body.inertia.empty()) return;
  if (!turned && !body.inertia.empty()) {
    FrameDraft axes;
    axes.comments = {fmt::format("axes of the inertia of {}", body.name)};
    for (std::string& comment : rounding_comment(rotation, inertial->origin.rpy)) {
      axes.comments.push_back(std::move(comment));
    }
    axes.name = glossary.claim(body.name + "_inertial", "frame");
    axes.parent = body.name;
    axes.translate = body.com;
    axes.rotate = steps_of(rotation);
    body.frame = axes.name;
    body.com = {"0", "0", "0"};
    to.frames.push_back(std::move(axes));
  } else if (!rotation.is_zero() && !body.inertia.empty()) {
    body.comments = {fmt::format("inertia turned from axes of rpy {} {} {}",
                                 inertial->origin.rpy[0].text, inertial->origin.rpy[1].text,
                                 inertial->origin.rpy[2].text)};
  }
  to.bodies.push_back(std::move(body));
}

}  // namespace elgen::urdf
