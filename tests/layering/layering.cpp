#include "layering/layering.hpp"

#include <algorithm>
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

/// The folder that owns a noun (a header of include/elgen); empty if none does.
std::string maker_of(const std::string& noun, const std::vector<Layer>& layers) {
  const std::string stem = std::filesystem::path(noun).stem();
  for (const Layer& layer : layers) {
    if (std::count(layer.nouns.begin(), layer.nouns.end(), stem) > 0) return layer.folder;
  }
  return "";
}

/// The index in `layers` of the room of a file, or of the first room of the folder of a noun.
std::optional<std::size_t> position_of(const std::string& path, const std::vector<Layer>& layers) {
  const bool is_noun = starts_with(path, noun_folder);
  const std::string wanted = is_noun ? maker_of(path, layers) : room_of(path);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string& known = layers[i].folder;
    if (known == wanted || (is_noun && folder_of(known) == wanted)) return i;
  }
  return std::nullopt;
}

/// Names in `#include` directives, without quotes or angle brackets.
std::vector<std::string> included_names(const std::string& text) {
  static const std::regex directive(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  std::vector<std::string> names;
  for (const std::string& line : split_lines(text)) {
    if (!mentions(line, "include")) continue;
    std::smatch match;
    if (std::regex_search(line, match, directive)) names.push_back(match[1]);
  }
  return names;
}

/// The project's file that an include names, if any: relative to the includer, include/ or src/.
std::optional<std::string> resolve(const SourceTree& tree, const std::string& includer,
                                   const std::string& name) {
  const std::string beside =
      (std::filesystem::path(includer).parent_path() / name).lexically_normal().string();
  for (const std::string& candidate : {beside, "include/" + name, "src/" + name}) {
    if (tree.count(candidate) > 0) return candidate;
  }
  return std::nullopt;
}

/// `path` and every file that it includes, directly or indirectly.
std::set<std::string> closure(Includes& includes, const std::string& path) {
  std::set<std::string> reached{path};
  std::vector<std::string> open{path};
  while (!open.empty()) {
    const std::string current = open.back();
    open.pop_back();
    for (const std::string& next : includes[current]) {
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
  const auto position = position_of(path, layers);
  if (!position) return false;
  const Layer& layer = layers[*position];
  return layer.all_ginac || layer.ginac_files.count(std::filesystem::path(path).filename()) > 0;
}

}  // namespace

std::string room_of(const std::string& path) {
  const std::filesystem::path inside = std::filesystem::path(path).lexically_relative("src");
  return inside.has_parent_path() ? inside.parent_path().string() : inside.stem().string();
}

std::string folder_of(const std::string& room) { return room.substr(0, room.find('/')); }

Includes includes_of(const SourceTree& tree) {
  Includes includes;
  for (const auto& [path, text] : tree) {
    for (const std::string& name : included_names(text)) {
      if (const auto file = resolve(tree, path, name)) includes[path].push_back(*file);
    }
  }
  return includes;
}

std::vector<std::string> governed(const SourceTree& tree) {
  std::vector<std::string> paths;
  for (const auto& [path, text] : tree) {
    const bool inside = starts_with(path, "src/") || starts_with(path, noun_folder);
    if (inside && is_code(path)) paths.push_back(path);
  }
  return paths;
}

std::vector<Layer> parse_layers(std::string_view text) {
  std::vector<Layer> layers;
  for (const std::string& line : split_lines(text)) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line.front() == '#') continue;
    Layer layer;
    std::istringstream(line.substr(0, colon)) >> layer.folder;
    std::istringstream words(line.substr(colon + 1));
    std::string column;
    for (std::string word; words >> word;) {
      if (word == "ginac" || word == "publishes") {
        column = word;
      } else if (column.empty()) {
        layer.nouns.push_back(word);
      } else if (column == "publishes") {
        layer.published.insert(word);
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
  Includes includes = includes_of(tree);
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    const auto own = position_of(path, layers);
    if (!own) {
      found.push_back(path + ": its folder or noun is not in src/layers.txt");
      continue;
    }
    for (const std::string& reached : closure(includes, path)) {
      const auto other = position_of(reached, layers);
      if (other && *other > *own) found.push_back(path + ": reaches the later " + reached);
    }
  }
  return found;
}

std::vector<std::string> joins_without_ranges(const SourceTree& tree) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    // Split, so that this file does not contain the text itself.
    if (!is_code(path) || !mentions(text, std::string("fmt::") + "join(")) continue;
    const std::vector<std::string> names = included_names(text);
    if (std::count(names.begin(), names.end(), "fmt/ranges.h") == 0) {
      found.push_back(path + ": writes fmt::join without <fmt/ranges.h>");
    }
  }
  return found;
}

std::vector<std::string> include_cycles(const SourceTree& tree) {
  Includes includes = includes_of(tree);
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    for (const std::string& next : includes[path]) {
      if (closure(includes, next).count(path) > 0) {
        found.push_back(path + ": is included again by " + next);
      }
    }
  }
  return found;
}

std::vector<std::string> misplaced_ginac(const SourceTree& tree) {
  const std::vector<Layer> layers = layers_of(tree);
  Includes includes = includes_of(tree);
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    if (may_use_ginac(path, layers)) continue;
    for (const std::string& reached : closure(includes, path)) {
      if (names_ginac(tree.at(reached))) found.push_back(path + ": reaches GiNaC by " + reached);
    }
  }
  return found;
}

std::vector<std::string> types_of_two_meanings(const SourceTree& tree) {
  static const std::regex type(R"(^(struct|class|enum class) (\w+)( final)?( : [^{;]*)? ?\{)");
  std::map<std::string, std::string> known;
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    if (starts_with(path, "tests/")) continue;
    for (const std::string& line : split_lines(text)) {
      std::smatch match;
      if (!std::regex_search(line, match, type)) continue;
      const auto [first, is_new] = known.emplace(match[2], path);
      if (!is_new) found.push_back(path + ": " + first->first + " is also in " + first->second);
    }
  }
  return found;
}

std::vector<std::string> includes_beside(const SourceTree& tree) {
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    for (const std::string& name : included_names(tree.at(path))) {
      if (tree.count("include/" + name) > 0 || tree.count("src/" + name) > 0) continue;
      const std::filesystem::path beside = std::filesystem::path(path).parent_path() / name;
      if (tree.count(beside.lexically_normal().string()) == 0) continue;
      found.push_back(path + ": includes \"" + name + "\", which is not a path from src");
    }
  }
  return found;
}

std::vector<std::string> unusual_namespaces(const SourceTree& tree) {
  static const std::regex opening(R"(^namespace (elgen\S*) \{)");
  static const std::set<std::string> own{"urdf", "oracle", "cli"};
  std::vector<std::string> found;
  for (const std::string& path : governed(tree)) {
    const std::string folder = folder_of(room_of(path));
    const bool may_have_own = starts_with(path, "src/") && own.count(folder) > 0;
    std::smatch match;
    for (const std::string& line : split_lines(tree.at(path))) {
      if (!std::regex_search(line, match, opening)) continue;
      if (match[1] == "elgen" || (may_have_own && match[1] == "elgen::" + folder)) continue;
      found.push_back(path + ": opens namespace " + match[1].str());
    }
  }
  return found;
}

std::vector<std::string> long_files(const SourceTree& tree, std::size_t most_lines) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    if (path.starts_with("tests/emit/golden/")) continue;  // generated files
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    if (lines > most_lines) found.push_back(path + ": has " + std::to_string(lines) + " lines");
  }
  return found;
}

}  // namespace elgen::test
