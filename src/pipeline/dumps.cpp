// dumps: each from those of the nouns it is made of.
#include "pipeline/dumps.hpp"

namespace elgen {

std::string dump(const Syntaxes& syntaxes) {
  return dump(syntaxes.model) + (syntaxes.scene ? dump(*syntaxes.scene) : "");
}

std::string dump(const CheckedModel& checked) { return dump(checked.model) + dump(checked.scene); }

std::string dump(const Inspection& inspection) { return format(inspection.found); }

std::string dump(const ReadableSteps& steps) { return dump(steps.program); }

std::string dump(const SelfCheck& check) { return receipt(check) + "\n"; }

}  // namespace elgen
