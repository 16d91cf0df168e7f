// Artifacts: the kinds of files that are written, and which of them a scene wants. What is known of
// a kind elsewhere is a row by its id: how it is written (src/emit/artifacts.cpp), read back
// (src/readback/readback.cpp), and compiled (src/toolchain/driver.cpp).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "elgen/scene.hpp"

namespace elgen {

/// Headers, then what they are described by.
enum class ArtifactId : std::uint8_t { cpp, eigen, c99, sidecar, page };

struct ArtifactRow {
  ArtifactId id;
  std::string_view ending;  ///< of the path
  bool (*is_wanted)(const Emission& emission);
};

inline constexpr std::array artifact_table{
    ArtifactRow{ArtifactId::cpp, ".hpp",
                [](const Emission& e) { return e.language == LanguageId::cpp; }},
    ArtifactRow{ArtifactId::eigen, "_eigen.hpp", [](const Emission& e) { return e.eigen; }},
    ArtifactRow{ArtifactId::c99, ".h",
                [](const Emission& e) { return e.language == LanguageId::c99; }},
    ArtifactRow{ArtifactId::sidecar, ".equations.json", [](const Emission&) { return true; }},
    ArtifactRow{ArtifactId::page, ".md", [](const Emission&) { return true; }}};

/// One row of a table by id, which has a row of every kind in their order.
template <class Row>
using PerArtifact = std::array<Row, artifact_table.size()>;

template <class Row>
[[nodiscard]] constexpr const Row& row_of(const PerArtifact<Row>& table, ArtifactId id) {
  return table[static_cast<std::size_t>(id)];
}

struct Artifact {
  ArtifactId id = ArtifactId::cpp;
  std::string path = {};  ///< "cart_pole/cart_pole.hpp", relative to the output folder
};

/// What the scene wants, in the order of the table; nothing has to be derived for it.
[[nodiscard]] std::vector<Artifact> artifacts_of(const Scene& scene);

[[nodiscard]] std::string path_of(const Scene& scene, ArtifactId id);

}  // namespace elgen
