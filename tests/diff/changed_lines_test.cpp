// A change of one term in a model changes the header only in the functions whose entries differ.
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "diff/versions.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

struct OneTerm {
  const char* model;
  const char* part;
  const char* other;
  std::size_t max_changed_lines;  ///< limit of changed lines in the header
};

const OneTerm one_terms[]{
    {"cart_pole", "\"-g\"", "\"g\"", 65},
    {"elastic_pendulum", "V = \"1/2*k*", "V = \"k*", 62},
    {"furuta_pendulum", "D = \"1/2*b1*", "D = \"b1*", 151},
    {"motor_pendulum", "D = \"1/2*b*", "D = \"b*", 33},
    {"kepler_polar", "V = \"-mu", "V = \"-2*mu", 52},
};

struct Header {
  std::string text = {};
  std::map<std::string, std::string> functions = {};  ///< function name -> its lines
};

/// The header `name`, split into functions: a function is a paragraph with its comment.
Header header_of(const Products& products, const std::string& name) {
  Header header{products.files->files.at(name + "/" + name + ".hpp")};
  static const std::regex signature(R"((\w+)\(const Parameters<Scalar>&)");
  std::string paragraph;
  const auto close = [&] {
    std::smatch match;
    if (std::regex_search(paragraph, match, signature)) header.functions[match[1]] += paragraph;
    paragraph.clear();
  };
  for (const std::string& line : split_lines(header.text)) {
    paragraph += line + "\n";
    if (line.empty()) close();
  }
  close();
  return header;
}

std::size_t changed_lines(const std::string& before, const std::string& after) {
  const Workspace workspace;
  workspace.write("before", before);
  workspace.write("after", after);
  return count(workspace.run("diff before after | grep '^>'").output, "\n");
}

}  // namespace

TEST_CASE("one term of a model changes only the functions whose entries differ") {
  for (const auto& [model, part, other, most] : one_terms) {
    INFO(model);
    const std::string text = model_file(model);
    const LoweredVersion before = lowered(text, "", Goal::emit);
    const LoweredVersion after = lowered(replaced(text, part, other), "", Goal::emit);
    const Header old = header_of(before.products, model);
    const Header now = header_of(after.products, model);
    std::set<std::string> different{"dynamics"};  // the function that computes all others together
    for (const OutputChange& output : compare(before.version(), after.version()).outputs) {
      const bool differs =
          std::ranges::count(output.entries, EntryVerdict::different, &EntryChange::verdict) > 0;
      if (differs) different.insert(output.name);
    }
    REQUIRE(now.functions.size() > 10);
    for (const auto& [name, lines] : now.functions) {
      INFO(name);
      CHECK((lines == old.functions.at(name) || different.count(name) > 0));
    }
    CHECK(changed_lines(old.text, now.text) <= most);
  }
}
