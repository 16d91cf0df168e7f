// Names: names of functions, names reserved for other meanings, and names declared by a model.
#include <algorithm>
#include <catch2/catch.hpp>

#include "check/names/reserved_names.hpp"
#include "check/names/symbols.hpp"

namespace elgen::test {

namespace {

std::string only_message(const Report& report) {
  REQUIRE(report.sorted_diagnostics().size() == 1);
  const Diagnostic error = report.sorted_diagnostics().front();
  return std::string(code_row(error.code).name) + " " + error.message;
}

}  // namespace

TEST_CASE("names with another meaning are reserved") {
  for (const char* name :
       {"t",   "pi",       "sin",      "atan2",  "max",   "sqrt",   "dot",      "sum",  "delta",
        "v2",  "dist2",    "double",   "class",  "and",   "xor_eq", "co_await", "I",    "M_PI",
        "NAN", "INFINITY", "HUGE_VAL", "FP_NAN", "errno", "linux",  "a__b",     "isnan"}) {
    INFO(name);
    CHECK_FALSE(reserved_reason(name).empty());
  }
  for (const char* name : {"SNANF64", "CHAR_BIT", "LONG_MAX", "ERANGE", "SIGINT", "EIGEN_PI",
                           "stdin", "unix", "BUFSIZ", "PRIX64", "FE_ALL_EXCEPT", "HUGE"}) {
    INFO(name);
    CHECK(reserved_reason(name) == "it is a macro of C or C++");
  }
  CHECK(reserved_reason("int") == "it is a keyword of C++");
  CHECK(reserved_reason("M_E") == "it is a macro of C or C++");
  CHECK(reserved_reason("ELGEN_FUNCTION") == "it is a macro of C or C++");
}

TEST_CASE("usual names of mechanics are free") {
  for (const char* name : {"M",     "g",   "x",     "y", "z", "m", "J", "C",   "e",  "q",  "u",
                           "theta", "tau", "gamma", "T", "V", "L", "D", "a_b", "Ix", "std"}) {
    INFO(name);
    CHECK(reserved_reason(name).empty());
  }
}

TEST_CASE("names are letters, digits and underscores after a letter") {
  CHECK(is_well_formed_name("q1_a"));
  for (const char* name : {"", "1q", "_q", "q-1", "q.x", "q ", "ä"}) {
    INFO(name);
    CHECK_FALSE(is_well_formed_name(name));
  }
}

TEST_CASE("a name is checked against both rules") {
  const auto answer = [](const std::string& name) {
    Report report;
    const bool good = check_name(name, {}, report);
    return good ? std::string() : report.sorted_diagnostics().front().message;
  };
  CHECK(answer("q1").empty());
  CHECK(answer("1q") ==
        "`1q` is no name: a name is a letter, then letters, digits and underscores");
  CHECK(answer("double") == "`double` is reserved: it is a keyword of C++");
}

TEST_CASE("a free alternative is suggested for a reserved name") {
  const auto suggested_name = [](const std::string& name, const std::string& text = "") {
    const SourcePointer source = make_source("m.toml", text);
    return free_name_hint(name, {source.get(), 0, 0});
  };
  CHECK(free_name_hint("I", {}) == "`J` is free");
  CHECK(suggested_name("delta") == "`delta_1` is free");
  CHECK(suggested_name("delta", "delta_1 = 2\ndelta_20 = 3\n") == "`delta_2` is free");
  CHECK(suggested_name("I", "J = 2\n") == "`I_1` is free");
  CHECK(suggested_name("I", "k = { unit = \"J\" }\nIJ = 3\n") == "`J` is free");
  CHECK(suggested_name("M_E") == "`m_e` is free");
  CHECK(suggested_name("a__b") == "`a_b` is free");
  CHECK(suggested_name("M__", "m = 1\n") == "`m_1` is free");
  for (const char* name : {"t", "pi", "int", "INT_MAX", "EIGEN_PI", "x__", "linux", "signgam"}) {
    const std::string offered = suggested_name(name);
    INFO(offered);
    CHECK(reserved_reason(offered.substr(1, offered.find('`', 1) - 1)).empty());
  }
}

TEST_CASE("functions of each table are found, and their names are unique") {
  std::vector<std::string> names = function_names();
  for (const char* name : {"dot", "dist2", "sqrt", "sin", "atan2", "sinc", "stumpff"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("elements of an array are declared one by one") {
  SymbolTable symbols;
  Report report;
  CHECK(symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 0, report));
  CHECK(symbols.declare({"q", 2, {}}, SymbolKind::coordinate, 1, report));
  const DeclaredName* q = symbols.find("q");
  REQUIRE(q != nullptr);
  CHECK(q->is_array);
  CHECK(q->elements.at(2) == 1);
  CHECK_FALSE(symbols.declare({"q", 2, {}}, SymbolKind::coordinate, 2, report));
  CHECK(only_message(report) == "E203 `q[2]` is already a coordinate");
}

TEST_CASE("all kinds share one namespace") {
  SymbolTable symbols;
  Report report;
  CHECK(symbols.declare({"a", {}, {}}, SymbolKind::input, 0, report));
  CHECK_FALSE(symbols.declare({"a", {}, {}}, SymbolKind::point, 0, report));
  CHECK(only_message(report) == "E203 `a` is already an input");
}

TEST_CASE("a single name and an array cannot share it") {
  SymbolTable symbols;
  Report report;
  CHECK(symbols.declare({"a", {}, {}}, SymbolKind::point, 0, report));
  CHECK_FALSE(symbols.declare({"a", 1, {}}, SymbolKind::point, 1, report));
  CHECK(only_message(report) == "E203 `a[1]` is already a point");
}

TEST_CASE("names that become the same identifier get another error than duplicates") {
  SymbolTable symbols;
  Report report;
  CHECK(symbols.declare({"q_1", {}, {}}, SymbolKind::parameter, 0, report));
  CHECK_FALSE(symbols.declare({"q", 1, {}}, SymbolKind::coordinate, 0, report));
  CHECK(only_message(report) == "E211 `q[1]` and `q_1` both become `q_1` in code");
}

TEST_CASE("a reserved or malformed name fails and is recorded as failed") {
  SymbolTable symbols;
  Report report;
  CHECK_FALSE(symbols.declare({"double", {}, {}}, SymbolKind::parameter, 0, report));
  CHECK(only_message(report) == "E204 `double` is reserved: it is a keyword of C++");
  CHECK(symbols.has_failed("double"));
  CHECK(symbols.find("double") == nullptr);
  Report second;
  CHECK_FALSE(symbols.declare({"p", -1, {}}, SymbolKind::point, 0, second));
  CHECK(only_message(second).substr(0, 4) == "E205");
}

TEST_CASE("a duplicate points to the first declaration, and a suggestion gives its kind") {
  const SourcePointer source = make_source("m.toml", "\nmass\nmass");
  SymbolTable symbols;
  Report report;
  symbols.declare({"mass", {}, {source.get(), 1, 5}}, SymbolKind::parameter, 0, report);
  CHECK(symbols.suggest("mas", symbols.names()) == "did you mean `mass`? (parameter, line 2)");
  CHECK(symbols.suggest("mas", symbols.names({SymbolKind::point})).empty());
  CHECK(symbols.suggest("pj", {"pi"}) == "did you mean `pi`?");
  symbols.declare({"mass", {}, {source.get(), 6, 10}}, SymbolKind::point, 0, report);
  const Diagnostic error = report.sorted_diagnostics().front();
  REQUIRE(error.related);
  CHECK(error.related->begin == 1);
  CHECK(error.hint == "first at line 2");
}

}  // namespace elgen::test
