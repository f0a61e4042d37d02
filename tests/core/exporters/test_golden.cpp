// Files as they were agreed on, byte by byte. HEFT_UPDATE_GOLDEN=1 writes them anew; look at the difference then.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/base/json_file.h"
#include "tests/core/exporters/readers.h"
#include "tests/data/golden/tool.libfranka.h"

namespace heft {
namespace {

TEST(ExportGolden, FilesAreAsAgreed) {
  const std::filesystem::path folder = std::filesystem::path(HEFT_SOURCE_DIR) / "tests/data/golden";
  for (const ExportFormat& format : exportFormats()) {
    Findings findings;
    const std::string text = exportPayload(format, goldenInput(), findings).value();
    const auto file = folder / ("tool." + std::string(format.id) + std::string(format.extension));
    if (std::getenv("HEFT_UPDATE_GOLDEN")) {
      ASSERT_TRUE(writeTextFile(file, text).ok());
      continue;
    }
    const auto golden = readTextFile(file);
    ASSERT_TRUE(golden.ok()) << golden.error().message;
    EXPECT_EQ(text, *golden) << format.id;
  }
}

TEST(ExportGolden, TheLibfrankaFileCompilesAndSetsTheLoad) {
  franka::Robot robot;
  setPayload(robot);
  const Payload payload = roundedForExport(goldenPayload());
  EXPECT_EQ(robot.mass, payload.mass);
  EXPECT_EQ(Vector3d(robot.com.data()), payload.com);
  EXPECT_EQ(Matrix3d(robot.inertia.data()), payload.inertiaCom);
}

}  // namespace
}  // namespace heft
