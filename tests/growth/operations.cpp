// Replaces the program's allocation functions, and defines the function that g++ and clang++ call
// in every block under -fsanitize-coverage=trace-pc.
#include "growth/operations.hpp"

#include <cln/malloc.h>

#include <cstdlib>
#include <new>

namespace {

elgen::test::Operations counts;

void* counted_memory(std::size_t size) {
  counts.bytes += size;
  return std::malloc(size);
}

/// CLN allocates its numbers without operator new.
const bool counts_numbers = (cln::malloc_hook = counted_memory, true);

}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = counted_memory(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

extern "C" {
#if defined(__clang__)
__attribute__((no_sanitize("coverage")))
#else
__attribute__((no_sanitize_coverage))
#endif
void __sanitizer_cov_trace_pc() {
  ++counts.blocks;
}
}

namespace elgen::test {

Operations operations() { return counts; }

}  // namespace elgen::test
