// Workshop: a temporary directory with emitted headers and drivers in it, and the user's compiler.
#pragma once

#include "elgen/emitted_files.hpp"
#include "elgen/limits.hpp"
#include "toolchain/compiler.hpp"
#include "toolchain/library.hpp"
#include "toolchain/temporary_directory.hpp"

namespace elgen {

/// Its directory goes with it, what it loaded stays. Whoever opens one holds NoInterrupts.
class Workshop {
 public:
  /// E704 without a compiler, E706 without room, E909 where the compiler does not answer.
  [[nodiscard]] static Result<Workshop> open(const EmittedFiles& files,
                                             const std::vector<Driver>& drivers,
                                             const Limits& limits);

  /// One of the drivers, compiled and loaded. E705, E709 and E909 as of `compile`.
  [[nodiscard]] Result<Library> build(const Driver& driver, Build build) const;

 private:
  Workshop(TemporaryDirectory directory, Compiler compiler)
      : directory_(std::move(directory)), compiler_(std::move(compiler)) {}

  TemporaryDirectory directory_;
  Compiler compiler_;
};

/// E705: a symbol of the driver is not in what was loaded.
[[nodiscard]] Diagnostic missing_function();

}  // namespace elgen
