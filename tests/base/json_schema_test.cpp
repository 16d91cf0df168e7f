// Words of JSON Schema, in one order.
#include "base/json_schema.hpp"

#include <catch2/catch.hpp>

using namespace elgen;

TEST_CASE("an object has the keys it must have, and refuses others") {
  CHECK(object_schema({{"a", value_schema("string")}, {"b", {}, false}}, "two").dump() ==
        R"({"type":"object","properties":{"a":{"type":"string"},"b":null},)"
        R"("required":["a"],"additionalProperties":false,"description":"two"})");
  CHECK(object_schema({}, {}, value_schema("integer")).dump() ==
        R"({"type":"object","properties":{},"additionalProperties":{"type":"integer"}})");
}

TEST_CASE("words, lists and choices") {
  CHECK(word_schema({"x", "y"}).dump() == R"({"enum":["x","y"]})");
  CHECK(list_schema(value_schema("integer"), "all").dump() ==
        R"({"type":"array","items":{"type":"integer"},"description":"all"})");
  CHECK(choice_schema({value_schema("integer"), value_schema("null")}).dump() ==
        R"({"anyOf":[{"type":"integer"},{"type":"null"}]})");
}

TEST_CASE("a file starts with the language it is in") {
  CHECK(schema_text("numbers", value_schema("number")) ==
        "{\n  \"$schema\": \"http://json-schema.org/draft-07/schema#\",\n"
        "  \"title\": \"numbers\",\n  \"type\": \"number\"\n}\n");
}
