// Where numbered programs and O-subprograms are found.
#include "lang/run/call_targets.h"

#include <gtest/gtest.h>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class CallTargets : public ::testing::Test {
 protected:
  CallTargets() {
    for (const char* const name : {"main.nc", "one.nc", "two.nc", "9.nc"}) {
      program.files.push_back(std::make_unique<CompiledFile>(source_of(name, "")));
    }
    program.files[0]->includes = {1, 2};
  }

  Program program;
};

TEST_F(CallTargets, TheOwnTextComesBeforeIncludedOnes) {
  program.files[0]->numbered_programs[5] = 50;
  program.files[1]->numbered_programs[5] = 51;
  const auto search = find_numbered_program(program, 0, 5, SearchedTexts::all);
  ASSERT_TRUE(search.place.has_value());
  EXPECT_EQ(search.place->file, 0);
  EXPECT_EQ(search.place->position, 50u);
  EXPECT_FALSE(search.place->other_file);
}

TEST_F(CallTargets, TwoIncludedTextsOfOneNumberAreRivals) {
  program.files[1]->numbered_programs[5] = 51;
  program.files[2]->numbered_programs[5] = 52;
  const auto search = find_numbered_program(program, 0, 5, SearchedTexts::all);
  EXPECT_FALSE(search.place.has_value());
  ASSERT_TRUE(search.rivals.has_value());
  EXPECT_EQ(*search.rivals, std::make_pair(std::uint16_t{1}, std::uint16_t{2}));
}

TEST_F(CallTargets, TheFileOfTheNumberComesLastAndAloneForM198) {
  program.file_by_number[{0, 9}] = 3;
  program.files[0]->numbered_programs[9] = 90;
  EXPECT_EQ(find_numbered_program(program, 0, 9, SearchedTexts::all).place->file, 0);
  const auto file = find_numbered_program(program, 0, 9, SearchedTexts::files_only);
  ASSERT_TRUE(file.place.has_value());
  EXPECT_EQ(file.place->file, 3);
  EXPECT_EQ(file.place->position, 0u) << "from its beginning when it does not hold the number";
  EXPECT_TRUE(file.place->other_file);
}

TEST_F(CallTargets, WhatIsNowhereIsNotFound) {
  const auto search = find_numbered_program(program, 0, 1, SearchedTexts::all);
  EXPECT_FALSE(search.place || search.rivals);
  EXPECT_FALSE(find_o_subprogram(program, 0, "100").has_value());
  program.files[2]->o_subprograms["100"] = 4;
  EXPECT_EQ(find_o_subprogram(program, 0, "100")->function, 4u);
}

}  // namespace
}  // namespace stanok::lang::testing
