#include "layering/layering.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <regex>
#include <sstream>

#include "support/shell.hpp"

namespace elgen::test {

namespace {

const std::string noun_folder = "include/elgen/";

bool is_code(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  return extension == ".cpp" || extension == ".hpp" || extension == ".def";
}

std::vector<Layer> layers_of(const SourceTree& tree) {
  return parse_layers(tree.at("src/layers.txt"));
}

/// The folder a file belongs to: src/<folder>/…, src/<folder>.cpp, or the maker of a noun.
std::string folder_of(const std::string& path, const std::vector<Layer>& layers) {
  const std::string stem = std::filesystem::path(path).stem();
  if (starts_with(path, noun_folder)) {
    for (const Layer& layer : layers) {
      if (std::count(layer.nouns.begin(), layer.nouns.end(), stem) > 0) return layer.folder;
    }
    return "";
  }
  const std::string inside = path.substr(std::string("src/").size());
  const std::size_t slash = inside.find('/');
  return slash == std::string::npos ? stem : inside.substr(0, slash);
}

std::optional<std::size_t> position_of(const std::string& folder,
                                       const std::vector<Layer>& layers) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].folder == folder) return i;
  }
  return std::nullopt;
}

/// Included names as written: `"elgen/model.hpp"` without its quotes, `<ginac/ginac.h>` likewise.
std::vector<std::string> included_names(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, directive)) names.push_back(match[1]);
  }
  return names;
}

/// The project's file an include means, if it is one: beside the includer, in include/, or in src/.
std::optional<std::string> resolve(const SourceTree& tree, const std::string& includer,
                                   const std::string& name) {
  const std::string beside =
      (std::filesystem::path(includer).parent_path() / name).lexically_normal().string();
  for (const std::string& candidate : {beside, "include/" + name, "src/" + name}) {
    if (tree.count(candidate) > 0) return candidate;
  }
  return std::nullopt;
}

std::vector<std::string> included_files(const SourceTree& tree, const std::string& path) {
  std::vector<std::string> files;
  for (const std::string& name : included_names(tree.at(path))) {
    if (const auto file = resolve(tree, path, name)) files.push_back(*file);
  }
  return files;
}

/// Everything `path` includes, directly or not, itself among it.
std::set<std::string> closure(const SourceTree& tree, const std::string& path) {
  std::set<std::string> reached{path};
  std::vector<std::string> open{path};
  while (!open.empty()) {
    const std::string current = open.back();
    open.pop_back();
    for (const std::string& next : included_files(tree, current)) {
      if (reached.insert(next).second) open.push_back(next);
    }
  }
  return reached;
}

bool names_ginac(const std::string& text) {
  const auto names = included_names(text);
  return std::any_of(names.begin(), names.end(),
                     [](const std::string& name) { return starts_with(name, "ginac/"); });
}

bool may_use_ginac(const std::string& path, const std::vector<Layer>& layers) {
  const auto position = position_of(folder_of(path, layers), layers);
  if (!position) return false;
  const Layer& layer = layers[*position];
  return layer.all_ginac || layer.ginac_files.count(std::filesystem::path(path).filename()) > 0;
}

/// The files that layers.txt speaks about.
std::vector<std::string> governed(const SourceTree& tree) {
  std::vector<std::string> paths;
  for (const auto& [path, text] : tree) {
    const bool inside = starts_with(path, "src/") || starts_with(path, noun_folder);
    if (inside && is_code(path)) paths.push_back(path);
  }
  return paths;
}

}  // namespace

std::vector<Layer> parse_layers(std::string_view text) {
  std::vector<Layer> layers;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line.front() == '#') continue;
    Layer layer;
    std::istringstream(line.substr(0, colon)) >> layer.folder;
    std::istringstream words(line.substr(colon + 1));
    bool after_ginac = false;
    for (std::string word; words >> word;) {
      if (word == "ginac") {
        after_ginac = true;
      } else if (!after_ginac) {
        layer.nouns.push_back(word);
      } else if (word == "*") {
        layer.all_ginac = true;
      } else {
        layer.ginac_files.insert(word);
      }
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

SourceTree read_tree(const std::filesystem::path& root) {
  SourceTree tree;
  for (const std::string top : {"src", "include", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / top)) {
      const std::string path = entry.path().lexically_relative(root).string();
      if (is_code(path) || path == "src/layers.txt") tree[path] = read_text(entry.path());
    }
  }
  return tree;
}

std::vector<std::string> later_includes(const SourceTree& tree) {
  const std::vector<Layer> layers = layers_of(tree);
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    const auto own = position_of(folder_of(path, layers), layers);
    if (!own) {
      found.push_back(path + ": its folder or noun is not in src/layers.txt");
      continue;
    }
    for (const std::string& reached : closure(tree, path)) {
      const auto other = position_of(folder_of(reached, layers), layers);
      if (other && *other > *own) found.push_back(path + ": reaches the later " + reached);
    }
  }
  return found;
}

std::vector<std::string> include_cycles(const SourceTree& tree) {
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    for (const std::string& next : included_files(tree, path)) {
      if (closure(tree, next).count(path) > 0) {
        found.push_back(path + ": is included again by " + next);
      }
    }
  }
  return found;
}

std::vector<std::string> misplaced_ginac(const SourceTree& tree) {
  const std::vector<Layer> layers = layers_of(tree);
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    if (may_use_ginac(path, layers)) continue;
    for (const std::string& reached : closure(tree, path)) {
      if (names_ginac(tree.at(reached))) found.push_back(path + ": reaches GiNaC by " + reached);
    }
  }
  return found;
}

std::vector<std::string> sources_without_test(const SourceTree& tree) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    if (!starts_with(path, "src/") || std::filesystem::path(path).extension() != ".cpp") continue;
    const std::string stem = std::filesystem::path(path).stem();
    const std::string test = "tests/" + folder_of(path, {}) + "/" + stem + "_test.cpp";
    if (tree.count(test) == 0) found.push_back(path + ": has no " + test);
  }
  return found;
}

std::vector<std::string> types_declared_twice(const SourceTree& tree) {
  static const std::regex opening(R"(^namespace ?([\w:]*) ?\{)");
  static const std::regex type(R"(^(struct|class|enum class) (\w+)( final)?( : [^{;]*)? ?\{)");
  std::map<std::string, std::string> known;
  std::vector<std::string> sentences;
  for (const auto& [path, text] : tree) {
    if (starts_with(path, "tests/")) continue;
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (std::regex_search(line, match, opening)) names.push_back(match[1]);
      if (starts_with(line, "}  // namespace") && !names.empty()) names.pop_back();
      const bool is_local = std::find(names.begin(), names.end(), "") != names.end();
      if (is_local || !std::regex_search(line, match, type)) continue;
      std::string name;
      for (const std::string& part : names) name += part + "::";
      name += match[2];
      const auto [first, is_new] = known.emplace(name, path);
      if (!is_new) sentences.push_back(path + ": " + name + " is also in " + first->second);
    }
  }
  return sentences;
}

std::vector<std::string> long_files(const SourceTree& tree, std::size_t most_lines) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    if (lines > most_lines) found.push_back(path + ": has " + std::to_string(lines) + " lines");
  }
  return found;
}

}  // namespace elgen::test
