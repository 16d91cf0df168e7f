// TemporaryDirectory: mkdtemp under $TMPDIR or /tmp, removed recursively by the destructor. Failing
// to remove is not reported: nothing depends on it. Memory may be short once, where that is why the
// owner goes.
#include "toolchain/temporary_directory.hpp"

#include <cstdlib>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace elgen {

std::optional<TemporaryDirectory> TemporaryDirectory::create() {
  const char* parent = std::getenv("TMPDIR");
  std::string name = (parent != nullptr && *parent != '\0') ? parent : "/tmp";
  name += "/elgen-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) return std::nullopt;
  return TemporaryDirectory(name);
}

TemporaryDirectory::TemporaryDirectory(TemporaryDirectory&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  for (int attempt = 0; attempt < 2 && !path_.empty(); ++attempt) {
    try {
      std::filesystem::remove_all(path_, ignored);
      path_.clear();
    } catch (const std::bad_alloc&) {
    }
  }
}

}  // namespace elgen
