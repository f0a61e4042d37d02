#pragma once
// Several recordings of one kind in one file.
#include <string>

#include "core/import/streams.h"

namespace heft {

/// The part of `mine`'s path that sets it apart from `other`, where both hold the same kind of thing: they differ by a
/// number ("/data/demo_1"), or hold the same fields under another name ("/runs/morning", "/runs/evening"). Empty for
/// anything else; two arms are not two demonstrations.
std::string demonstrationOf(const Stream& mine, const Stream& other);

}  // namespace heft
