// Files: bags, tables, HDF5 and arrays as other programs write them.
#include <gmock/gmock.h>

#include "tests/cases/cases.h"

namespace heft::test {
namespace {

class FileCases : public CaseTest {};

constexpr const char* kAbsent = "The shared inputs (../shared/cases) are not at hand.";

TEST_F(FileCases, NamesDecideWhichJointIsWhich) {
  if (!enter("01-joint-order")) GTEST_SKIP() << kAbsent;
  for (const char* const name : {"sorted.mcap", "turning.mcap", "novel.mcap", "noname.mcap"}) expectTruth({name});
}

}  // namespace
}  // namespace heft::test
