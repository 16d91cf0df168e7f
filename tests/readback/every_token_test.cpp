// Whatever single token of a function is replaced by another one of its kind, the file is refused.
#include <catch2/catch.hpp>
#include <memory>

#include "readback/header_reader.hpp"
#include "systems.hpp"
#include "written.hpp"

namespace elgen {
namespace {

const std::string some_outputs = R"toml([outputs]
mass_matrix = true
applied_force = true
forward_dynamics = true
sight = true
sight_jacobian = true
)toml";

/// Reads one header again and again; what its equations are worth is computed once.
class Reader {
 public:
  explicit Reader(const test::Written& all)
      : origin_{all.checked.model, all.checked.scene, all.program}, equations_(origin_) {}

  bool refuses(const std::string& text) {
    const SourcePointer source = make_source("changed", text);
    TokenReader tokens(*source);
    try {
      FileScope scope = read_header(tokens, origin_, equations_);
      if (scope_ == nullptr) scope_ = std::make_unique<FileScope>(std::move(scope));
      return false;
    } catch (const Mistake&) {
      return true;
    }
  }

  /// After the other header has been read.
  bool refuses_eigen(const std::string& text) {
    const SourcePointer source = make_source("changed", text);
    TokenReader tokens(*source);
    try {
      read_eigen_header(tokens, *scope_);
      return false;
    } catch (const Mistake&) {
      return true;
    }
  }

 private:
  Origin origin_;
  EquationReader equations_;
  std::unique_ptr<FileScope> scope_ = {};
};

/// The tokens between the brackets of function bodies.
std::vector<CodeToken> tokens_of_bodies(const std::string& text) {
  const CodeText code = code_tokens(text);
  std::vector<CodeToken> bodies;
  int depth = 0;
  for (std::size_t i = 1; i < code.tokens.size(); ++i) {
    const std::string_view before = code.tokens[i - 1].text;
    const std::string_view token = code.tokens[i].text;
    const bool is_start = token == "{" && (before == "noexcept" || before == ")");
    if (depth > 0 && token == "}") --depth;
    if (depth > 0) bodies.push_back(code.tokens[i]);
    if (token == "{" && (depth > 0 || is_start)) ++depth;
  }
  return bodies;
}

std::string other_number(std::string_view number) {
  std::string text(number);
  text.front() = text.front() == '9' ? '8' : static_cast<char>(text.front() + 1);
  return text;
}

/// Another name that stands in a body; the nearest one before.
std::string other_name(const std::vector<CodeToken>& tokens, std::size_t at) {
  for (std::size_t i = at; i-- > 0;) {
    if (tokens[i].kind == CodeTokenKind::name && tokens[i].text != tokens[at].text) {
      return std::string(tokens[i].text);
    }
  }
  return "other";
}

std::string other(const std::vector<CodeToken>& tokens, std::size_t at) {
  const std::string_view text = tokens[at].text;
  if (tokens[at].kind == CodeTokenKind::number) return other_number(text);
  if (tokens[at].kind == CodeTokenKind::name) return other_name(tokens, at);
  if (text == "+") return "-";
  if (text == "-") return "+";
  if (text == "*") return "/";
  if (text == "/") return "*";
  return "";  // brackets, commas and the like are left out
}

/// Counts what is not refused; tells the first of them.
template <class Refuses>
void expect_all_refused(const std::string& text, const Refuses& refuses) {
  REQUIRE_FALSE(refuses(text));
  const std::vector<CodeToken> tokens = tokens_of_bodies(text);
  CHECK(tokens.size() > 500);
  std::size_t accepted = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // A comma before the bracket that closes a list says nothing.
    const bool is_last = i + 1 < tokens.size() && tokens[i + 1].text == "}";
    if (tokens[i].text == "," && is_last) continue;
    std::string changed = text;
    const std::string replacement = other(tokens, i);
    changed.replace(tokens[i].begin, tokens[i].text.size(), replacement);
    if (refuses(changed)) continue;
    ++accepted;
    const std::size_t line = text.rfind('\n', tokens[i].begin) + 1;
    WARN("`" << tokens[i].text << "` -> `" << replacement << "` in\n"
             << text.substr(line, text.find('\n', tokens[i].begin) - line));
  }
  CHECK(accepted == 0);
}

}  // namespace

TEST_CASE("every other token of a C++ function is refused") {
  const test::Written all = test::written(test::wide_text(), some_outputs);
  Reader reader(all);
  expect_all_refused(test::file_of(all, ".hpp")->text,
                     [&](const std::string& text) { return reader.refuses(text); });
}

TEST_CASE("every other token of a C function is refused") {
  const test::Written all =
      test::written(test::wide_text(), some_outputs + "[emit]\nlanguage = \"c99\"\n");
  Reader reader(all);
  expect_all_refused(test::file_of(all, ".h")->text,
                     [&](const std::string& text) { return reader.refuses(text); });
}

TEST_CASE("every other token of a function on Eigen's types is refused") {
  const test::Written all = test::written(
      test::wide_text(), some_outputs + "[emit]\neigen = true\nstorage = \"column-major\"\n");
  Reader reader(all);
  REQUIRE_FALSE(reader.refuses(test::file_of(all, "scene.hpp")->text));
  expect_all_refused(test::file_of(all, "_eigen.hpp")->text,
                     [&](const std::string& text) { return reader.refuses_eigen(text); });
}

}  // namespace elgen
