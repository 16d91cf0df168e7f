// A whole model gives all diagnostics in order, without duplicates. Tests cycles and long chains.
#include <rapidcheck.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <ctime>
#include <filesystem>

#include "base/report.hpp"
#include "check_testing.hpp"
#include "model_text.hpp"

namespace elgen::test {

namespace {

/// True if operands precede their users, so that later stages visit each expression only once.
bool is_ordered(const Model& model) {
  for (ExpressionId id = 0; id < model.expressions.size(); ++id) {
    for (const ExpressionId operand : model.expressions[id].operands) {
      if (operand >= id) return false;
    }
  }
  return true;
}

double seconds_for(const std::string& model, int n) {
  const std::clock_t begin = std::clock();
  (void)checked(model, {.sizes = {"n=" + std::to_string(n)}});
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Offsets of the bytes inside strings; bytes outside are a matter of the TOML parser.
std::vector<std::size_t> offsets_in_strings(const std::string& text) {
  std::vector<std::size_t> offsets;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      inside = !inside;
    } else if (inside) {
      offsets.push_back(i);
    }
  }
  return offsets;
}

}  // namespace

TEST_CASE("the models of the project have no errors, warnings or notes") {
  const std::vector<std::filesystem::path> paths = model_paths();
  REQUIRE(paths.size() >= 8);
  for (const std::filesystem::path& path : paths) {
    INFO(path);
    CHECK(messages(read_text(path)).empty());
    CHECK(is_ordered(checked(read_text(path)).model));
  }
}

TEST_CASE("independent errors are reported in one run, in order of position") {
  CHECK(messages(R"toml(format = 1
[model]
name = "Many"
[[coordinate]]
name = "x"
unit = "mm"
[parameters]
m = { value = "1/0", unit = "kg" }
t = 3
[energy]
T = "1/2*m*dot(x)^2"
V = "q + sinn(x)"
[[point]]
name = "x"
at = ["0"]
)toml") ==
        "E205 3:9 `Many` is not lower-case letters, digits and underscores\n"
        "E402 6:9 unknown unit `mm` | 1 mm is 0.001 m\n"
        "E312 8:18 `0` is zero\n"
        "E204 9:1 `t` is reserved: it is time | `t_1` is free\n"
        "E201 12:6 unknown name `q`\n"
        "E202 12:10 unknown function `sinn` | did you mean `sin`?\n"
        "E203 14:9 `x` is already a coordinate | first at line 5\n"
        "E104 15:6 1 component, but a vector has 2 or 3\n");
}

TEST_CASE("checking is deterministic") {
  const std::string chain = model_file("chain");
  CHECK(dump(checked(chain).model) == dump(checked(chain).model));
}

TEST_CASE("a chain of a thousand links is checked in linear time") {
  const std::string chain = model_file("chain");
  seconds_for(chain, 10);
  const double hundred = seconds_for(chain, 100);
  const double thousand = seconds_for(chain, 1000);
  // Processor time in seconds; 0.15 s on an idle machine of 2020, so a sanitizer has some margin.
  CHECK(thousand < 1.5);
  CHECK(thousand < 25 * std::max(hundred, 0.004));
}

TEST_CASE("edited models never crash, and errors always have a position") {
  const std::string original = model_file("cart_pole");
  const std::vector<std::size_t> offsets = offsets_in_strings(original);
  CHECK(rc::check("one byte of a string replaced", [&] {
    std::string text = original;
    text[*rc::gen::elementOf(offsets)] = *rc::gen::elementOf(std::string("abxgm0129+-*/^()[]=., "));
    const SourcePointer source = make_source("m.toml", text);
    const auto syntax = parse_model(source, {});
    if (!syntax) return;
    const auto result = check(*syntax, nullptr, {}, {});
    RC_ASSERT(result.value.has_value() != has_errors(result.diagnostics));
    for (const Diagnostic& diagnostic : result.diagnostics) {
      RC_ASSERT(diagnostic.span.source == source.get());
      RC_ASSERT(diagnostic.span.end <= text.size());
    }
  }));
}

TEST_CASE("cycles are printed from the entry that is declared first") {
  const Rows rows{
      {"[define]\na = \"a + 1\"\n", "E206 13:1 `a` is defined by itself: a -> a\n"},
      {"[define]\nb = \"c\"\nc = \"d\"\nd = \"c + b\"\n",
       "E206 14:1 `c` is defined by itself: c -> d -> c\n"},
      {"[[point]]\nname = \"p\"\nat = [\"x(r)\", \"0\"]\n[[point]]\nname = \"r\"\nat = [\"y(p)\", "
       "\"0\"]\n",
       "E206 13:9 `p` is defined by itself: p -> r -> p\n"},
      {"[define]\na = \"x(p)\"\n[[point]]\nname = \"p\"\nat = [\"a\", \"0\"]\n",
       "E206 13:1 `a` is defined by itself: a -> p -> a\n"},
      {"[define]\na = \"h\"\n[[prescribed]]\nname = \"h\"\nvalue = \"a\"\n",
       "E206 13:1 `a` is defined by itself: a -> h -> a\n"},
  };
  check_rows(rows, [&](const std::string& entries) { return messages(block(entries)); });
}

TEST_CASE("a chain of definitions may be as long as the limit allows") {
  std::string text = block("[define]\nd0 = \"k*0.5\"\n");
  for (int i = 1; i < 19'000; ++i) {
    text += "d" + std::to_string(i) + " = \"d" + std::to_string(i - 1) + "\"\n";
  }
  CheckOptions wanted;
  CHECK(messages(text, wanted).empty());
}

TEST_CASE("a definition may use a later definition") {
  CHECK(messages(block("V = \"a*x\"\n[define]\na = \"b\"\nb = \"k*x\"\n")).empty());
  // The unit of a later definition is known, too.
  CHECK(messages(block("V = \"a*x\"\n[define]\na = \"b\"\nb = \"k\"\n")) ==
        "E403 12:6 `a*x` is in N, but V is in J\n");
}

TEST_CASE("one mistake that is met many times is one message") {
  const SourcePointer source = make_source("m.toml", "abc");
  Report report;
  report.add(Code::E207, {source.get(), 0, 1}, "`x[i]` is `x[4]`");
  report.add(Code::E207, {source.get(), 0, 1}, "`x[i]` is `x[5]`");
  report.add(Code::E207, {source.get(), 1, 2}, "`x[i]` is `x[5]`");
  report.add(Code::E208, {source.get(), 0, 1}, "`x[i]` is `x[5]`");
  CHECK(report.error_count() == 3);
  CHECK(report.sorted_diagnostics().size() == 3);
  CHECK(report.sorted_diagnostics().front().message == "`x[i]` is `x[4]`");
}

TEST_CASE("warnings and notes are not errors") {
  Report report;
  report.add(Code::E518, {}, "a");
  report.add(Code::E520, {}, "b");
  CHECK(report.error_count() == 0);
  CHECK(report.sorted_diagnostics().size() == 2);
}

TEST_CASE("suggestions end after a hundred errors") {
  const SourcePointer source = make_source("m.toml", std::string(200, 'a'));
  Report report;
  for (std::uint32_t i = 0; i < 100; ++i) {
    CHECK(report.needs_suggestion());
    report.add(Code::E201, {source.get(), i, i + 1}, "a");
  }
  CHECK_FALSE(report.needs_suggestion());
}

}  // namespace elgen::test
