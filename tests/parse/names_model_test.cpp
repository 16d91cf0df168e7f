// names_model: scenes name a model, models have a table of that name.
#include "parse/names_model.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a scene is told from a model by its key `model`") {
  const auto names = [](const std::string& text) {
    const elgen::SourcePointer source = elgen::make_source("<stdin>", text);
    return elgen::names_model(*source);
  };
  CHECK(names("format = 1\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("format = 1\n[model]\nname = \"a\"\n"));
  CHECK_FALSE(names("[outputs]\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("model = \n"));
}
