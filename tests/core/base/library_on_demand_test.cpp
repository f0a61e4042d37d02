// The system's own mathematics stand for a library that is loaded at its first use.
#include "core/base/library_on_demand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

namespace heft {
namespace {

const LibraryOnDemand kMath{"libm.so.6", "libc6"};
const LibraryOnDemand kNowhere{"libheft-has-no-such-library.so.1", "libnowhere1"};

TEST(LibraryOnDemand, CallsAndPassesOnItsFunctions) {
  const FunctionOnDemand<double(double)> root{kMath, "sqrt"};
  EXPECT_EQ(root(2.0), std::sqrt(2.0));
  double (*const pointer)(double) = root;
  EXPECT_EQ(pointer(9.0), 3.0);
  EXPECT_EQ(kMath.problem(), "");
}

TEST(LibraryOnDemand, ReadsItsVariables) {
  const VariableOnDemand<int> sign{kMath, "signgam"};
  (void)std::lgamma(-0.5);  // is negative there, which the library remembers
  EXPECT_EQ(sign, -1);
}

TEST(LibraryOnDemand, SaysWhatToInstall) {
  EXPECT_EQ(kNowhere.problem(),
            "The library libheft-has-no-such-library.so.1 is missing. Install it: apt-get install libnowhere1");
  const FunctionOnDemand<int()> never{kNowhere, "never"};
  EXPECT_THAT([&] { never(); }, ::testing::ThrowsMessage<std::runtime_error>(kNowhere.problem()));
  const FunctionOnDemand<int()> noSuch{kMath, "heft_has_no_such_function"};
  EXPECT_THAT([&] { noSuch(); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  "The library libm.so.6 has no heft_has_no_such_function: it is of another version."));
}

TEST(LibraryOnDemand, ThreadsMayShareIt) {
  const FunctionOnDemand<double(double)> cosine{kMath, "cos"};
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { EXPECT_EQ(cosine(0.0), 1.0); });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace heft
