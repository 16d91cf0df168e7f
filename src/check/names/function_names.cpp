// function_names: the first columns of three tables.
#include "check/names/function_names.hpp"

#include "elgen/functions.hpp"

namespace elgen {

const std::vector<std::string>& function_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names{
#define ELGEN_EXPANDED(name, rule) #name,
#include "check/names/expanded_functions.def"
#undef ELGEN_EXPANDED
#define ELGEN_COMPOSITE(name, arity, definition, in_space) #name,
#include "check/names/composite_functions.def"
#undef ELGEN_COMPOSITE
    };
    for (const FunctionRow& row : function_table) names.emplace_back(row.name);
    return names;
  }();
  return all;
}

}  // namespace elgen
