#include "core/recording/configured_payload.h"

namespace heft {

bool isFlangeName(std::string_view link) {
  return link.empty() || link.ends_with("link8") || link.ends_with("flange") || link.ends_with("tool0");
}

}  // namespace heft
