// Readback: the files that are about to be written, read again, and compared with what was derived.
//
//     const Scalar t_1 = p.m * p.l;   read as   multiply m l   and compared with the Program's
//
// Nothing is compiled, and what is shared with emission are the pictures of templates/ and what
// callers see of code (src/lower/code_interface.hpp): names, types, parameters, declared arrays.
// Headers are read token by token: every token is one of the picture, or part of a function, a
// constant, a default or a declaration that is compared. Operations, their order, operands,
// literals and the order of storage have to be the Program's.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elgen/diagnostic.hpp"
#include "elgen/model.hpp"
#include "elgen/program.hpp"
#include "elgen/scene.hpp"

namespace elgen {

/// What was read.
struct Readback {
  std::size_t files = 0;
  std::size_t functions = 0;  ///< definitions of functions in all headers
  std::size_t equations = 0;  ///< definitions and entries that people read, in all files
};

/// `files` by their paths, as emit() names them; they keep the places of diagnostics alive.
/// E915: the first place in each file where it does not say what was derived.
[[nodiscard]] Result<Readback> read_back(const std::vector<SourcePointer>& files,
                                         const CheckedModel& checked, const Program& program);

/// E915 where a page of text_page(), made of the same program, does not say what was derived.
[[nodiscard]] Diagnostics read_back_page(const SourcePointer& page, const CheckedModel& checked,
                                         const Program& program);

/// "2 files read back"
[[nodiscard]] std::string receipt(const Readback& readback);

}  // namespace elgen
