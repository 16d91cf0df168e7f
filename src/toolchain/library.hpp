// Library: a shared object that is loaded as long as its owner lives.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <utility>

namespace elgen {

class Library {
 public:
  explicit Library(const std::filesystem::path& object)
      : handle_(dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL)) {}
  Library(Library&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library& operator=(Library&&) = delete;
  ~Library() {
    if (handle_ != nullptr) dlclose(handle_);
  }

  [[nodiscard]] bool loaded() const { return handle_ != nullptr; }

  /// Null where there is no such symbol. Function: a pointer to what it is.
  template <class Function>
  [[nodiscard]] Function find(const std::string& symbol) const {
    return reinterpret_cast<Function>(dlsym(handle_, symbol.c_str()));
  }

 private:
  void* handle_;
};

}  // namespace elgen
