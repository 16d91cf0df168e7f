// Wording: user text on one line, counts, suggestions of near misses only.
#include "elgen/wording.hpp"

#include <catch2/catch.hpp>

#include "elgen/diagnostic.hpp"

using namespace elgen;

TEST_CASE("user text is made fit for a message") {
  CHECK(in_backticks("m") == "`m`");
  CHECK(in_backticks(std::string_view("\0", 1)) == "`U+0000`");
  CHECK(in_backticks("\x7F") == "`U+007F`");
  CHECK(in_backticks("a\n\t  + b") == "`a + b`");
  CHECK(in_backticks("a\r\nb") == "`a b`");
}

TEST_CASE("long text is cut between characters, and where it is no UTF-8") {
  CHECK(in_backticks(std::string(60, 'a')) == "`" + std::string(60, 'a') + "`");
  CHECK(in_backticks(std::string(61, 'a')) == "`" + std::string(60, 'a') + "…`");
  CHECK(in_backticks(std::string(59, 'a') + "éé") == "`" + std::string(59, 'a') + "é…`");
  CHECK(in_backticks("a\xFF") == "`a…`");
}

TEST_CASE("a span is quoted with the text it covers") {
  const SourcePointer source = make_source("m.toml", "a +\n b");
  CHECK(in_backticks(Span{source.get(), 0, 6}) == "`a + b`");
}

TEST_CASE("nouns are counted") {
  CHECK(counted(1, "component") == "1 component");
  CHECK(counted(0, "component") == "0 components");
}

TEST_CASE("suggestions are questions or nothing") {
  CHECK(suggestion("mas", {"mass", "force"}) == "did you mean `mass`?");
  CHECK(suggestion("zzz", {"mass"}).empty());
}

TEST_CASE("the nearest candidate is suggested") {
  const std::vector<std::string> names{"theta", "mass_matrix", "m", "omega", "coordinate"};
  CHECK(nearest("thta", names) == "theta");
  CHECK(nearest("theat", names) == "theta");  // a transposition is one slip
  CHECK(nearest("mas_matrx", names) == "mass_matrix");
  CHECK(nearest("mq", names) == "m");
  CHECK(nearest("coordinates", names) == "coordinate");
}

TEST_CASE("nothing is suggested where nothing is near") {
  CHECK(nearest("velocity", {"theta", "m"}).empty());
  CHECK(nearest("q", {"x", "y"}).empty());
  CHECK(nearest("", {"a"}).empty());
  CHECK(nearest(std::string(100, 'a'), {std::string(99, 'a')}).empty());
}

TEST_CASE("of equally near candidates the first is taken") {
  CHECK(nearest("ac", {"ab", "ad"}) == "ab");
}
