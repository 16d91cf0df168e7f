// SharedArray: memory that this process and those it forks have in common.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace elgen {

/// `size` zeros that forked processes write to and this one reads when they have ended. T is plain
/// data, or a lock-free atomic of it.
template <class T>
class SharedArray {
 public:
  static_assert(std::is_trivially_destructible_v<T>);

  /// Throws std::bad_alloc where there is no such memory.
  explicit SharedArray(std::size_t size) : size_(size) {
    void* const memory = ::mmap(nullptr, size * sizeof(T), PROT_READ | PROT_WRITE,
                                MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    first_ = static_cast<T*>(memory);
  }
  SharedArray(const SharedArray&) = delete;
  SharedArray& operator=(const SharedArray&) = delete;
  ~SharedArray() { ::munmap(first_, size_ * sizeof(T)); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return first_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return first_[i]; }

 private:
  T* first_ = nullptr;
  std::size_t size_;
};

}  // namespace elgen
