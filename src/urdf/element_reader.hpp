// ElementReader: reads attributes and children of one element; all unread content becomes a note.
#pragma once

#include <initializer_list>
#include <set>
#include <string_view>
#include <vector>

#include "urdf/robot.hpp"

namespace elgen::urdf {

class ElementReader {
 public:
  ElementReader(const Element& element, RobotReadState& reading)
      : element_(element), reading_(reading) {}

  /// The text of an attribute; empty if it is absent.
  SpannedText read_text(std::string_view name);
  /// The text of an attribute; E803 if it is absent or empty.
  SpannedText require_text(std::string_view name);

  /// The value of an attribute; none if it is absent, or after E804, E805, E903 or E904.
  std::optional<FileNumber> read_number(std::string_view name);
  std::optional<FileNumber> require_number(std::string_view name);

  /// Reads three numbers. E804: no number; E805: not three; E903, E904: limits. If the attribute is
  /// absent or wrong, returns false and keeps `vector` unchanged.
  bool read_vector(std::string_view name, Vector& vector);

  /// Calls `read` for the first child of this name, if any, then reports the content that `read`
  /// did not read.
  template <class Read>
  void read_child(std::string_view name, const Read& read) {
    if (const Element* found = take_first_child(name)) {
      ElementReader reader(*found, reading_);
      read(reader);
      reader.report_unread();
    }
  }
  /// Like read_child(); E803 if there is no such child.
  template <class Read>
  void require_child(std::string_view name, const Read& read) {
    if (take_first_child(name) == nullptr) report_missing("element", name);
    read_child(name, read);
  }
  [[nodiscard]] const Span& span() const { return element_.span; }
  std::vector<const Element*> take_children(std::string_view name);

  /// Marks attributes and children as read, because they do not affect the motion.
  void ignore(std::initializer_list<std::string_view> names);

  /// Reports every unread attribute and child: E822 if it (or an element inside it) affects the
  /// motion, else E815.
  void report_unread() const;

 private:
  const Attribute* take_attribute(std::string_view name);
  std::optional<FileNumber> parse_decimal(const Span& word);
  const Element* take_first_child(std::string_view name);
  void report_missing(std::string_view kind, std::string_view name);

  const Element& element_;
  RobotReadState& reading_;
  std::set<const void*> read_items_ = {};
};

/// The `<origin>` among the children; zeros if there is none.
[[nodiscard]] Pose read_origin(ElementReader& parent);

}  // namespace elgen::urdf
