// Codes of later releases: known, refused, and answered with what works instead.
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class LaterCodes : public ProgramTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(LaterCodes, AreRefusedWithWhatToWriteInstead) {
  const auto errors = load_errors(std::string(GetParam()) + "\nM30\n");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].code, "E2090");
  EXPECT_FALSE(errors[0].help.empty());
}

INSTANTIATE_TEST_SUITE_P(Geometry, LaterCodes,
                         ::testing::Values("G2.4 X1 I2", "G3.4 X1 I2", "G17.1", "G18.1", "G19.1"));

}  // namespace
}  // namespace stanok::lang::testing
