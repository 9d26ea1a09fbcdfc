// Messages name codes as the programmer of a code system knows them.
#include "lang/words/code_system.h"

#include <gtest/gtest.h>

#include "tests/lang/program_support.h"

namespace stanok::lang {
namespace {

struct Named {
  CodeSystem system;
  const char* here;
  const char* written;
};

class TextAsWritten : public ::testing::TestWithParam<Named> {};

// Source of the names: Fanuc B-64304EN-1, table 3.1.
TEST_P(TextAsWritten, NamesTheCodesOfTheSystem) {
  EXPECT_EQ(text_as_written(GetParam().here, GetParam().system), GetParam().written);
}

INSTANTIATE_TEST_SUITE_P(
    Messages, TextAsWritten,
    ::testing::Values(
        Named{CodeSystem::a, "`G77` needs X and Z", "`G90` needs X and Z"},
        Named{CodeSystem::a, "`G78` and `G79`", "`G92` and `G94`"},
        Named{CodeSystem::a, "G94 is active since line 7", "G98 is active since line 7"},
        Named{CodeSystem::a, "`G92.1`", "`G50.3`"}, Named{CodeSystem::b, "`G77`", "`G77`"},
        Named{CodeSystem::c, "`G77`, write e.g. `G21 X1`", "`G20`, write e.g. `G71 X1`"},
        Named{CodeSystem::a, "add G-codes, NG77, G77X, G7700, G 77",
              "add G-codes, NG77, G77X, G7700, G 77"},
        Named{CodeSystem::a, "", ""}, Named{CodeSystem::a, "G", "G"},
        Named{CodeSystem::a, "G77", "G90"}, Named{CodeSystem::a, "the end G77.", "the end G90."}));

class FaultOfALathe : public testing::ProgramTest {
 protected:
  FaultOfALathe() {
    channel.kind = ChannelKind::lathe;
    channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
  }
};

// `G92` of system A is the thread cycle: a second reason adds nothing to the first one.
TEST_F(FaultOfALathe, NamesTheCodeThatIsWrittenAndHelpsWithItAlone) {
  EXPECT_EQ(error_code("(dialect fanuc A)\nG0 X50. Z2.\nG92 X40. Z-20.\nM30\n"), "E4066");
  EXPECT_EQ(error.message, "`G92` needs a positive lead");
  EXPECT_EQ(error.help, std::vector<std::string>{"add the lead per revolution, e.g. `F1.5`"});
}

}  // namespace
}  // namespace stanok::lang
