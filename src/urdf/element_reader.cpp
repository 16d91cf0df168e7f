// Takes an element apart, and remembers what was taken.
#include "urdf/element_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "elgen/wording.hpp"

namespace elgen::urdf {

namespace {

/// Spellings of XML itself, which say nothing about a robot.
bool belongs_to_xml(std::string_view name) {
  return name.starts_with("xmlns") || name.starts_with("xml:");
}

}  // namespace

const Attribute* ElementReader::attribute(std::string_view name) {
  const auto& all = element_.attributes;
  const auto found = std::ranges::find(all, name, &Attribute::name);
  if (found == all.end()) return nullptr;
  taken_.insert(&*found);
  return &*found;
}

void ElementReader::report_missing(std::string_view kind, std::string_view name) {
  reading_.found.push_back(
      {Code::E803, element_.span, fmt::format("`<{}>` has no {} `{}`", element_.name, kind, name)});
}

Text ElementReader::text(std::string_view name) {
  const Attribute* found = attribute(name);
  return found == nullptr ? Text{} : Text{found->value, found->span};
}

Text ElementReader::required_text(std::string_view name) {
  const Attribute* found = attribute(name);
  if (found != nullptr && !found->value.empty()) return {found->value, found->span};
  report_missing("attribute", name);
  return {};
}

std::optional<FileNumber> ElementReader::decimal(const Span& word) {
  Result<FileNumber> number = read_decimal(word, reading_.limits);
  auto& all = reading_.found;
  all.insert(all.end(), number.diagnostics.begin(), number.diagnostics.end());
  return std::move(number.value);
}

std::optional<FileNumber> ElementReader::number(std::string_view name) {
  const Attribute* found = attribute(name);
  if (found == nullptr) return std::nullopt;
  const std::vector<Span> words = words_of(found->span);
  if (words.size() != 1) {
    reading_.found.push_back({Code::E805, found->span,
                              fmt::format("{} numbers, but `{}` is one number", words.size(), name),
                              remedy_of(found->span)});
    return std::nullopt;
  }
  return decimal(words.front());
}

std::optional<FileNumber> ElementReader::required_number(std::string_view name) {
  if (attribute(name) != nullptr) return number(name);
  report_missing("attribute", name);
  return std::nullopt;
}

bool ElementReader::vector(std::string_view name, Vector& vector) {
  const Attribute* found = attribute(name);
  if (found == nullptr) return false;
  const std::vector<Span> words = words_of(found->span);
  if (words.size() != vector.size()) {
    reading_.found.push_back(
        {Code::E805, found->span,
         fmt::format("{}, but `{}` has 3", counted(words.size(), "number"), name),
         remedy_of(found->span)});
    return false;
  }
  Vector read;
  bool is_complete = true;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::optional<FileNumber> number = decimal(words[i]);
    is_complete = is_complete && number;
    read[i] = number.value_or(FileNumber{});
  }
  if (is_complete) vector = read;
  return is_complete;
}

const Element* ElementReader::first_child(std::string_view name) {
  const auto& all = element_.children;
  const auto found = std::ranges::find(all, name, &Element::name);
  if (found == all.end()) return nullptr;
  taken_.insert(&*found);
  return &*found;
}

std::vector<const Element*> ElementReader::children(std::string_view name) {
  std::vector<const Element*> found;
  for (const Element& element : element_.children) {
    if (element.name != name) continue;
    taken_.insert(&element);
    found.push_back(&element);
  }
  return found;
}

void ElementReader::ignore(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    (void)attribute(name);
    (void)children(name);
  }
}

void ElementReader::note_the_rest() const {
  for (const Attribute& attribute : element_.attributes) {
    if (taken_.count(&attribute) > 0 || belongs_to_xml(attribute.name)) continue;
    reading_.found.push_back({Code::E815, attribute.name_span,
                              fmt::format("attribute {} of `<{}>` is not imported",
                                          in_backticks(attribute.name), element_.name)});
  }
  for (const Element& child : element_.children) {
    if (taken_.count(&child) > 0) continue;
    reading_.found.push_back({Code::E815, child.span,
                              fmt::format("{} in `<{}>` is not imported",
                                          in_backticks("<" + child.name + ">"), element_.name)});
  }
}

Pose read_origin(ElementReader& parent) {
  Pose pose;
  parent.child("origin", [&](ElementReader& origin) {
    (void)origin.vector("xyz", pose.xyz);
    (void)origin.vector("rpy", pose.rpy);
  });
  return pose;
}

}  // namespace elgen::urdf
