// Batches: the accuracy that a scene asks for has to be within what the scalars can give.
#include "check/scene/read_batch.hpp"

#include <algorithm>

#include "base/exact_number.hpp"
#include "check/expressions/values.hpp"
#include "elgen/wording.hpp"

namespace elgen {

cln::cl_RA trigonometry_error(const Numerics& numerics, ScalarKind scalar) {
  const bool is_single = scalar == ScalarKind::single_precision;
  return numerics.trigonometry_error.value_or(cln::expt(cln::cl_RA(2), is_single ? -23 : -52));
}

namespace {

bool has_scalar(const Scene& scene, ScalarKind kind) {
  return std::ranges::count(scene.numerics.scalars, kind) > 0;
}

class BatchReader {
 public:
  BatchReader(Context& context, const FileSyntax* syntax, Scene& scene)
      : context_(context), syntax_(syntax), scene_(scene) {}

  void read() {
    const KeySyntax* batch = find_key(syntax_, "emit", "batch");
    scene_.emission.batch = batch != nullptr && batch->value.boolean;
    if (scene_.emission.batch) check_scalars(*batch);
    const KeySyntax* trigonometry = find_key(syntax_, "numeric", "trigonometry");
    if (trigonometry != nullptr) read_accuracy(*trigonometry);
  }

 private:
  void refuse(const Span& span, std::string message, std::string hint = {}) {
    context_.report.add(Code::E625, span, std::move(message), std::move(hint));
  }

  void check_scalars(const KeySyntax& batch) {
    if (scene_.emission.language != LanguageId::cpp) {
      context_.report.add(Code::E611, batch.key_span,
                          "`batch` needs C++, and `language` is " +
                              in_backticks(language_row(scene_.emission.language).name));
    } else if (has_scalar(scene_, ScalarKind::long_double)) {
      refuse(find_key(syntax_, "numeric", "scalar")->value.span,
             "packs have elements of type `float` or `double`");
    }
  }

  void read_accuracy(const KeySyntax& trigonometry) {
    if (!scene_.emission.batch) {
      return refuse(trigonometry.key_span,
                    "polynomials for sine and cosine are used in batches alone",
                    "`[emit] batch = true` adds functions on arrays of states");
    }
    const KeySyntax* key = trigonometry.value.find("max_error");
    if (key == nullptr) return;
    const auto wanted = ValueReader(context_, Scope(context_.sizes)).constant(key->value);
    if (!wanted) return;
    const bool has_float = has_scalar(scene_, ScalarKind::single_precision);
    const ScalarKind coarsest =
        has_float ? ScalarKind::single_precision : ScalarKind::double_precision;
    const bool is_within = is_rational(*wanted) && *wanted < 1 &&
                           *wanted >= trigonometry_error(scene_.numerics, coarsest);
    if (!is_within) {
      return refuse(key->value.span,
                    has_float ? "`max_error` in float is at least 2^-23 = 1.2e-7, and below 1"
                              : "`max_error` is at least 2^-52 = 2.3e-16, and below 1");
    }
    scene_.numerics.trigonometry_error = cln::rational(*wanted);
  }

  Context& context_;
  const FileSyntax* syntax_;
  Scene& scene_;
};

}  // namespace

void read_batch(Context& context, const FileSyntax* syntax, Scene& scene) {
  BatchReader(context, syntax, scene).read();
}

}  // namespace elgen
