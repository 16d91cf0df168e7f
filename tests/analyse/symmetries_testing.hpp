// Helpers of the tests of symmetries: find the symmetries of a model and compare their formulas
// with formulas of the model language.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elgen/analysis_pages.hpp"
#include "elgen/page.hpp"
#include "pipeline/pipeline_testing.hpp"
#include "support/models.hpp"

namespace elgen::test {

/// The text of the model `name` in tests/analyse/symmetries/ or, if no file is there, in models/.
inline std::string symmetric_model(const std::string& name) {
  const std::filesystem::path own =
      std::filesystem::path(ELGEN_SOURCE_DIR) / "tests/analyse/symmetries" / (name + ".toml");
  return std::filesystem::exists(own) ? read_text(own) : model_file(name);
}

/// The model with `end` instead of its [[expect]] tables, which come last.
inline std::string ending(const std::string& model, const std::string& end) {
  return model.substr(0, model.find("\n[[expect]]")) + "\n" + end;
}

class FoundSymmetries {
 public:
  explicit FoundSymmetries(std::string text, const std::vector<std::string>& fixed = {})
      : text_(std::move(text)) {
    for (const std::string& word : fixed) options_.fixed.push_back(make_source("--fix", word));
    Products products = products_with(&Products::symmetries, inputs_of(text_),
                                      {.scene = options_, .goals = {Goal::symmetries}});
    checked_ = std::move(*products.checked);
    found_ = std::move(*products.symmetries);
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const CheckedModel& checked() const { return checked_; }
  [[nodiscard]] const Symmetries& found() const { return found_; }
  [[nodiscard]] const std::vector<Symmetry>& all() const { return found_.symmetries; }
  [[nodiscard]] std::string page() const { return text_of(symmetries_page(checked_, found_)); }
  [[nodiscard]] nlohmann::json json() const {
    return nlohmann::json::parse(symmetries_json(checked_, found_));
  }

  /// The closed form of `formula`, which may contain leaves of the model, momenta p and energy E.
  Fraction form(const std::string& formula) {
    const CheckedModel reading =
        checked_model(ending(text_, "[[expect]]\nconserved = [\"" + formula + "\"]\n"), options_);
    const std::optional<Fraction> result =
        closed_form(found_.forms, reading.model, reading.scene.specialisation.fixed,
                    reading.model.expectations.back().entries.front());
    INFO(formula);
    REQUIRE(result);
    return *result;
  }

  bool equals(const std::optional<Fraction>& x, const std::string& formula) {
    return x && is_proved_equal(found_.forms, *x, form(formula));
  }

  /// The symmetry with I + F = `integral`.
  const Symmetry& symmetry_with(const std::string& integral) {
    const Fraction wanted = form(integral);
    const Symmetry* result = nullptr;
    for (const Symmetry& symmetry : found_.symmetries) {
      if (is_proved_equal(found_.forms, symmetry.momentum_form, wanted)) result = &symmetry;
    }
    INFO(integral << "\n" << page());
    REQUIRE(result != nullptr);
    return *result;
  }

 private:
  std::string text_;
  SceneOptions options_ = {};
  CheckedModel checked_ = {};
  Symmetries found_ = {};
};

}  // namespace elgen::test
