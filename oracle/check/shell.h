// Words of commands that are printed, to be given to a shell in any folder.
#pragma once

#include <string>
#include <string_view>

namespace lgs::oracle {

/// A word as a shell takes it: in quotes if it has to be.
std::string shellWord(std::string_view word);

/// The path of a file as a shell takes it, in any folder.
std::string shellPath(const std::string& path);

/// The folder that commands run in now, as a shell takes it.
std::string thisFolder();

/// This program as a shell takes it, in any folder; `otherwise` where the system does not say.
std::string thisProgram(std::string_view otherwise);

}  // namespace lgs::oracle
