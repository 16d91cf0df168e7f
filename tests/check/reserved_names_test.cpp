// Names of functions, and those that a model may not give to its entries.
#include "check/names/reserved_names.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace elgen::test {

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

TEST_CASE("a name is held against both rules") {
  const auto answer = [](const std::string& name) {
    Report report;
    const bool good = check_name(name, {}, report);
    return good ? std::string() : report.sorted().front().message;
  };
  CHECK(answer("q1").empty());
  CHECK(answer("1q") == "`1q` is not letters, digits and underscores after a letter");
  CHECK(answer("double") == "`double` is reserved: it is a keyword of C++");
}

TEST_CASE("functions of each table are known, and each once") {
  std::vector<std::string> names = function_names();
  for (const char* name : {"dot", "dist2", "sqrt", "sin", "atan2"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

}  // namespace elgen::test
