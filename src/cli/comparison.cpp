// Every step is shown, and timed with the stages of the products.
#include "cli/comparison.hpp"

#include <chrono>

#include "cli/process/progress.hpp"

namespace elgen::cli {

namespace {

template <class Step>
auto timed(const std::string& name, Products& products, const Progress& progress,
           const Step& step) {
  progress.stage(name);
  const auto start = std::chrono::steady_clock::now();
  auto result = step();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  products.times.push_back({name, elapsed.count()});
  return result;
}

/// Compiles the emitted code, unless it is to be quick.
Result<CompiledHeaders> compiled_by(Build build, Products& products, const VerifyOptions& options,
                                    const Limits& limits, const Progress& progress) {
  if (options.quick) return CompiledHeaders();
  const auto& [model, scene] = *products.checked;
  return timed("compile", products, progress, [&, &model = model, &scene = scene] {
    return compile(*products.files, model, scene, *products.program, {limits, build});
  });
}

/// None where it is to be quick.
Result<std::vector<DeclaredNumber>> declared_by(Products& products, const VerifyOptions& options,
                                                const Limits& limits, const Progress& progress) {
  if (options.quick) return std::vector<DeclaredNumber>();
  const auto& [model, scene] = *products.checked;
  return timed("compile", products, progress, [&, &model = model, &scene = scene] {
    return declared_numbers(*products.files, model, scene, *products.program, limits);
  });
}

}  // namespace

Result<Verification> compared(const std::string& path, Products& products,
                              const VerifyOptions& options, const Limits& limits) {
  const Progress progress(path);
  const auto compiled = compiled_by(Build::as_written, products, options, limits, progress);
  if (!compiled) return compiled.diagnostics;
  const auto as_users = compiled_by(Build::as_users, products, options, limits, progress);
  if (!as_users) return as_users.diagnostics;
  const auto declared = declared_by(products, options, limits, progress);
  if (!declared) return declared.diagnostics;
  VerifyOptions verification = options;
  if (!declared->empty()) verification.declared = &*declared;
  verification.forms = &*products.closed_forms;
  verification.parts = &products.parts;
  if (!as_users->empty()) verification.as_users = as_users->front().functions.get();
  verification.on_step = [&progress](const std::string& step) { progress.stage(step); };
  const auto& [model, scene] = *products.checked;
  return timed("verify", products, progress, [&, &model = model, &scene = scene] {
    return verify(model, scene, *products.program, *compiled, verification);
  });
}

}  // namespace elgen::cli
