// The commit of the sources, for `--version`; emitted files do not know it.
#pragma once

namespace elgen::cli {

/// Its first twelve digits; empty where the sources came without their history.
extern const char* const commit;

}  // namespace elgen::cli
