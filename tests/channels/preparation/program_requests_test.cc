// What the coordinator is asked for when a program asks for something.
#include "channels/preparation/program_requests.h"

#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using lang::RequestKind;

class ProgramRequests : public ::testing::Test {
 protected:
  template <class Wanted>
  Wanted made_of(const lang::ProgramRequest& request) {
    const Request made = request_of(request, shared_);
    EXPECT_TRUE(std::holds_alternative<Wanted>(made)) << "kind " << made.index();
    const auto* const found = std::get_if<Wanted>(&made);
    return found == nullptr ? Wanted{} : *found;
  }

  SharedVariables shared_;
};

TEST_F(ProgramRequests, NameTheChannelThatTheyAreFor) {
  lang::ProgramRequest request;
  request.channel = 7;
  request.number = 2;
  request.seconds = 1.5;
  request.text = "flange.nc";
  request.kind = RequestKind::channel_run;
  EXPECT_EQ(made_of<requests::ProgramRun>(request).channel, 7);
  EXPECT_EQ(made_of<requests::ProgramRun>(request).program.view(), "flange.nc");
  request.kind = RequestKind::channel_wait;
  EXPECT_EQ(made_of<requests::EndWait>(request).seconds, 1.5);
  request.kind = RequestKind::kinematics;
  EXPECT_EQ(made_of<requests::KinematicsSelect>(request).scheme, 2);
  request.kind = RequestKind::mark_state;
  EXPECT_EQ(made_of<requests::MarkRead>(request).mark, 2);
}

TEST_F(ProgramRequests, OfATableSayWhichPlaceOfIt) {
  lang::ProgramRequest request;
  request.kind = RequestKind::tool_table_write;
  request.number = 3;   // tool
  request.index = 2;    // edge
  request.channel = 4;  // value
  request.value = 12.5;
  const auto write = made_of<requests::ToolWrite>(request);
  EXPECT_EQ(write.place.tool, 3);
  EXPECT_EQ(write.place.edge, 2);
  EXPECT_EQ(write.place.value, 4);
  EXPECT_EQ(write.value, 12.5);
  request.kind = RequestKind::offset_table_read;
  request.channel = 1;
  request.index = lang::rotation_of_offset;
  const auto read = made_of<requests::OffsetRead>(request);
  EXPECT_EQ(read.table, 1);
  EXPECT_EQ(read.offset, 3);
  EXPECT_EQ(read.axis, lang::rotation_of_offset);
}

TEST_F(ProgramRequests, OfASharedVariableNameItsCellAndItsKind) {
  ASSERT_FALSE(shared_.declare({.name = "count", .rows = 4, .is_array = true, .place = {}}));
  ASSERT_FALSE(shared_.declare({.name = "part", .is_text = true, .place = {}}));
  lang::ProgramRequest request;
  request.kind = RequestKind::shared_combine;
  request.text = "count";
  request.index = 3;
  request.value = 2.0;
  request.combination = lang::Combination::multiply;
  const auto combine = made_of<requests::SharedNumberCombine>(request);
  EXPECT_EQ(combine.cell, shared_.cell("count", 3).number);
  EXPECT_EQ(combine.combination, lang::Combination::multiply);
  EXPECT_EQ(combine.operand, 2.0);
  request.text = "part";
  request.index = 0;
  request.value_text = " done";
  EXPECT_EQ(made_of<requests::SharedTextAppend>(request).more.view(), " done");
  request.kind = RequestKind::shared_read;
  EXPECT_EQ(made_of<requests::SharedTextRead>(request).cell, shared_.cell("part", 0).number);
}

TEST_F(ProgramRequests, OfAnInputWaitForItsEventOrReadItsValue) {
  lang::ProgramRequest request;
  request.kind = RequestKind::input_wait;
  request.number = 5;
  request.index = 2;
  request.seconds = 0.25;
  const auto wait = made_of<requests::InputWait>(request);
  EXPECT_EQ(wait.input, 5);
  EXPECT_EQ(wait.event, requests::InputEvent::fall);
  EXPECT_EQ(wait.seconds, 0.25);
  request.analog = true;
  EXPECT_EQ(made_of<requests::AnalogRead>(request).input, 5);
}

}  // namespace
}  // namespace stanok::channels
