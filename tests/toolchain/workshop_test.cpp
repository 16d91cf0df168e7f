// A compiler session builds drivers next to the headers that the drivers include. A temporary
// directory is private and unique, and the destructor of its owner removes the directory.
#include "toolchain/workshop.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <utility>

#include "toolchain/environment.hpp"

using elgen::CompilerSession;
using elgen::TemporaryDirectory;

namespace {

const elgen::SourceFile answer_source{"driver.cpp", "#include \"a/a.hpp\"\n"};

elgen::EmittedFiles answer_files() {
  return {{{"a/a.hpp", "extern \"C\" int answer(); extern \"C\" int answer() { return 42; }\n"}}};
}

}  // namespace

TEST_CASE("a built library stays loaded after its files are removed") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const ScopedVariable variable("TMPDIR", scratch->path().string());
  auto library_dictionary = [] {
    const auto workshop = CompilerSession::open(answer_files(), {answer_source}, {});
    REQUIRE(workshop);
    return workshop->build(answer_source, elgen::BuildFlags::user_flags);
  }();
  REQUIRE(library_dictionary);
  CHECK(std::filesystem::is_empty(scratch->path()));
  const auto answer = library_dictionary->find<int (*)()>("answer");
  REQUIRE(answer != nullptr);
  CHECK(answer() == 42);
  CHECK(library_dictionary->find<int (*)()>("question") == nullptr);
}

TEST_CASE("without disk space the error is E706, without a compiler E704") {
  const auto code_of = [] {
    const auto workshop = CompilerSession::open(answer_files(), {answer_source}, {});
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

TEST_CASE("a library that does not compile is not reported as an error of the emitted code") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  std::ofstream(scratch->path() / "elgen_broken.hpp") << "#error \"broken\"\n";
  const ScopedVariable variable("CPATH", scratch->path().string());
  const elgen::SourceFile broken{"broken.cpp", "#include <elgen_broken.hpp>\n", "elgen_broken.hpp"};
  const auto workshop = CompilerSession::open(answer_files(), {broken}, {});
  REQUIRE(workshop);
  const auto library = workshop->build(broken, elgen::BuildFlags::as_written);
  REQUIRE_FALSE(library);
  CHECK(library.diagnostics.front().code == elgen::Code::E709);
}

TEST_CASE(
    "a compiler that refuses the flags of a build is distinguished from one that accepts them") {
  const auto scratch = elgen::TemporaryDirectory::create();
  REQUIRE(scratch);
  const auto script = scratch->path() / "compiler";
  std::ofstream(script) << "#!/bin/sh\ncase \"$*\" in *-march=native*) exit 1 ;; esac\n"
                        << "exec c++ \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const ScopedVariable variable("CXX", script.string());
  const auto workshop = CompilerSession::open(answer_files(), {answer_source}, {});
  REQUIRE(workshop);
  CHECK(workshop->accepts_flags(elgen::BuildFlags::as_written, answer_source));
  CHECK_FALSE(workshop->accepts_flags(elgen::BuildFlags::native, answer_source));
}

TEST_CASE("a temporary directory is removed with its contents") {
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

TEST_CASE("a temporary directory is readable only by its user") {
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

TEST_CASE("a directory that cannot be created has no value") {
  const ScopedVariable variable("TMPDIR", "/nonexistent/elgen");
  CHECK_FALSE(TemporaryDirectory::create());
}
