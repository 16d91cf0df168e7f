// generated/README.md lists the committed code. The list is computed from the models, the scenes
// and the sidecars. ELGEN_UPDATE=1 writes the page; review the difference.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "elgen/syntax.hpp"
#include "pages/page.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view introduction = R"(# Generated code of all models and scenes

`elgen generate` writes each folder: a header, a page with the equations, and the equations as JSON. A test compares the
files with the output of the current elgen. [models/README.md](../models/README.md) explains the model files, and
[templates/README.md](../templates/README.md) explains the headers.

`tests/pages` checks this list; `ELGEN_UPDATE=1 build/release/tests/test_pages` writes it.

)";

SourcePointer read_source(const fs::path& path) {
  return make_source(path.filename(), read_text(path));
}

/// The text of the value of `key` in the first entry named `entry`.
template <class Syntax>
std::string text_of(const Syntax& syntax, const std::string& entry, const std::string& key) {
  for (const EntrySyntax& one : syntax.entries) {
    if (one.name == entry) return one.find(key)->value.text;
  }
  throw std::runtime_error("no [" + entry + "]");
}

/// The coordinates of a model, "x [m]; theta, phi [rad]". Equal units of neighbours are merged.
std::string coordinates_of(const std::string& name) {
  const auto json =
      nlohmann::json::parse(read_text(source / "generated" / name / (name + ".equations.json")));
  std::string text;
  std::string last;
  for (const auto& coordinate : json.at("coordinates")) {
    const std::string unit = coordinate.value("unit", "");
    const std::string ending = last.empty() ? "" : " [" + last + "]";
    if (!text.empty()) text += unit == last ? ", " : ending + "; ";
    text += "`" + coordinate.at("name").get<std::string>() + "`";
    last = unit;
  }
  return text + (last.empty() ? "" : " [" + last + "]");
}

/// Ending of a file name -> text of the link to the file.
using Endings = std::vector<std::pair<std::string_view, std::string_view>>;

const Endings code_endings{{".hpp", "C++"}, {".h", "C"}};
const Endings variant_endings{{"_eigen.hpp", "Eigen"}, {"_batch.hpp", "batch"}};
const Endings page_endings{{".md", "page"}};
const Endings sidecar_endings{{".equations.json", "JSON"}};

/// Links to the files that exist: "[Eigen](a/a_eigen.hpp), [batch](a/a_batch.hpp)".
std::string file_links(const std::string& name, const Endings& endings) {
  std::string links;
  for (const auto& [ending, word] : endings) {
    const std::string path = fmt::format("{0}/{0}{1}", name, ending);
    if (!fs::exists(source / "generated" / path)) continue;
    links += fmt::format("{}[{}]({})", links.empty() ? "" : ", ", word, path);
  }
  return links;
}

/// The picture in the first comment of a model: the indented lines and the blank lines between
/// them.
std::string sketch_of(const std::string& text) {
  std::string sketch;
  std::string gap;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && starts_with(line, "#");) {
    if (starts_with(line, "#  ")) {
      sketch += gap + line.substr(3) + "\n";
      gap.clear();
    } else if (!sketch.empty()) {
      gap += line == "#" ? "\n" : "";
      if (line != "#") break;
    }
  }
  return sketch;
}

std::string model_rows() {
  std::string rows =
      "## Models\n\n| model | title | coordinates | code | page | JSON |\n"
      "|---|---|---|---|---|---|\n";
  for (const fs::path& path : files_in(source / "models", ".toml")) {
    const std::string name = path.stem();
    const Result<FileSyntax> model = parse_model(read_source(path), Limits{});
    rows += fmt::format(
        "| [{0}](../models/{0}.toml) | {1} ([sketch](#{0})) | {2} | {3} | {4} | {5} |\n", name,
        text_of(*model, "model", "title"), coordinates_of(name), file_links(name, code_endings),
        file_links(name, page_endings), file_links(name, sidecar_endings));
  }
  return rows;
}

std::string scene_rows() {
  std::string rows =
      "\n## Scenes\n\n| scene | purpose | coordinates | code | Eigen, batch | page | JSON |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const fs::path& path : files_in(source / "models/scenes", ".scene.toml")) {
    const Result<FileSyntax> scene = parse_scene(read_source(path), Limits{});
    const std::string name =
        fs::path(text_of(*scene, "", "model")).stem().string() + "_" + text_of(*scene, "", "name");
    rows += fmt::format("| [{}](../models/scenes/{}) | {} | {} | {} | {} | {} | {} |\n", name,
                        path.filename().string(), text_of(*scene, "", "doc"), coordinates_of(name),
                        file_links(name, code_endings), file_links(name, variant_endings),
                        file_links(name, page_endings), file_links(name, sidecar_endings));
  }
  return rows;
}

std::string sketches() {
  std::string all = "\n## Sketches\n";
  for (const fs::path& path : files_in(source / "models", ".toml")) {
    all += fmt::format("\n### {}\n\n```text\n{}```\n", path.stem().string(),
                       sketch_of(read_text(path)));
  }
  return all;
}

}  // namespace

TEST_CASE("the sketch is the indented part of the first comment") {
  CHECK(sketch_of("# A cart.\n#\n#     o-->  x\n#\n#     |\n#\n# Both wheels turn.\n#   x\n") ==
        "   o-->  x\n\n   |\n");
}

TEST_CASE("the index of generated code is up to date") {
  const std::string index = std::string(introduction) + model_rows() + scene_rows() + sketches();
  const fs::path path = source / "generated/README.md";
  if (std::getenv("ELGEN_UPDATE") != nullptr) write_text(path, index);
  CHECK(read_text(path) == index);
}

}  // namespace elgen::test
