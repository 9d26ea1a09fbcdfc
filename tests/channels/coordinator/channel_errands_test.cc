// Errands that take time, and waits, step by step without programs.
#include "channels/coordinator/channel_errands.h"

#include <gtest/gtest.h>

#include "base/visit_in_cycle.h"
#include "channels/coordinator/wait_desk.h"
#include "tests/support/machine/coordinator_bench.h"

namespace stanok::channels {
namespace {

using stanok::testing::bench_cycle_s;
using stanok::testing::bench_x;
using stanok::testing::CoordinatorBench;

class ChannelErrandsTest : public ::testing::Test {
 protected:
  // An operator asks something of channel 7.
  Errand command(const Request& request) {
    Errand errand;
    errand.active = true;
    errand.request = request;
    errand.target = 1;
    errand.generation = target_.run.generation();
    return errand;
  }

  Verdict step(Errand& errand) {
    return visit_in_cycle(
        [&](const auto& request) {
          if constexpr (ChannelRequest<std::remove_cvref_t<decltype(request)>>)
            return errands_.step(errand, request);
          else
            return pending();
        },
        errand.request);
  }

  CoordinatorBench bench_;
  ControlDesk control_{bench_.table, bench_.ownership};
  ChannelErrands errands_{bench_.table,
                          bench_.ownership,
                          control_,
                          {OwnerFailure::reset, OwnerFailure::hold},
                          bench_cycle_s};
  Channel& target_ = bench_.table[1];
};

TEST_F(ChannelErrandsTest, AStartBeginsARunAndAStopHoldsIt) {
  Errand start = command(requests::ProgramStart{});
  EXPECT_TRUE(step(start).ok);
  EXPECT_EQ(target_.state().situation(), Situation::running);
  Errand stop = command(requests::ProgramStop{});
  EXPECT_TRUE(step(stop).ok);  // the axes stand
  EXPECT_EQ(target_.run.hold_cause(), HoldCause::operator_hold);
  EXPECT_TRUE(step(start).ok);
  EXPECT_EQ(target_.state().situation(), Situation::running);
}

TEST_F(ChannelErrandsTest, WithNothingRunningThereIsNothingToStop) {
  Errand stop = command(requests::ProgramStop{});
  EXPECT_EQ(step(stop).code.view(), "E6007");
}

TEST_F(ChannelErrandsTest, WhatWasAskedForBeforeAStopDoesNotBegin) {
  Errand start = command(requests::ProgramStart{});
  target_.run.hold_by_operator(FeedStop::acts);
  EXPECT_EQ(step(start).code.view(), "E6072");
  EXPECT_EQ(target_.state().situation(), Situation::ready);
}

TEST_F(ChannelErrandsTest, NothingBeginsOnAChannelThatSomebodyElseHas) {
  ASSERT_TRUE(control_.set(7, 33).ok);
  Errand start = command(requests::ProgramStart{});
  EXPECT_EQ(step(start).code.view(), "E6080");
}

TEST_F(ChannelErrandsTest, AResetIsOverWhenThePreparationHasObeyed) {
  Errand start = command(requests::ProgramStart{});
  ASSERT_TRUE(step(start).ok);
  Errand reset = command(requests::ProgramReset{});
  EXPECT_FALSE(step(reset).done);
  EXPECT_FALSE(step(reset).done);
  bench_.cycles(3);
  EXPECT_TRUE(step(reset).done);
  EXPECT_EQ(target_.state().situation(), Situation::ready);
}

TEST_F(ChannelErrandsTest, ASchemeThatDoesNotExistIsRefused) {
  Errand absent = command(requests::KinematicsSelect{.scheme = 9});
  EXPECT_EQ(step(absent).code.view(), "E5201");
  Errand change = command(requests::KinematicsSelect{.scheme = 1});
  EXPECT_FALSE(step(change).done);
  EXPECT_EQ(target_.state().situation(), Situation::switching);
}

TEST_F(ChannelErrandsTest, HomingNamesAnAxisOfTheChannel) {
  Errand home = command(requests::Home{{"Q"}});
  EXPECT_EQ(step(home).code.view(), "E6052");
}

// Channel 4 starts channel 7 and fails: channel 7 is held, as its rule says.
TEST_F(ChannelErrandsTest, ARunWhoseOwnerFailsIsHeldOrReset) {
  bench_.table[0].items().begin_run(Job::program);
  Errand start = command(requests::ProgramStart{});
  start.asker = 0;
  ASSERT_TRUE(step(start).ok);
  errands_.follow_owners();
  EXPECT_EQ(target_.state().situation(), Situation::running);
  bench_.table[0].run.fail("E3008", "a number is divided by zero", {});
  errands_.follow_owners();
  EXPECT_EQ(target_.run.hold_cause(), HoldCause::owner_failed);
}

class WaitDeskTest : public ::testing::Test {
 protected:
  Errand& waits_at_mark(int index, int mark) {
    Errand& errand = errands_[index];
    errand.active = true;
    errand.request = requests::MarkWait{.mark = mark, .channels = 1U << 4 | 1U << 7};
    errand.asker = index;
    bench_.table[index].items().begin_run(Job::program);
    return errand;
  }
  void advance() {
    desk_.advance([&](Errand& errand, const Verdict& verdict) RT_SAFE {
      errand.active = false;
      fault_ = verdict;
    });
  }

