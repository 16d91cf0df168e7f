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

/// Whatever the scene's language is, its functions in C++ are screened: no other has numbers of 50
/// digits.
Result<std::unique_ptr<ScreeningCode>> screening_code(const Products& products,
                                                      const Limits& limits) {
  const auto& [model, scene] = *products.checked;
  Scene in_cpp = scene;
  in_cpp.emission.language = LanguageId::cpp;
  in_cpp.emission.eigen = false;
  const Result<EmittedFiles> files = emit(model, in_cpp, *products.program);
  if (!files) return files.diagnostics;
  return compile_screening(*files, model, in_cpp, *products.program, limits);
}

}  // namespace

bool is_screened(const VerifyOptions& options) {
  return options.samples.value_or(0) > most_visited_samples;
}

Result<Screening> screened(const std::string& path, Products& products,
                           const ComparisonOptions& options, const Shard& shard,
                           const Limits& limits) {
  const Progress progress(path);
  const auto code =
      timed("compile", products, progress, [&] { return screening_code(products, limits); });
  if (!code) return code.diagnostics;
  ScreeningOptions screening{options.verify.samples.value_or(0),
                             options.verify.seed,
                             shard,
                             options.jobs,
                             limits.seconds,
                             [&progress](const std::string& step) { progress.stage(step); }};
  const auto& [model, scene] = *products.checked;
  return timed("screen", products, progress, [&, &model = model, &scene = scene] {
    return screen(model, scene, *products.program, **code, screening);
  });
}

Result<Verification> compared(const std::string& path, Products& products,
                              const ComparisonOptions& options, const Limits& limits,
                              const Screening* screening) {
  Result<Screening> own = Screening();
  const bool screens = screening == nullptr && is_screened(options.verify);
  if (screens) own = screened(path, products, options, {}, limits);
  if (!own) return own.diagnostics;
  const Progress progress(path);
  const auto compiled = compiled_by(Build::as_written, products, options.verify, limits, progress);
  if (!compiled) return compiled.diagnostics;
  const auto as_users = compiled_by(Build::as_users, products, options.verify, limits, progress);
  if (!as_users) return as_users.diagnostics;
  const auto declared = declared_by(products, options.verify, limits, progress);
  if (!declared) return declared.diagnostics;
  VerifyOptions verification = options.verify;
  if (!declared->empty()) verification.declared = &*declared;
  verification.forms = &*products.closed_forms;
  verification.parts = &products.parts;
  verification.screening = screens ? &*own : screening;
  if (!as_users->empty()) verification.as_users = as_users->front().functions.get();
  verification.on_step = [&progress](const std::string& step) { progress.stage(step); };
  const auto& [model, scene] = *products.checked;
  return timed("verify", products, progress, [&, &model = model, &scene = scene] {
    return verify(model, scene, *products.program, *compiled, verification);
  });
}

}  // namespace elgen::cli
