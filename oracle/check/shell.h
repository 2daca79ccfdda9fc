// Words of commands that are printed, to be given to a shell in any folder.
#pragma once

#include "lib/text/words.h"

#include <string>
#include <string_view>

namespace lgs::oracle {

using text::shellWord;

/// The path of a file as a shell takes it, in any folder.
std::string shellPath(const std::string& path);

/// The folder that commands run in now, as a shell takes it.
std::string thisFolder();

/// This program as a shell takes it, in any folder; `otherwise` where the system does not say.
std::string thisProgram(std::string_view otherwise);

}  // namespace lgs::oracle
