// The keys of diff_data.cpp, each with what it says.
#include "diff/diff_schema.hpp"

#include "base/json_schema.hpp"
#include "elgen/diff.hpp"
#include "lower/operation_columns.hpp"

namespace elgen {
namespace {

using Json = nlohmann::ordered_json;

Json text(std::string_view doc = {}) { return value_schema("string", doc); }

Json number(std::string_view doc = {}) { return value_schema("number", doc); }

Json or_null(Json schema, std::string_view doc) {
  return choice_schema({std::move(schema), value_schema("null")}, doc);
}

Json impact(std::string_view doc) {
  return word_schema(
      {
#define ELGEN_IMPACT(name, word, doc) word,
#include "elgen/impacts.def"
#undef ELGEN_IMPACT
      },
      doc);
}

Json place(std::string_view doc) {
  return or_null(object_schema({{"path", text()},
                                {"line", value_schema("integer")},
                                {"column", value_schema("integer")}}),
                 doc);
}

Json key_change() {
  return object_schema({{"id", text("the entry and its key: [gravity]/vector[2]")},
                        {"before", text("as written; empty where it is new")},
                        {"after", text("as written; empty where it is gone")},
                        {"old_place", place("null where it is new")},
                        {"new_place", place("null where it is gone")}});
}

Json witness() {
  return object_schema(
      {{"at", text("a state")}, {"before", number("the value there")}, {"after", number()}});
}

Json entry_change() {
  const auto form = [](std::string_view doc) { return or_null(text(), doc); };
  return object_schema(
      {{"id", text("gravity[2], linearization.A[1,2]")},
       {"verdict", word_schema({"identical", "equal", "different", "added", "removed"})},
       {"proved", value_schema("boolean", "of what is equal: by its closed form"), false},
       {"told_apart", value_schema("boolean", "of what differs, as all below: at some point"),
        false},
       {"unit", text("as models write it"), false},
       {"before", form("closed form; null where it is long or there is none"), false},
       {"after", form("the same of the newer version"), false},
       {"difference", form("after - before"), false},
       {"share", number("largest change, of the entry's largest magnitude"), false},
       {"witness", witness(), false}});
}

Json output_change() {
  return object_schema({{"name", text("of the function")},
                        {"entries", value_schema("integer", "how many it has")},
                        {"changes", list_schema(entry_change(), "all that are not identical")}});
}

Json operations_change() {
  Json counts = object_schema([] {
    std::vector<SchemaKey> keys;
    for (const auto& [name, count] : operation_columns) {
      keys.push_back({name, value_schema("integer")});
    }
    return keys;
  }());
  return object_schema({{"function", text()}, {"before", counts}, {"after", counts}});
}

Json warning() {
  return object_schema({{"code", text("as of elgen explain")},
                        {"message", text()},
                        {"place", place("null where it has none")}});
}

Json system_change() {
  return object_schema(
      {{"name", text("base name of the newer version")},
       {"impact", impact("the worst change of this model or scene")},
       {"keys", list_schema(key_change(), "of the files: the causes")},
       {"outputs", list_schema(output_change(), "what follows")},
       {"interface", list_schema(object_schema({{"impact", impact({})}, {"text", text()}}),
                                 "what callers rely on")},
       {"operations", list_schema(operations_change(), "of emitted functions; only where known"),
        false},
       {"renames",
        object_schema({}, "with which all entries would be equal", value_schema("string")), false},
       {"broken_expectations", list_schema(text(), "entries of [[expect]] that held")},
       {"warnings", list_schema(warning(), "that are new")},
       {"extension", text("values of new parameters at which all is as before"), false}});
}

}  // namespace

std::string diff_schema() {
  return schema_text(
      "report of elgen diff",
      object_schema({{"format", word_schema({"elgen diff 1"})},
                     {"impact", impact("the worst change of all")},
                     {"systems", list_schema(system_change(), "models and scenes that differ")},
                     {"added", list_schema(text(), "paths that only the newer side has")},
                     {"removed", list_schema(text(), "or the older one")}}));
}

}  // namespace elgen
