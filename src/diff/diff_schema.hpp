// diff_schema: what to_json(DiffReport) gives, as JSON Schema.
#pragma once

#include <string>

namespace elgen {

[[nodiscard]] std::string diff_schema();

}  // namespace elgen
