#include "layering/ratchets.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "layering/branches.hpp"
#include "support/shell.hpp"

namespace elgen::test {

namespace {

/// The line that closes the block opened in line `first`: the next brace of the same indent.
std::size_t end_of_block(const Lines& lines, std::size_t first) {
  const std::string closing = std::string(indent_of(lines[first]), ' ') + "}";
  for (std::size_t i = first + 1; i < lines.size(); ++i) {
    if (starts_with(lines[i], closing)) return i;
  }
  return lines.size() - 1;
}

/// "src/choose" for src/choose/points.cpp, "include" for a noun.
std::string folder_of_file(const std::string& path) {
  return starts_with(path, "src/") ? "src/" + folder_of(room_of(path)) : folder_of(path);
}

bool is_published(const std::string& header, const std::vector<Layer>& layers) {
  const std::string room = room_of(header);
  const std::string name = std::filesystem::path(header).filename();
  return std::any_of(layers.begin(), layers.end(), [&](const Layer& layer) {
    return layer.folder == room && layer.published.count(name) + layer.published.count("*") > 0;
  });
}

Places reach_ins(const SourceTree& tree) {
  const std::vector<Layer> layers = parse_layers(tree.at("src/layers.txt"));
  Places found;
  for (const auto& [path, headers] : includes_of(tree)) {
    if (starts_with(path, "tests/")) continue;
    for (const std::string& header : headers) {
      if (!starts_with(header, "src/") || folder_of_file(header) == folder_of_file(path)) continue;
      if (!is_published(header, layers)) found.push_back(path + ": includes " + header);
    }
  }
  return found;
}

/// Names of enumerations that include a .def file.
std::set<std::string> table_enumerations(const SourceTree& tree) {
  static const std::regex opening(R"(^enum class (\w+))");
  std::set<std::string> names;
  for (const std::string& path : governed(tree)) {
    std::string name;
    for (const std::string& line : split_lines(tree.at(path))) {
      std::smatch match;
      if (starts_with(line, "enum ") && std::regex_search(line, match, opening)) name = match[1];
      if (!name.empty() && mentions(line, ".def\"")) names.insert(name);
      if (mentions(line, "};")) name.clear();
    }
  }
  return names;
}

/// True if `line` is a `case` label of an enumeration in `names`, or of an alias that `lines`
/// declare for the enumeration.
bool is_label_of(const std::string& line, const Lines& lines, const std::set<std::string>& names) {
  static const std::regex label(R"(\bcase (?:\w+::)*(\w+)::\w+:)");
  std::smatch match;
  if (!mentions(line, "case ") || !std::regex_search(line, match, label)) return false;
  const std::string alias = "using " + match[1].str() + " = ";
  return names.count(match[1]) > 0 ||
         std::any_of(lines.begin(), lines.end(), [&](const std::string& other) {
           const std::size_t start = indent_of(other) + alias.size();
           return begins(other, alias) && names.count(other.substr(start, other.find(';') - start));
         });
}

Places defaults_over_tables(const SourceTree& tree) {
  const std::set<std::string> names = table_enumerations(tree);
  return places_where(tree, [&](const Lines& lines, std::size_t i) -> std::string {
    if (!begins(lines[i], "switch (")) return "";
    const std::string label = std::string(indent_of(lines[i]) + 2, ' ') + "default:";
    const auto first = lines.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = lines.begin() + static_cast<std::ptrdiff_t>(end_of_block(lines, i));
    const bool has_default =
        std::any_of(first, end, [&](const std::string& line) { return starts_with(line, label); });
    if (!has_default) return "";
    const bool is_over_table = std::any_of(
        first, end, [&](const std::string& line) { return is_label_of(line, lines, names); });
    return is_over_table ? lines[i].substr(indent_of(lines[i])) : "";
  });
}

bool opens_class(const std::string& line) {
  return (begins(line, "class ") || begins(line, "struct ")) && !mentions(line, ";");
}

/// True if `line`, a line of a class without its indent, declares a data member: outside template
/// arguments, no parenthesis precedes the first `;`, `=` or `{`.
bool declares_member(const std::string& line) {
  static const std::regex other(
      R"(^(using|friend|static|public|private|protected|template|class|struct|enum)\b|^\W)");
  if (std::regex_search(line, other, std::regex_constants::match_continuous)) return false;
  int depth = 0;
  for (const char c : line) {
    if (c == '<') ++depth;
    if (c == '>') --depth;
    if (depth != 0) continue;
    if (c == '(') return false;
    if (c == ';' || c == '=' || c == '{') return true;
  }
  return false;
}

/// True if the line begins the declaration of a method; constructors and types do not count.
bool declares_method(const std::string& line, const std::string& name) {
  static const std::regex other(
      R"(^(using|friend|public|private|protected|class|struct|enum)\b|^[^\w\[])");
  if (std::regex_search(line, other, std::regex_constants::match_continuous)) return false;
  const std::size_t opening = line.find('(');
  if (opening == std::string::npos || declares_member(line)) return false;
  return !mentions(line.substr(0, opening + 1), name + "(");
}

/// Large classes. Structs of data may have many members, because each is accessed by name.
Places large_classes(const SourceTree& tree) {
  constexpr std::size_t most_members = 12;
  constexpr std::size_t most_methods = 20;
  static const std::regex opening(R"(^ *class (\w+)[^;]*$)");
  return places_where(tree, [&](const Lines& lines, std::size_t i) -> std::string {
    std::smatch name;
    if (!begins(lines[i], "class ") || !std::regex_search(lines[i], name, opening)) return "";
    const std::size_t indent = indent_of(lines[i]) + 2;
    std::size_t members = 0;
    std::size_t methods = 0;
    for (std::size_t j = i + 1; j < end_of_block(lines, i); ++j) {
      if (indent_of(lines[j]) != indent || begins(lines[j], "/")) continue;
      if (declares_member(lines[j].substr(indent))) ++members;
      if (declares_method(lines[j].substr(indent), name[1])) ++methods;
    }
    if (members <= most_members && methods <= most_methods) return "";
    return name[1].str() + ": " + std::to_string(members) + " members, " + std::to_string(methods) +
           " methods";
  });
}

Places function_objects(const SourceTree& tree) {
  return places_where(tree, [](const Lines& lines, std::size_t i) -> std::string {
    if (!opens_class(lines[i])) return "";
    const std::size_t indent = indent_of(lines[i]) + 2;
    const std::size_t end = end_of_block(lines, i);
    bool is_called = false;
    std::size_t members = 0;
    for (std::size_t j = i + 1; j < end; ++j) {
      if (indent_of(lines[j]) != indent || begins(lines[j], "/")) continue;
      if (mentions(lines[j], "operator()(")) is_called = true;
      if (declares_member(lines[j].substr(indent))) ++members;
    }
    return is_called && members >= 5 ? std::to_string(members) + " members" : "";
  });
}

/// Comparisons of goals with a list of goals. A property of a goal belongs in a table instead.
Places goal_lists(const SourceTree& tree) {
  return matching_lines(tree, "Goal",
                        R"((==|!=) (std::vector(<Goal>)?|Goals)? ?[({]+ ?(\w+::)?Goal::)");
}

Places thread_locals(const SourceTree& tree) {
  return matching_lines(tree, "thread_local", R"(^ *(static |inline )*thread_local )");
}

/// Numeric constants without a comment above them that gives a reason.
Places bare_constants(const SourceTree& tree) {
  static const std::regex constant(
      R"(^ *(inline |static )*constexpr (inline |static )*[\w:]+ \w+ = -?[0-9][^;]*;$)");
  return places_where(tree, [](const Lines& lines, std::size_t i) -> std::string {
    if (!mentions(lines[i], "constexpr ") || !std::regex_search(lines[i], constant)) return "";
    std::size_t above = i;
    while (above > 0 && mentions(lines[above - 1], "constexpr ")) --above;
    const bool has_reason = above > 0 && begins(lines[above - 1], "//");
    return has_reason ? "" : lines[i].substr(indent_of(lines[i]));
  });
}

Places random_generators(const SourceTree& tree) {
  return matching_lines(tree, "Random",
                        R"(^(?! *//)(?!.*explicit).*\bRandom( \w+( =|[;({])|[({]))");
}

/// LaTeX in code. Formulas are trees; only tables of formulas are typed in LaTeX.
Places latex_commands(const SourceTree& tree) {
  return matching_lines(
      tree, "\\",
      R"(^(?! *//).*\\(frac|sqrt|left|right|text|mathrm|mathbf|dot|ddot|partial|cdot)\b)");
}

/// Lower-case words with one space around each; other characters become spaces.
std::string words_of(const std::string& text) {
  std::string words = " ";
  for (const char c : text) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (words.back() != ' ') {
      words += ' ';
    }
  }
  return words + ' ';
}

bool has_noun_clause(const std::string& comment) {
  static const std::regex opening(R"([/!]?<? (Of|That of|Those|What)\b)");
  constexpr std::array phrases{" but for ", " of which ", " those that ",   " likewise ",
                               " of what ", " that of ",  " stands there ", " stands beside "};
  const std::string words = words_of(comment);
  return std::regex_search(comment, opening, std::regex_constants::match_continuous) ||
         std::any_of(phrases.begin(), phrases.end(),
                     [&](const char* phrase) { return mentions(words, phrase); });
}

/// Comments with noun clauses. Unlike the other rules, this rule counts the tests, too.
Places noun_clauses(const SourceTree& tree) {
  Places found;
  for (const auto& [path, text] : tree) {
    std::size_t number = 0;
    for (const std::string& line : split_lines(text)) {
      ++number;
      const std::size_t start = line.find("//");
      if (start == std::string::npos || !has_noun_clause(line.substr(start + 2))) continue;
      found.push_back(path + ":" + std::to_string(number) + ": " + line.substr(indent_of(line)));
    }
  }
  return found;
}

struct Rule {
  const char* name;
  Places (*find)(const SourceTree&);
  const char* instead;
};

constexpr std::array rules{
    Rule{"reach-ins", reach_ins, "include a noun, or publish the header in src/layers.txt"},
    Rule{"defaults", defaults_over_tables, "list the rows, so that the compiler asks for new ones"},
    Rule{"languages", language_branches, "let the row of the language say what differs"},
    Rule{"outputs", output_branches, "let the row of the output say what differs"},
    Rule{"leaves", leaf_branches, "let the row of the kind of leaf say what differs"},
    Rule{"extents", extent_branches, "ask for the lines along the extent"},
    Rule{"needs", need_branches, "let a row of lacks say what is missing"},
    Rule{"goals", goal_lists, "let the row of the analysis say what differs"},
    Rule{"randoms", random_generators, "ask for points and states where they are drawn already"},
    Rule{"latex", latex_commands, "build a formula, or type it in a table"},
    Rule{"thread-locals", thread_locals, "pass it as an argument"},
    Rule{"bare-constants", bare_constants, "say in a comment why it has this value"},
    Rule{"large-classes", large_classes, "divide it into functions with named results"},
    Rule{"function-objects", function_objects, "write functions that pass results to each other"},
    Rule{"noun-clauses", noun_clauses, "write subject, verb, object"},
};

struct Row {
  std::size_t most = 0;
  std::vector<std::string> besides = {};
};

using Rows = std::map<std::string, Row>;

Rows parse_rows(const std::string& text) {
  Rows rows;
  for (const std::string& line : split_lines(text)) {
    if (starts_with(line, "#")) continue;
    std::istringstream words(line);
    std::string name;
    Row row;
    if (!(words >> name >> row.most)) continue;
    for (std::string word; words >> word;) row.besides.push_back(word);
    rows[name] = row;
  }
  return rows;
}

struct Count {
  std::string name;
  std::size_t number = 0;
  std::size_t slack = 0;  ///< tolerance, in 1/10 000 of the row
  std::string instead = {};
  Places places = {};
};

/// The number of lines. A tolerance of 0.25 % avoids an edit of the row with every change.
Count line_count(const SourceTree& tree) {
  std::size_t lines = 0;
  for (const std::string& path : governed(tree)) lines += count(tree.at(path), "\n");
  return {"sum", lines, 25, "take lines out, or raise the row and say why in the commit"};
}

std::vector<Count> all_counts(const SourceTree& tree, Rows rows) {
  std::vector<Count> counts{line_count(tree)};
  for (const Rule& rule : rules) {
    const std::vector<std::string> besides = rows[rule.name].besides;
    Places places = rule.find(tree);
    places.erase(std::remove_if(places.begin(), places.end(),
                                [&](const std::string& found) {
                                  return std::any_of(besides.begin(), besides.end(),
                                                     [&](const std::string& path) {
                                                       return starts_with(found, path);
                                                     });
                                }),
                 places.end());
    const std::size_t number = places.size();
    counts.push_back({rule.name, number, 0, rule.instead, std::move(places)});
  }
  return counts;
}

}  // namespace

std::vector<std::string> broken_ratchets(const SourceTree& tree, const std::string& text) {
  Rows rows = parse_rows(text);
  std::vector<std::string> found;
  for (const Count& figure : all_counts(tree, rows)) {
    const std::string is = figure.name + ": " + std::to_string(figure.number);
    const auto row = rows.find(figure.name);
    if (row == rows.end()) {
      found.push_back(is + ", and no row in tests/layering/ratchets.txt");
      continue;
    }
    const std::size_t most = row->second.most;
    const std::size_t slack = most * figure.slack / 10000;
    if (figure.number > most + slack) {
      found.push_back(is + ", more than " + std::to_string(most) + "; " + figure.instead);
      found.insert(found.end(), figure.places.begin(), figure.places.end());
    } else if (figure.number + slack < most) {
      found.push_back(is + ", less than " + std::to_string(most) +
                      "; lower its row in tests/layering/ratchets.txt");
    }
    rows.erase(row);
  }
  for (const auto& [name, row] : rows) found.push_back(name + ": a row of no rule");
  return found;
}

}  // namespace elgen::test
