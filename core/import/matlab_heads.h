#pragma once
// Whether a MATLAB file can be given to libmatio: it takes as much memory as a damaged head asks for.
#include <cstddef>

#include "core/base/progress.h"
#include "core/import/bytes.h"

namespace heft {

struct SoundVariables {
  std::size_t count = 0;
  bool all = true;
};

/// The variables of a file before the first damaged one; all that there may be in a file of version 4, of which nothing
/// is read where one head is damaged. A variable of version 5 to 7 is sound where its parts (cells, fields, numbers)
/// can lie in the bytes that it has, and where a packed one agrees with its checksum. Source: MAT-File Format, The
/// MathWorks (R2023b), chapter 1.
SoundVariables soundVariables(const ByteFile& file, const Progress& progress);

}  // namespace heft
