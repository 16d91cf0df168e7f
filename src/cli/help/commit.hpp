// The commit of the sources, for `--version`; emitted files do not contain it.
#pragma once

namespace elgen::cli {

/// The first twelve hexadecimal digits of the commit; "" if the sources have no git history.
extern const char* const commit;

}  // namespace elgen::cli
