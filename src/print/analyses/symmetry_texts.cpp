// A claim says what is conserved, by which evidence, and whether these are all symmetries.
#include <fmt/format.h>

#include <algorithm>

#include "analyse/leaf_search.hpp"
#include "print/analyses/page_parts.hpp"

namespace elgen {
namespace {

std::string sampled(const Symmetries& symmetries) {
  return fmt::format("sampled at {} states in 160 digits", symmetries.states);
}

/// "conserved: proved; "
std::string verdict(const Symmetries& symmetries) {
  if (symmetries.all.empty()) return {};
  const bool are_proved = std::ranges::all_of(symmetries.all, &Symmetry::is_proved);
  const bool is_free = std::ranges::all_of(symmetries.all, is_nothing, &Symmetry::rate);
  return fmt::format("{}: {}; ", is_free ? "conserved" : "conserved where d/dt is 0",
                     are_proved            ? "proved"
                     : symmetries.is_exact ? "dL = dF/dt is proved"
                                           : sampled(symmetries));
}

}  // namespace

const char* name_of(SymmetryKind kind) {
  switch (kind) {
    case SymmetryKind::coordinate:
    case SymmetryKind::translation:
      return "translation";
    case SymmetryKind::boost:
      return "boost";
    case SymmetryKind::rotation:
      return "rotation";
    case SymmetryKind::turn:
      return "turn";
    case SymmetryKind::other:
      return "other";
    case SymmetryKind::time:
      return "time";
  }
  return "";
}

std::string claim_of(const Symmetries& symmetries) {
  const std::size_t count = symmetries.all.size();
  if (!symmetries.is_exact && symmetries.states == 0) {
    return "not decided: no state within the ranges has a value";
  }
  const std::string unknowns = fmt::format("{} unknowns", symmetries.unknowns);
  const std::string subject = count == 0 ? "there are none" : "these are all";
  const bool is_generic = symmetries.sampled_elsewhere == count &&
                          std::ranges::none_of(symmetries.all, &Symmetry::is_special);
  const bool agrees = symmetries.states > 0 && symmetries.sampled == count;
  std::string line = verdict(symmetries);
  if (symmetries.is_complete) {
    line += fmt::format("{} of this form ({}, exactly)", subject, unknowns);
  } else if (is_generic) {
    line += fmt::format("{} of this form ({}, sampled)", subject, unknowns);
  } else if (agrees) {
    line += fmt::format("{} of this form at the values of the parameters ({}, sampled)", subject,
                        unknowns);
  } else {
    line += fmt::format("these are at least those of this form ({})", unknowns);
  }
  if (symmetries.states == 0 || agrees) return line;
  return line + fmt::format("; at the values of the parameters there {} {} ({})",
                            symmetries.sampled == 1 ? "is" : "are", symmetries.sampled,
                            sampled(symmetries));
}

std::vector<std::string> stated_integrals(const CheckedModel& checked, PageForms& known,
                                          const Symmetries& symmetries) {
  std::vector<std::string> result;
  if (!checked.scene.canonical.empty()) return result;
  Arithmetic arithmetic(known.forms.algebra);
  LeafSearch quaternions(known.forms.algebra, [&known](const Atom& leaf) {
    return leaf.leaf == Opcode::coordinate && known.model.coordinates[leaf.index].rotation;
  });
  for (const Symmetry& symmetry : symmetries.all) {
    if (symmetry.is_special || !symmetry.total || !is_nothing(symmetry.loss)) continue;
    const Value whole = arithmetic.subtract(symmetry.by_names, *symmetry.total);
    if (!whole || quaternions.holds(*whole)) continue;
    if (const auto formula = known.read(whole)) result.push_back(text_of(*formula));
  }
  return result;
}

}  // namespace elgen
