// A temporary directory is private, distinct, and gone with its owner.
#include "toolchain/temporary_directory.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <utility>

#include "toolchain/environment.hpp"

using elgen::TemporaryDirectory;

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
