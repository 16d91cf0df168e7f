#include "layering/branches.hpp"

namespace elgen::test {
namespace {

/// The places with `==`, `!=` or `case` and an enumerator of `name` that matches the pattern
/// `enumerator`. An alias of `name` in the file counts as `name`.
Places branches(const SourceTree& tree, const std::string& name, const std::string& enumerator) {
  Places found;
  for (const std::string& path : governed(tree)) {
    const std::string& text = tree.at(path);
    if (!mentions(text, name)) continue;
    std::string names = name;
    static const std::regex alias(R"(using (\w+) = (\w+);)");
    for (std::sregex_iterator use(text.begin(), text.end(), alias), end; use != end; ++use) {
      if ((*use)[2] == name) names += "|" + (*use)[1].str();
    }
    const std::string word = "(?:" + names + ")::(?:" + enumerator + R"()\b)";
    const std::regex branch(R"((?:==|!=|\bcase) (?:\w+::)*)" + word + "|\\b" + word + " (?:==|!=)");
    const Lines lines = split_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!mentions(lines[i], "::") || begins(lines[i], "//")) continue;
      std::sregex_iterator place(lines[i].begin(), lines[i].end(), branch);
      for (const std::sregex_iterator end; place != end; ++place) {
        found.push_back(path + ":" + std::to_string(i + 1) + ": " +
                        lines[i].substr(indent_of(lines[i])));
      }
    }
  }
  return found;
}

}  // namespace

Places language_branches(const SourceTree& tree) { return branches(tree, "LanguageId", R"(\w+)"); }
Places output_branches(const SourceTree& tree) { return branches(tree, "OutputKind", R"(\w+)"); }
Places extent_branches(const SourceTree& tree) { return branches(tree, "Extent", R"(\w+)"); }
Places need_branches(const SourceTree& tree) { return branches(tree, "Need", R"(\w+)"); }

/// Branches on the opcodes listed in leaves.def, and on the enumerators of LeafKind.
Places leaf_branches(const SourceTree& tree) {
  const auto table = tree.find("include/elgen/leaves.def");
  if (table == tree.end()) return {};
  static const std::regex row(R"(^ELGEN_LEA\w+\((\w+),)");
  std::string kinds;
  for (const std::string& line : split_lines(table->second)) {
    std::smatch match;
    if (!std::regex_search(line, match, row)) continue;
    kinds += (kinds.empty() ? "" : "|") + match[1].str();
  }
  Places found = branches(tree, "Opcode", kinds);
  const Places others = branches(tree, "LeafKind", R"(\w+)");
  found.insert(found.end(), others.begin(), others.end());
  return found;
}

}  // namespace elgen::test
