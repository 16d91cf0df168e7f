// <link>: its mass and inertia; shapes are no mechanics.
#include <fmt/format.h>

#include "urdf/element_reader.hpp"

namespace elgen::urdf {

namespace {

constexpr std::array<std::string_view, 6> inertia_attributes{"ixx", "iyy", "izz",
                                                             "ixy", "ixz", "iyz"};

void read_mass(ElementReader& inertial, Inertial& to, RobotReading& reading) {
  inertial.required_child("mass", [&](ElementReader& mass) {
    to.mass = mass.required_number("value").value_or(FileNumber{});
  });
  if (cln::minusp(to.mass.value)) {
    reading.found.push_back(
        {Code::E811, to.mass.span, fmt::format("the mass `{}` is negative", to.mass.text)});
  }
}

void read_inertia(ElementReader& inertial, Inertial& to) {
  inertial.required_child("inertia", [&](ElementReader& inertia) {
    to.span = inertia.span();
    for (std::size_t i = 0; i < inertia_attributes.size(); ++i) {
      to.inertia[i] = inertia.required_number(inertia_attributes[i]).value_or(FileNumber{});
    }
  });
}

}  // namespace

Link read_link(const Element& element, RobotReading& reading) {
  ElementReader reader(element, reading);
  Link link{reader.required_text("name"), {}};
  reader.child("inertial", [&](ElementReader& parts) {
    Inertial& inertial = link.inertial.emplace();
    inertial.origin = read_origin(parts);
    read_mass(parts, inertial, reading);
    read_inertia(parts, inertial);
  });
  reader.ignore({"visual", "collision", "type"});
  reader.note_the_rest();
  return link;
}

}  // namespace elgen::urdf
