// Points and bodies: masses, positions, spins and inertias.
#include <algorithm>

#include "base/reason.hpp"
#include "check/entries/entries.hpp"
#include "check/entries/in_frame.hpp"
#include "check/expressions/places.hpp"
#include "check/expressions/values.hpp"

namespace elgen {
namespace {

const RootRequest mass_request{{"a mass", place::parameters_only, Code::E506}, find_unit("kg")};

class BodyReader {
 public:
  BodyReader(ValueReader& values, const EntrySyntax& entry, Body& body)
      : values_(values), entry_(entry), body_(body), report_(values.context().report) {}

  void read() {
    read_com();
    body_.mass = values_.root(entry_, "mass", mass_request);
    const KeySyntax* frame = entry_.find("frame");
    if (frame == nullptr) {
      read_spin();
    } else {
      read_frame(frame->value);
    }
    read_inertia();
    const bool about_origin = text_value(entry_, "inertia_about") == "origin";
    if (about_origin && frame == nullptr) report_missing_origin();
    check_completeness();
    if (frame_) {
      set_world_pose(values_.context(), {{*frame_, body_.com}, body_.inertia, about_origin}, body_);
    }
  }

 private:
  void read_frame(const ValueSyntax& frame) {
    if (const KeySyntax* spin = entry_.find("spin")) {
      report_.add(Reason::frame_and_spin, spin->key_span, "a body has `frame` or `spin`, not both");
    }
    frame_ = values_.resolve_frame_or_world(frame);
    // If no vector has set the dimension yet, a single moment of inertia means a planar body.
    const KeySyntax* inertia = entry_.find("inertia");
    const std::uint32_t known = values_.context().dimension;
    const bool has_one_moment = inertia != nullptr && (inertia->value.kind != ValueKind::list ||
                                                       inertia->value.items.size() == 1);
    const bool is_planar = known == 2 || (known == 0 && has_one_moment);
    body_.dimension = is_planar ? 2 : 3;
    body_.spin.assign(is_planar ? 1 : 3, no_expression);
  }

  void read_com() {
    const KeySyntax* com = entry_.find("com");
    if (com == nullptr || !values_.check_vector(com->value)) return;
    const bool in_frame = entry_.find("frame") != nullptr;
    const ExpressionRole place =
        in_frame ? ExpressionRole{"a centre of mass", place::parameters_only, Code::E506}
                 : ExpressionRole{place::position, place::configuration_terms};
    body_.com = pad_to_three(values_.read_roots(com->value, {place, find_unit("m")}));
    body_.dimension = static_cast<std::uint32_t>(com->value.items.size());
  }

  void read_spin() {
    const KeySyntax* spin = entry_.find("spin");
    if (spin == nullptr) return;
    const ExpressionRole place{"a spin", place::state_terms};
    body_.spin = values_.read_roots(spin->value, {place, find_unit("Hz")});
    const std::size_t count = body_.spin.size();
    const bool has_com = entry_.find("com") != nullptr;
    if (count != 1 && count != 3) {
      report_.add(Reason::wrong_component_count, spin->value.span,
                  count_text(count, "component") + ", but a spin has 1 or 3");
    } else if (has_com && (count == 1) != (body_.dimension == 2)) {
      report_.add(Code::E516, spin->value.span,
                  std::string(count == 1 ? "a planar" : "a spatial") +
                      " spin, but the centre of mass has " +
                      count_text(body_.dimension, "component"));
    }
    body_.dimension = count == 1 ? 2 : 3;
  }

  void read_inertia() {
    const KeySyntax* inertia = entry_.find("inertia");
    if (inertia == nullptr) return;
    const ExpressionRole place{"an inertia", place::parameters_only, Code::E506};
    const Unit unit = *find_unit("kg") * power(*find_unit("m"), {2, 1});
    body_.inertia = values_.read_roots(inertia->value, {place, unit});
    const std::size_t count = body_.inertia.size();
    const bool fits = body_.spin.size() == 1 ? count == 1 : count == 3 || count == 6;
    if (!body_.spin.empty() && !fits) {
      report_.add(Code::E516, inertia->value.span,
                  count_text(count, "moment") + " of inertia for a " +
                      (body_.spin.size() == 1 ? "planar" : "spatial") + " body",
                  "a planar body has 1, a spatial body 3 or 6: xx yy zz xy xz yz");
    }
    if (count == 3) body_.inertia.resize(6, no_expression);
  }

  /// Reports E112: `spin` gives a body an angular velocity, but only `frame` gives an origin.
  void report_missing_origin() {
    report_.add(Reason::inertia_without_origin, entry_.find("inertia_about")->key_span,
                "a body without `frame` has no origin, so its inertia cannot be about the origin",
                "give the inertia about the centre of mass, or give the body a frame; if the body "
                "turns about a fixed point, omit its mass and add its weight to `[energy] V`");
  }

  void check_completeness() {
    if (body_.mass && entry_.find("com") == nullptr && entry_.find("frame") == nullptr) {
      report_missing_key("com", "mass");
    }
    if (!body_.inertia.empty() && body_.spin.empty()) {
      report_missing_key("spin", "inertia", "give it a `frame`, or a `spin` such as `dot(theta)`");
    }
    if (entry_.find("spin") != nullptr && body_.inertia.empty())
      report_missing_key("inertia", "spin");
  }

  void report_missing_key(const std::string& key, const std::string& other,
                          const std::string& hint = {}) {
    report_.add(Code::E105, entry_.span,
                quote_text(body_.name) + " has `" + other + "` but no `" + key + "`", hint);
  }

  ValueReader& values_;
  const EntrySyntax& entry_;
  Body& body_;
  Report& report_;
  std::optional<std::uint32_t> frame_ = {};
};

/// Reads the lines that a page draws from a point to other places.
void read_joined_places(ValueReader& values, const EntrySyntax& entry, Point& point) {
  const KeySyntax* const joined_to = entry.find("joined_to");
  if (joined_to == nullptr) {
    if (const KeySyntax* const as = entry.find("as")) {
      values.context().report.add(Code::E105, as->key_span,
                                  quote_text(point.name) + " has `as` but no `joined_to`");
    }
    return;
  }
  const auto add = [&](const ValueSyntax& value) {
    if (const auto place = values.resolve_joined_place(value)) point.line_ends.push_back(*place);
  };
  if (joined_to->value.kind == ValueKind::list) {
    std::ranges::for_each(joined_to->value.items, add);
  } else {
    add(joined_to->value);
  }
  point.has_springs = text_value(entry, "as") == "spring";
}

}  // namespace

void read_point(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  Context& context = values.context();
  Point& point = context.model.points[target];
  const KeySyntax* at = entry.find("at");
  if (at != nullptr && values.check_vector(at->value)) {
    const ExpressionRole place{place::position, place::configuration_terms};
    point.position = pad_to_three(values.read_roots(at->value, {place, find_unit("m")}));
    if (const KeySyntax* frame = entry.find("frame")) {
      if (const auto index = values.resolve_frame_or_world(frame->value)) {
        point.local = PointInFrame{*index, point.position};
        NodeBuilder nodes(context, point.span);
        point.position = world_position(nodes, *point.local);
      }
    }
  }
  point.mass = values.root(entry, "mass", mass_request);
  read_joined_places(values, entry, point);
}

void read_body(ValueReader& values, const EntrySyntax& entry, std::uint32_t target) {
  BodyReader(values, entry, values.context().model.bodies[target]).read();
}

}  // namespace elgen
