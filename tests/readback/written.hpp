// Files as they would be written, with what they were made of, for tests that change them.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "elgen/pipeline.hpp"
#include "support/shell.hpp"

namespace elgen::test {

struct Written {
  CheckedModel checked;
  Program program;
  std::vector<SourcePointer> files;
};

inline Written written(const Inputs& inputs) {
  PipelineOptions options;
  options.goals = {"readback"};
  Products products = run_pipeline(inputs, options);
  if (!products.readback) throw std::runtime_error(format(products.diagnostics));
  return {std::move(*products.checked), std::move(*products.program), std::move(products.written)};
}

/// Of a model's text, and of the lines of a scene behind its name.
inline Written written(const std::string& model, const std::string& scene = "") {
  Inputs inputs{make_source("test.toml", model), nullptr};
  if (!scene.empty()) {
    inputs.scene = make_source("test.scene.toml",
                               "format = 1\nmodel = \"test.toml\"\nname = \"scene\"\n" + scene);
  }
  return written(inputs);
}

/// The file whose path ends so.
inline const SourcePointer& file_of(const Written& all, const std::string& ending) {
  const auto found = std::find_if(all.files.begin(), all.files.end(), [&](const SourcePointer& f) {
    return f->path.ends_with(ending);
  });
  if (found == all.files.end()) throw std::runtime_error("no file " + ending);
  return *found;
}

/// What reading back says where one file has another text. The files are kept by `sources`.
inline Diagnostics read_changed(const Written& all, const std::string& ending,
                                const std::string& text, std::vector<SourcePointer>& sources) {
  sources.clear();
  for (const SourcePointer& file : all.files) {
    sources.push_back(file->path.ends_with(ending) ? make_source(file->path, text) : file);
  }
  return read_back(sources, all.checked, all.program).diagnostics;
}

}  // namespace elgen::test
