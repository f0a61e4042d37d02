#include "app/version.h"

#include <ceres/version.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "heft_revision.h"

namespace heft {

std::string_view version() { return HEFT_VERSION; }

std::string versionText(std::string_view program) {
  return fmt::format("{} {}\nrevision {}; Eigen {}.{}.{}, Ceres {}, JSON {}.{}.{}, fmt {}.{}.{}, compiler {}", program,
                     version(), HEFT_REVISION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
                     CERES_VERSION_STRING, NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     __VERSION__);
}

}  // namespace heft
