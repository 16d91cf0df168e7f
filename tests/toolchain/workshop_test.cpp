// A workshop builds drivers beside the headers they include, and leaves nothing: its directory is
// private, distinct, and gone with its owner.
#include "toolchain/workshop.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <utility>

#include "toolchain/environment.hpp"

using elgen::TemporaryDirectory;
using elgen::Workshop;

namespace {

const elgen::Driver answer_driver{"", "driver.cpp", "#include \"a/a.hpp\"\n"};

elgen::EmittedFiles answer_files() {
  return {{{"a/a.hpp", "extern \"C\" int answer(); extern \"C\" int answer() { return 42; }\n"}}};
}

}  // namespace

TEST_CASE("what is built stays loaded, and its files are gone") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const ScopedVariable variable("TMPDIR", scratch->path().string());
  auto library = [] {
    const auto workshop = Workshop::open(answer_files(), {answer_driver}, {});
    REQUIRE(workshop);
    return workshop->build(answer_driver, elgen::Build::as_users);
  }();
  REQUIRE(library);
  CHECK(std::filesystem::is_empty(scratch->path()));
  const auto answer = library->find<int (*)()>("answer");
  REQUIRE(answer != nullptr);
  CHECK(answer() == 42);
  CHECK(library->find<int (*)()>("question") == nullptr);
}

TEST_CASE("without room there is E706, without a compiler E704") {
  const auto code_of = [] {
    const auto workshop = Workshop::open(answer_files(), {answer_driver}, {});
    REQUIRE_FALSE(workshop);
    CHECK(elgen::exit_code(workshop.diagnostics) == elgen::ExitCode::inaccessible);
    return workshop.diagnostics.front().code;
  };
  {
    const ScopedVariable variable("TMPDIR", "/nonexistent/elgen");
    CHECK(code_of() == elgen::Code::E706);
  }
  const ScopedVariable variable("CXX", "/nonexistent/c++");
  CHECK(code_of() == elgen::Code::E704);
}

TEST_CASE("a driver whose library is not installed is no fault of the emitted code") {
  elgen::Driver lacking{"", "lacking.cpp", "#include <elgen/no/such.hpp>\n", "elgen/no/such.hpp"};
  const auto workshop = Workshop::open(answer_files(), {lacking}, {});
  REQUIRE(workshop);
  const auto library = workshop->build(lacking, elgen::Build::as_written);
  REQUIRE_FALSE(library);
  CHECK(library.diagnostics.front().code == elgen::Code::E709);
}

TEST_CASE("a temporary directory is removed with everything in it") {
  std::filesystem::path path;
  {
    const auto directory = TemporaryDirectory::create();
    REQUIRE(directory);
    path = directory->path();
    std::filesystem::create_directory(path / "inner");
    std::ofstream(path / "inner" / "file") << "text";
    CHECK(std::filesystem::exists(path / "inner" / "file"));
  }
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("a temporary directory is readable by its user alone") {
  const auto directory = TemporaryDirectory::create();
  REQUIRE(directory);
  struct stat status {};
  REQUIRE(stat(directory->path().c_str(), &status) == 0);
  CHECK((status.st_mode & 0777U) == 0700U);
}

TEST_CASE("a moved directory is removed once, by its new owner") {
  auto first = TemporaryDirectory::create();
  auto second = TemporaryDirectory::create();
  REQUIRE((first && second));
  CHECK(first->path() != second->path());
  const auto path = first->path();
  {
    const TemporaryDirectory owner(std::move(*first));
    first.reset();
    CHECK(std::filesystem::exists(path));
  }
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("a directory that cannot be made is no directory") {
  const ScopedVariable variable("TMPDIR", "/nonexistent/elgen");
  CHECK_FALSE(TemporaryDirectory::create());
}
