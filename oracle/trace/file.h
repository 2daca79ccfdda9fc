// Text files in and out, with errors as values.
#pragma once

#include "oracle/trace/trace.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace lgs::oracle {

/// The content of a file; or why it can not be read.
tl::expected<std::string, TraceError> readFile(const std::string& path);

/// Replaces a file, "-" being the standard output; or why it can not be written. The new content is written beside the
/// old file and takes its name at the end. So whatever happens, to the program or to the disk, there is the old file or
/// the new one, never a part of it. If the program is killed a file NAME.XXXXXX may stay. Pipes and devices are written
/// as they are.
tl::expected<void, TraceError> writeFile(const std::string& path, std::string_view content);

/// Whether a file could be written; leaves everything as it is. To be asked before a long run.
tl::expected<void, TraceError> tryToWrite(const std::string& path);

/// Reads and parses a trace. The first bad line is the one reported, be it the text or the engine that objects: where
/// the text breaks off, the edits before it are played to see.
tl::expected<Trace, TraceError> readTrace(const std::string& path);

}  // namespace lgs::oracle
