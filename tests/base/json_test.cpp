// Json prints the same text as nlohmann/json for the same initialiser.
#include "base/json.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

using namespace elgen;

namespace {

using Library = nlohmann::ordered_json;

/// An example of all kinds of JSON values; `Value` is Json or Library.
template <class Value>
Value example() {
  const std::vector<std::vector<double>> rows{{1, -0.0}, {1e300, 1.0 / 3}};
  const std::string name = "theta";
  const std::string_view unit = "rad/\"s\"\n";
  Value json{{"name", name}, {"unit", unit}, {"pairs", {{"a", 1}, {"b", 2}}}, {"rows", rows}};
  json["words"] = {"one", "two"};
  json["range"] = {-1.5, 3};
  json["shape"]["rows"] = std::uint64_t{18446744073709551615U};
  json["shape"]["least"] = std::numeric_limits<std::int64_t>::min();
  json["list"].push_back({{"is_proved", true}});
  json["list"].push_back({1U, nullptr, false});
  json["list"].push_back(Value::array({json["range"]}));
  json["none"] = {Value::array(), Value::object(), std::numeric_limits<double>::infinity()};
  json["character"] = "\u00e4";
  json.update(Value{{"name", "phi"}, {"last", nullptr}});
  return json;
}

}  // namespace

TEST_CASE("a value prints as in nlohmann/json") {
  const Json json = example<Json>();
  const Library library = example<Library>();
  CHECK(json.dump() == library.dump());
  CHECK(json.dump(2) == library.dump(2));
  CHECK(json.dump(-1, true) == library.dump(-1, ' ', true));
}

TEST_CASE("members keep their order, and a pair that starts with a string is a member") {
  CHECK(Json{{"b", 1}, {"a", 2}}.dump() == R"({"b":1,"a":2})");
  CHECK(Json{{"b", 1}, {2, "a"}}.dump() == R"([["b",1],[2,"a"]])");
  CHECK(Json{"b", "a"}.dump() == R"(["b","a"])");
  CHECK(Json().dump() == "null");
}

TEST_CASE("bytes that are not UTF-8 are replaced") {
  CHECK(Json("\xff").dump() == "\"\xef\xbf\xbd\"");
}

TEST_CASE("items are members with keys, or elements of arrays") {
  const Json object{{"x", 1}, {"y", {2, 3}}};
  REQUIRE(object.items().size() == 2);
  CHECK(object.items()[1].first == "y");
  CHECK(object.items()[1].second->dump() == "[2,3]");
  CHECK(object.items()[1].second->items()[0].second->dump() == "2");
  CHECK(object.is_object());
  CHECK_FALSE(object.items()[0].second->is_structured());
}
