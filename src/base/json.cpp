// json: copies the tree into a tree of nlohmann/json, which prints it.
#include "base/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace elgen {

struct Json::NlohmannConverter {
  using Tree = nlohmann::ordered_json;

  Tree operator()(const Array& elements) const {
    Tree tree = Tree::array();
    for (const Json& element : elements) tree.push_back(convert(element));
    return tree;
  }
  Tree operator()(const Object& members) const {
    Tree tree = Tree::object();
    for (const auto& [key, member] : members) tree[key] = convert(member);
    return tree;
  }
  Tree operator()(const auto& value) const { return value; }

  static Tree convert(const Json& json) { return std::visit(NlohmannConverter(), json.value_); }
};

Json::Json(std::initializer_list<Json> elements) {
  const bool is_object = std::ranges::all_of(elements, [](const Json& element) {
    const Array* const pair = std::get_if<Array>(&element.value_);
    return pair != nullptr && pair->size() == 2 &&
           std::holds_alternative<std::string>(pair->front().value_);
  });
  if (!is_object) {
    value_ = Array(elements);
    return;
  }
  Object& members = value_.emplace<Object>();
  for (const Json& element : elements) {
    const Array& pair = std::get<Array>(element.value_);
    members.emplace_back(std::get<std::string>(pair.front().value_), pair.back());
  }
}

Json Json::array(Array elements) {
  Json json;
  json.value_ = std::move(elements);
  return json;
}

Json Json::object() {
  Json json;
  json.value_ = Object();
  return json;
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) value_ = Object();
  Object& members = std::get<Object>(value_);
  const auto known = std::ranges::find(members, key, &Object::value_type::first);
  if (known != members.end()) return known->second;
  return members.emplace_back(key, nullptr).second;
}

Json& Json::push_back(Json element) {
  if (is_null()) value_ = Array();
  return std::get<Array>(value_).emplace_back(std::move(element));
}

void Json::update(const Json& object) {
  for (const auto& [key, member] : std::get<Object>(object.value_)) (*this)[key] = member;
}

std::vector<std::pair<std::string_view, const Json*>> Json::items() const {
  std::vector<std::pair<std::string_view, const Json*>> all;
  if (const Object* const members = std::get_if<Object>(&value_)) {
    for (const auto& [key, member] : *members) all.emplace_back(key, &member);
  } else {
    for (const Json& element : std::get<Array>(value_)) all.emplace_back("", &element);
  }
  return all;
}

std::string Json::dump(int indent, bool is_ascii) const {
  return NlohmannConverter::convert(*this).dump(indent, ' ', is_ascii,
                                                NlohmannConverter::Tree::error_handler_t::replace);
}

}  // namespace elgen
