// The main function of a program beside lgs. LGS_PROGRAM is what adds its one subcommand: addImport, say.
#include "cli/command.h"

int main(int argc, char** argv) { return lgs::cli::runProgram(argc, argv, lgs::cli::LGS_PROGRAM); }
