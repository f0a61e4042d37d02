#pragma once
// Readers whose library fails on damaged files run in a process of their own.
#include <filesystem>
#include <functional>

#include "core/import/streams.h"

namespace heft {

using StreamReader = std::function<Result<StreamSet>(const Progress&)>;

/// What `read` gives, read in a copy of this process (fork) that sends it back: where the library crashes, this process
/// has an error that says so. The copy has one thread; `read` takes no lock that another thread may hold at this
/// moment. Progress comes through, and a stop ends the copy at once. Sentences are said again here, in the language of
/// now.
Result<StreamSet> readInOwnProcess(const std::filesystem::path& path, const StreamReader& read,
                                   const Progress& progress);

}  // namespace heft
