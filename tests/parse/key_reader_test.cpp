// Keys of one table: unknown, missing, unsupported, and words out of a choice.
#include <catch2/catch.hpp>

#include "parse/entry_reader.hpp"
#include "parse_testing.hpp"

using namespace elgen;
using testing::model_answer;
using testing::scene_answer;

namespace {

std::string model(std::string_view rest) {
  return "format = 1\nmodel.name = \"m\"\n[[coordinate]]\nname = \"x\"\n" + std::string(rest);
}

std::string scene(std::string_view rest) {
  return "format = 1\nmodel = \"m.toml\"\nname = \"s\"\n" + std::string(rest);
}

}  // namespace

TEST_CASE("an unknown key is named, with the nearest one", "[parse]") {
  const std::string text = model("ragne = [0, 1]\nnonsense = 1\n");
  CHECK(model_answer(text) == "E103 5:1\nE103 6:1");
  const Diagnostic error = testing::first_error(text);
  CHECK(error.message == "unknown key `ragne` in `[[coordinate]]`");
  CHECK(error.hint == "did you mean `range`?");
  CHECK(model_answer(model("[parameters]\nm = {valeu = 1}\n")) == "E105 6:1\nE103 6:6");
}

TEST_CASE("a missing key is reported at the header", "[parse]") {
  CHECK(model_answer(model("[[input]]\nunit = \"N\"\n")) == "E105 5:1");
  CHECK(testing::first_error(model("[[input]]\n")).message == "no `name` in `[[input]]`");
  CHECK(model_answer(model("[[point]]\nname = \"P\"\n[[point]]\nat = [1, 2]\n")) ==
        "E105 5:1\nE105 7:1");
}

TEST_CASE("keys that come later say so, and nothing they would replace is missed", "[parse]") {
  CHECK(model_answer(model("[[output]]\nname = \"tip\"\nframe = \"F\"\n")) == "E108 7:1");
  CHECK(model_answer(model("[[body]]\nname = \"b\"\nframe = \"F\"\n")) == "E108 7:1");
  CHECK(model_answer(model("[[force]]\nvalue = 1\nin = \"F\"\nframe = \"F\"\n")) ==
        "E108 7:1\nE108 8:1");
  CHECK(model_answer(model("kind = \"rotation\"")) == "E108 5:9");
  CHECK(testing::first_error(model("kind = \"rotation\"")).message ==
        "`rotation` is not yet supported");
  CHECK(scene_answer(scene("[numeric]\nform = \"closed\"\nbatch = 4\n")) == "E108 5:1\nE108 6:1");
  CHECK(scene_answer(scene("[emit]\nlanguage = \"c99\"\neigen = true\n")) == "E108 5:13\nE108 6:1");
  CHECK(scene_answer(scene("[outputs]\nbias = {form = \"closed\"}\n")) == "E108 5:9");
}

TEST_CASE("choices take the words of the table", "[parse]") {
  CHECK(model_answer(model("kind = \"scalar\"")).find("kind = \"scalar\"") != std::string::npos);
  const std::string text = model("[parameters]\nm = {value = 1, assume = \"positiv\"}\n");
  CHECK(model_answer(text) == "E104 6:27");
  CHECK(testing::first_error(text).message ==
        "`positiv` where `positive` or `nonnegative` is expected");
  CHECK(scene_answer(scene("[numeric]\nscalar = [\"float\", \"half\"]\n")) == "E104 5:21");
  CHECK(scene_answer(scene("[numeric]\nscalar = \"float\"\n")) == "E104 5:10");
}

TEST_CASE("closed forms are expressions, lists, matrices or entries", "[parse]") {
  const std::string text = model_answer(
      model("[[expect]]\nkinetic_energy = \"T0\"\ngravity = [\"0\", 1]\nmass_matrix = [[\"m\"]]\n"
            "drift_entry = {for = \"i in 1..n\", value = \"0\"}\nconserved = [\"E\"]\n"));
  CHECK(text.find("kinetic_energy = T0\n  gravity = [0, 1]\n  mass_matrix = [[m]]\n"
                  "  drift_entry = {for = [{index = i, low = 1, high = n}], value = 0}\n"
                  "  conserved = [E]\n") != std::string::npos);
  CHECK(model_answer(model("[[expect]]\nmass_matrix = [[[1]]]\n")) == "E104 6:17");
  CHECK(model_answer(model("[[expect]]\nconserved = \"E\"\n")) == "E104 6:13");
}

TEST_CASE("parameters are numbers, strings, tables or sub-tables, in file order", "[parse]") {
  const std::string text =
      model_answer(model("[parameters]\nz = 1\nb = \"1/2\"\na = {value = [1, 2], size = \"n\"}\n"
                         "[parameters.m]\nvalue = 3\nunit = \"kg\"\n"));
  CHECK(text.find("  z = 1\n  b = (1 / 2)\n  a = {value = [1, 2], size = n}\n"
                  "  m = {value = 3, unit = \"kg\"}\n") != std::string::npos);
  CHECK(model_answer(model("[parameters]\nm = true\n")) == "E104 6:5");
}

TEST_CASE("fixed is `all` or a table", "[parse]") {
  CHECK(scene_answer(scene("[parameters]\nfixed = \"all\"\n")).find("fixed = \"all\"") !=
        std::string::npos);
  CHECK(scene_answer(scene("[parameters]\nfixed = {g = 9.81, l = \"1/2\"}\n"))
            .find("fixed = {g = 9.81, l = (1 / 2)}") != std::string::npos);
  CHECK(scene_answer(scene("[parameters]\nfixed = [1]\n")) == "E104 5:9");
}
