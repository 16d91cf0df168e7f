// Artifacts: the kinds of files that elgen writes (artifacts.def), and the artifacts of a scene.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/scene.hpp"

namespace elgen {

enum class ArtifactId : std::uint8_t {
#define ELGEN_ARTIFACT(kind) kind,
#include "elgen/artifacts.def"
};

/// One Row per kind of file, in a member with the name of the kind.
template <class Row>
struct ArtifactTable {
#define ELGEN_ARTIFACT(kind) Row kind;
#include "elgen/artifacts.def"

  [[nodiscard]] constexpr const Row& operator[](ArtifactId id) const {
    constexpr Row ArtifactTable::*members[] = {
#define ELGEN_ARTIFACT(kind) &ArtifactTable::kind,
#include "elgen/artifacts.def"
    };
    return this->*members[static_cast<std::size_t>(id)];
  }
};

struct ArtifactRow {
  std::string_view path_suffix;  ///< end of the path; empty: the file extension of the language
  bool (*is_requested)(const Scene& scene);
};

inline constexpr ArtifactTable<ArtifactRow> artifact_table{
    .cpp = {".hpp", [](const Scene& s) { return s.emission.language == LanguageId::cpp; }},
    .eigen = {"_eigen.hpp", [](const Scene& s) { return s.emission.has_eigen_header; }},
    .batch = {"_batch.hpp", [](const Scene& s) { return s.emission.has_batch_header; }},
    .wide = {"_wide.hpp", [](const Scene& s) { return s.numerics.inner != InnerScalar::same; }},
    .c99 = {".h", [](const Scene& s) { return s.emission.language == LanguageId::c99; }},
    .source = {"", [](const Scene& s) { return language_row(s.emission.language).is_interpreted; }},
    .sidecar = {".equations.json", [](const Scene& s) { return s.emission.has_sidecar; }},
    .page = {".md", [](const Scene& s) { return s.emission.has_page; }}};

struct Artifact {
  ArtifactId id = ArtifactId::cpp;
  std::string path = {};  ///< "cart_pole/cart_pole.hpp", relative to the output folder
};

/// The artifacts that the scene requests, in the order of the table. Needs no derivation.
[[nodiscard]] std::vector<Artifact> requested_artifacts(const Scene& scene);

[[nodiscard]] std::string artifact_path(const Scene& scene, ArtifactId id);

}  // namespace elgen
