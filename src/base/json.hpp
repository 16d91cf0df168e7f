// json: values for other programs, printed by nlohmann/json. Only json.cpp includes that library,
// because it adds two to four seconds to the compilation of each source.
//
//     Json{{"name", "theta"}, {"range", {0, 1.5}}}.dump()      {"name":"theta","range":[0,1.5]}
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace elgen {

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;  ///< in the order of insertion

  Json(std::nullptr_t = nullptr) {}
  /// An integer or a boolean.
  template <std::integral Number>
  Json(Number number) : value_(StoredNumber<Number>{number}) {}
  /// A number that is not finite is printed as null.
  Json(double number) : value_(number) {}
  Json(std::string text) : value_(std::move(text)) {}
  Json(std::string_view text) : value_(std::string(text)) {}
  Json(const char* text) : value_(std::string(text)) {}
  /// An array of the elements.
  template <std::ranges::input_range Range>
  requires(!std::convertible_to<const Range&, std::string_view>) Json(const Range& elements)
      : value_(Array(elements.begin(), elements.end())) {}
  /// An object if all elements are pairs whose first element is a text, else an array.
  Json(std::initializer_list<Json> elements);

  [[nodiscard]] static Json array(Array elements = {});
  [[nodiscard]] static Json object();

  /// The member `key` of an object. A missing member is added; null becomes an object.
  Json& operator[](std::string_view key);
  /// Adds an element to an array; null becomes an array.
  Json& push_back(Json element);
  /// Copies the members of another object into this object.
  void update(const Json& object);

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
  [[nodiscard]] bool is_object() const { return std::holds_alternative<Object>(value_); }
  /// True for an object or an array.
  [[nodiscard]] bool is_structured() const {
    return is_object() || std::holds_alternative<Array>(value_);
  }
  /// True if the array has no elements. The value must be an array.
  [[nodiscard]] bool empty() const { return std::get<Array>(value_).empty(); }
  [[nodiscard]] Json& back() { return std::get<Array>(value_).back(); }

  /// The members of an object; for an array, its elements, each with an empty key.
  [[nodiscard]] std::vector<std::pair<std::string_view, const Json*>> items() const;

  /// The value as JSON text, on one line if `indent` is -1, else with `indent` blanks per level.
  /// Bytes that are not UTF-8 are replaced; `is_ascii`: characters beyond ASCII are escaped.
  [[nodiscard]] std::string dump(int indent = -1, bool is_ascii = false) const;

 private:
  struct NlohmannConverter;

  template <class Number>
  using StoredNumber = std::conditional_t<
      std::same_as<Number, bool>, bool,
      std::conditional_t<std::signed_integral<Number>, std::int64_t, std::uint64_t>>;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array,
               Object>
      value_ = nullptr;
};

}  // namespace elgen