  CoordinatorBench bench_;
  NumberedArray<Errand, 2> errands_{};
  WaitDesk desk_{bench_.table, errands_, bench_cycle_s};
  Verdict fault_;
};

TEST_F(WaitDeskTest, AMarkIsMetWhenAllPartnersAreThere) {
  const Errand& first = waits_at_mark(0, 5);
  advance();
  EXPECT_FALSE(desk_.wait_at_mark(first).done);
  EXPECT_TRUE(desk_.is_waiting_for_channels(0));
  const Errand& second = waits_at_mark(1, 5);
  advance();
  EXPECT_TRUE(desk_.wait_at_mark(first).ok);
  EXPECT_TRUE(desk_.wait_at_mark(second).ok);
  EXPECT_FALSE(desk_.is_waiting_for_channels(0));
}

TEST_F(WaitDeskTest, ChannelsThatWaitForEachOtherForEverAreTold) {
  static_cast<void>(waits_at_mark(0, 5));
  static_cast<void>(waits_at_mark(1, 6));
  advance();
  EXPECT_EQ(fault_.code.view(), "E6020");
  EXPECT_NE(std::string(fault_.text.view()).find("channel 4 waits for channel 7"),
            std::string::npos);
}

TEST_F(WaitDeskTest, APartnerThatHasEndedDoesNotComeAnyMore) {
  const Errand& first = waits_at_mark(0, 5);
  advance();
  bench_.cycle();
  bench_.table[1].items().begin_run(Job::program);
  bench_.table[1].run.end_run(RunResult::succeeded, 0);
  EXPECT_EQ(desk_.wait_at_mark(first).code.view(), "E6021");
}

TEST_F(WaitDeskTest, AWaitForTheEndOfARunEndsWithItOrWithItsTime) {
  Channel& target = bench_.table[1];
  target.items().begin_run(Job::program);
  Errand wait;
  wait.target = 1;
  EXPECT_FALSE(desk_.wait_for_end(wait, 0.005, target).done);
  wait.cycles = 5;
  EXPECT_EQ(desk_.wait_for_end(wait, 0.005, target).code.view(), "E6010");
  EXPECT_FALSE(desk_.wait_for_end(wait, -1.0, target).done);
  target.run.end_run(RunResult::succeeded, 0);
  EXPECT_TRUE(desk_.wait_for_end(wait, -1.0, target).ok);
}

}  // namespace
}  // namespace stanok::channels
