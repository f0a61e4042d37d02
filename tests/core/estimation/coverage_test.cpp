#include <gtest/gtest.h>

#include "tests/support/coverage.h"

namespace heft {
namespace {

/// A small, seeded version of the coverage program: 40 recordings a motion. With 95 % coverage 40 intervals miss the
/// truth between 0 and 6 times in 99.9 % of all sets; the 120 and 240 of centre and inertia vary less but are
/// correlated.
TEST(Coverage, IntervalsHoldTheTruthAboutAsOftenAsTheySay) {
  for (const auto kind : {MotionKind::excitation, MotionKind::pickAndPlace, MotionKind::free}) {
    test::CoverageOptions options;
    options.motion = kind;
    options.recordings = 40;
    options.seed = 5;
    const auto result = test::measureCoverage(options, 2);
    EXPECT_EQ(result.failed, 0);
    EXPECT_EQ(result.unphysical, 0);
    EXPECT_GE(result.mass.inside, 0.85) << toString(kind);
    EXPECT_GE(result.com.inside, 0.88) << toString(kind);
    EXPECT_GE(result.inertia.inside, 0.88) << toString(kind);
    // Honest is not the same as wide.
    EXPECT_GT(result.mass.ratio, 0.6) << toString(kind);
    EXPECT_GT(result.com.ratio, 0.7) << toString(kind);
    EXPECT_GT(result.inertia.ratio, 0.7) << toString(kind);
    EXPECT_LT(result.massError, 0.002) << toString(kind);
    EXPECT_LT(result.comError, 0.005) << toString(kind);
    EXPECT_LT(result.inertiaOriginError, 0.10) << toString(kind);
  }
}

}  // namespace
}  // namespace heft
