// ElementReader: takes attributes and children from one element; what nobody took becomes a note.
#pragma once

#include <initializer_list>
#include <set>
#include <string_view>
#include <vector>

#include "urdf/robot.hpp"

namespace elgen::urdf {

class ElementReader {
 public:
  ElementReader(const Element& element, RobotReading& reading)
      : element_(element), reading_(reading) {}

  /// The attribute's text, empty where it is absent.
  Text text(std::string_view name);
  /// The same; E803 where it is absent.
  Text required_text(std::string_view name);

  /// E804 where it is no number.
  std::optional<FileNumber> number(std::string_view name);
  std::optional<FileNumber> required_number(std::string_view name);

  /// Three numbers: E805 where there are not three. False, and unchanged, where they are not there.
  bool vector(std::string_view name, Vector& vector);

  /// Reads the first child of this name, where there is one, and notes what `read` left of it.
  template <class Read>
  void child(std::string_view name, const Read& read) {
    if (const Element* found = first_child(name)) {
      ElementReader reader(*found, reading_);
      read(reader);
      reader.note_the_rest();
    }
  }
  /// The same; E803 where there is none.
  template <class Read>
  void required_child(std::string_view name, const Read& read) {
    if (first_child(name) == nullptr) report_missing("element", name);
    child(name, read);
  }
  [[nodiscard]] const Span& span() const { return element_.span; }
  std::vector<const Element*> children(std::string_view name);

  /// Takes what has no part in the motion, silently.
  void ignore(std::initializer_list<std::string_view> names);

  /// E815 for every attribute and child that was not taken, or E822 if it, or an element inside it,
  /// changes the mechanics.
  void note_the_rest() const;

 private:
  const Attribute* attribute(std::string_view name);
  std::optional<FileNumber> decimal(const Span& word);
  const Element* first_child(std::string_view name);
  void report_missing(std::string_view kind, std::string_view name);

  const Element& element_;
  RobotReading& reading_;
  std::set<const void*> taken_ = {};
};

/// An `<origin>` among the children, or none.
[[nodiscard]] Pose read_origin(ElementReader& parent);

}  // namespace elgen::urdf
