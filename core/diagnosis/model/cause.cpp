#include "core/diagnosis/model/cause.h"

#include <fmt/format.h>

#include "core/base/say.h"

namespace heft::diagnosis {

std::string Cause::check(const FoundValues&, const Vector3d&) const { return heft::say(fmt::runtime(info().check)); }

}  // namespace heft::diagnosis
