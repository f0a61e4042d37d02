#pragma once
// What Result, Export and the report say about causes that were found and are not applied.
#include "ui/controller/workspace.h"
#include "ui/models/result_text.h"

namespace heft {

/// Of the shown recording, by its reality check; empty if there is none, or all is applied.
OpenQuestion openQuestion(Workspace& workspace);

/// What the user stated, else what the shown recording's setup file states.
KnownPayload knownPayload(const Workspace& workspace);

}  // namespace heft
