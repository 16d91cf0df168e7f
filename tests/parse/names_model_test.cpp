// named_model: scenes name a model, models have a table of that name.
#include "parse/names_model.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a scene is told from a model by its key `model`") {
  const auto names = [](const std::string& text) {
    const elgen::SourcePointer source = elgen::make_source("<stdin>", text);
    return elgen::named_model(*source).has_value();
  };
  CHECK(names("format = 1\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("format = 1\n[model]\nname = \"a\"\n"));
  CHECK_FALSE(names("[outputs]\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("model = \n"));
}

TEST_CASE("a model is TOML with a table of that name, files of other programs are none") {
  CHECK(
      elgen::declares_model(*elgen::make_source("a.toml", "format = 1\n[model]\nname = \"a\"\n")));
  CHECK_FALSE(elgen::declares_model(*elgen::make_source("a.toml", "model = \"b.toml\"\n")));
  CHECK_FALSE(elgen::declares_model(*elgen::make_source("a.toml", "# [model]\n[tool]\n")));
  CHECK_FALSE(elgen::declares_model(*elgen::make_source("a.toml", "[model\n")));
}
