// The scheduling class of a thread with much to compute that nobody waits for.
#include "base/batch_thread.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>

namespace stanok {
namespace {

int own_class() {
  int policy = -1;
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &policy, &parameters);
  return policy;
}

// Waits until the class is the one wanted; what waits for it for ever is ended by ctest.
void wait_for_class(int policy) {
  while (own_class() != policy) std::this_thread::yield();
}

TEST(BatchThread, HasTheUsualClassWhileItsEndIsWaitedFor) {
  std::atomic<bool> was_usual{false};
  std::jthread thread([&](const std::stop_token& stop) {
    run_as_batch(stop);
    while (!stop.stop_requested()) std::this_thread::yield();
    wait_for_class(SCHED_OTHER);
    was_usual = true;
  });
  end_batch_thread(thread);
  EXPECT_TRUE(was_usual);
  EXPECT_FALSE(thread.joinable());
}

TEST(BatchThread, ThatIsEndedBeforeItBeginsHasTheUsualClassToo) {
  std::stop_source stop;
  stop.request_stop();
  std::jthread thread([&] {
    run_as_batch(stop.get_token());
    wait_for_class(SCHED_OTHER);
  });
  thread.join();
  SUCCEED();
}

// Before and behind its work it holds what others wait for.
TEST(BatchThread, IsOfItsClassOnlyWhileItWorks) {
  std::jthread thread([](const std::stop_token& stop) {
    EXPECT_EQ(own_class(), SCHED_OTHER);
    {
      const BatchWork work(stop);
      EXPECT_EQ(own_class(), SCHED_BATCH);
    }
    EXPECT_EQ(own_class(), SCHED_OTHER);
  });
  thread.join();
}

TEST(BatchThread, ThatWasNeverStartedNeedsNoEnd) {
  std::jthread thread;
  end_batch_thread(thread);
  EXPECT_FALSE(thread.joinable());
}

}  // namespace
}  // namespace stanok
