#pragma once
// The one way in which Heft replaces a file: beside it, flushed to the disk, then renamed.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace heft {

/// A new content for a file that may exist. Until commit() the old one stays as it is, whatever happens to the program,
/// the disk or the machine; after it the new one is there whole. Symbolic links are followed and stay; an existing
/// file keeps its permissions and, as far as the system allows, its owner.
class FileReplacement {
 public:
  /// An error where `path` is a folder, is no regular file, is write-protected, or where nothing can be made beside it.
  static Result<FileReplacement> begin(const std::filesystem::path& path);
  FileReplacement(FileReplacement&& other) noexcept;
  FileReplacement& operator=(FileReplacement&&) = delete;
  ~FileReplacement();  ///< Without a commit() nothing is left behind.

  Result<bool> write(std::string_view bytes);
  /// Flushes the content, puts it in place of the old one and flushes the folder.
  Result<bool> commit();

 private:
  FileReplacement() = default;
  Error failure(int reason) const;

  std::filesystem::path named_;      ///< As it was asked for
  std::filesystem::path target_;     ///< Where the links lead
  std::filesystem::path temporary_;  ///< Empty once nothing is left to take away
  int descriptor_ = -1;
};

/// Makes a file that was not there; an error where anything has the name, also if another program makes it at the same
/// moment. On an error nothing is left behind.
Result<bool> createTextFile(const std::filesystem::path& path, std::string_view text);

/// Copies a regular file of any size; what `to` was is replaced as a whole or not at all.
Result<bool> copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Hands a file's content to the disk; 0, or errno. File systems that cannot do so are taken at their word.
int flushToDisk(int descriptor);

/// Makes what was created or renamed in the folder of `file` last over a power cut.
void flushFolderOf(const std::filesystem::path& file);

}  // namespace heft
