// The scheduling class of a thread that runs when nothing else wants to.
#include "base/idle_thread.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>

#include "tests/support/sanitized.h"

namespace stanok {
namespace {

// Sanitized threads stay what they are (base/idle_thread.cc).
constexpr int idle_class = testing::is_sanitized ? SCHED_OTHER : SCHED_IDLE;

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

// A busy computer leaves an idle thread next to nothing: who ends it would wait for minutes.
TEST(IdleThread, HasTheUsualClassWhileItsEndIsWaitedFor) {
  std::atomic<bool> was_usual{false};
  std::jthread thread([&](const std::stop_token& stop) {
    run_when_idle(stop);
    while (!stop.stop_requested()) std::this_thread::yield();
    wait_for_class(SCHED_OTHER);
    was_usual = true;
  });
  end_idle_thread(thread);
  EXPECT_TRUE(was_usual);
  EXPECT_FALSE(thread.joinable());
}

TEST(IdleThread, ThatIsEndedBeforeItBeginsHasTheUsualClassToo) {
  std::stop_source stop;
  stop.request_stop();
  std::jthread thread([&] {
    run_when_idle(stop.get_token());
    wait_for_class(SCHED_OTHER);
  });
  thread.join();
  SUCCEED();
}

// Before and behind its work it holds what others wait for.
TEST(IdleThread, WorksIdleOnly) {
  std::jthread thread([](const std::stop_token& stop) {
    EXPECT_EQ(own_class(), SCHED_OTHER);
    {
      const IdleWork idle(stop);
      EXPECT_EQ(own_class(), idle_class);
    }
    EXPECT_EQ(own_class(), SCHED_OTHER);
  });
  thread.join();
}

TEST(IdleThread, ThatWasNeverStartedNeedsNoEnd) {
  std::jthread thread;
  end_idle_thread(thread);
  EXPECT_FALSE(thread.joinable());
}

}  // namespace
}  // namespace stanok
