// Tables of a file: their order, and unknown, wrong, unsupported and missing tables.
#include "parse/entry_reader.hpp"

#include <catch2/catch.hpp>

#include "parse_testing.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

const std::string head = "format = 1\n[model]\nname = \"m\"\n";

}  // namespace

TEST_CASE("entries keep the order of the file", "[parse]") {
  CHECK(model_answer(head + "[[point]]\nname = \"p\"\nat = [0, 0]\n[[coordinate]]\nname = \"x\"\n"
                            "[[point]]\nname = \"a\"\nat = [0, 0]\n") ==
        "[]\n  format = 1\n[model]\n  name = m\n[point]\n  name = p\n  at = [0, 0]\n"
        "[coordinate]\n  name = x\n[point]\n  name = a\n  at = [0, 0]\n");
}

TEST_CASE("an unknown entry is reported with the nearest known entry", "[parse]") {
  const std::string text = head + "[[coordinate]]\nname = \"x\"\n[[coordinates]]\nname = \"y\"\n";
  CHECK(model_answer(text) == "E106 6:1");
  CHECK(first_error(text).message == "unknown entry `coordinates`");
  CHECK(first_error(text).hint == "did you mean `[[coordinate]]`?");
  CHECK(first_error(head + "[[coordinate]]\nname = \"x\"\n[lock]\n").code == Code::E106);
}

TEST_CASE("a table of the wrong kind is reported with the right header", "[parse]") {
  const std::string single = head + "[coordinate]\nname = \"x\"\n";
  CHECK(model_answer(single) == "E107 4:1");
  CHECK(first_error(single).hint == "write `[[coordinate]]`");
  const std::string doubled = head + "[[coordinate]]\nname = \"x\"\n[[parameters]]\nm = 1\n";
  CHECK(model_answer(doubled) == "E107 6:1");
  CHECK(first_error(doubled).hint == "write `[parameters]`");
  CHECK(model_answer("coordinate = 3\n" + head) == "E104 1:14");
}

TEST_CASE("an entry that is not supported yet is reported as such", "[parse]") {
  const std::string scene = "format = 1\nmodel = \"m\"\nname = \"s\"\n";
  CHECK(scene_answer(scene + "[numeric]\ncheck = {}\n") == "E108 5:1");
}

TEST_CASE("a model without a name or coordinates is reported", "[parse]") {
  CHECK(model_answer("format = 1\n") == "E105 1:1\nE105 1:1");
  CHECK(first_error(head).message == "no `[[coordinate]]` in the file");
}

TEST_CASE("keys of the top level are checked", "[parse]") {
  CHECK(model_answer("titel = \"x\"\n" + head + "[[coordinate]]\nname = \"x\"\n") == "E103 1:1");
  CHECK(scene_answer("format = 1\nname = \"s\"\n") == "E105 1:1");
  CHECK(scene_answer("format = 1\nmodel = \"m\"\nname = \"s\"\noutputs.bias = true\n") ==
        "[]\n  format = 1\n  model = \"m\"\n  name = s\n[outputs]\n  bias = true\n");
}

TEST_CASE("a scene differs from a model by its key `model`") {
  const auto names = [](const std::string& text) {
    const SourcePointer source = make_source("<stdin>", text);
    return find_model_key(*source).has_value();
  };
  CHECK(names("format = 1\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("format = 1\n[model]\nname = \"a\"\n"));
  CHECK_FALSE(names("[outputs]\nmodel = \"a.toml\"\n"));
  CHECK_FALSE(names("model = \n"));
}

TEST_CASE("a model is a TOML file with a table `model`, other TOML files are not") {
  CHECK(declares_model(*make_source("a.toml", "format = 1\n[model]\nname = \"a\"\n")));
  CHECK_FALSE(declares_model(*make_source("a.toml", "model = \"b.toml\"\n")));
  CHECK_FALSE(declares_model(*make_source("a.toml", "# [model]\n[tool]\n")));
  CHECK_FALSE(declares_model(*make_source("a.toml", "[model\n")));
}
