// A fresh directory that is removed, with all it holds, when its owner goes.
#pragma once

#include <filesystem>
#include <optional>

namespace elgen {

class TemporaryDirectory {
 public:
  /// A new directory, readable by this user alone, under $TMPDIR or /tmp; none where that is not
  /// writable.
  [[nodiscard]] static std::optional<TemporaryDirectory> create();

  TemporaryDirectory(TemporaryDirectory&& other) noexcept;
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
};

}  // namespace elgen
