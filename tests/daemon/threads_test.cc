// Preparation and publisher threads: everybody is served, nothing is lost, faults are told.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <latch>
#include <memory>
#include <stdexcept>
#include <thread>

#include "daemon/cycle/newest_output.h"
#include "daemon/cycle/preparation_threads.h"
#include "daemon/publish/publisher_thread.h"
#include "daemon/publish/reply_thread.h"

namespace stanok::daemon {
namespace {

using channels::Progress;

TEST(PreparationThreads, WorkOnEveryChannelUntilTheyAreStopped) {
  std::array<std::atomic<int>, 3> calls{};
  std::latch all_worked(3);
  {
    const PreparationThreads threads(
        3,
        [&](int index) {
          if (++calls.at(static_cast<std::size_t>(index)) == 5) all_worked.count_down();
          return index == 0 ? Progress::blocked : Progress::worked;
        },
        [](int index) { return index == 1; }, [](int, std::string_view) { FAIL(); });
    all_worked.wait();
  }
  const int after = calls[1];
  EXPECT_EQ(calls[1], after) << "stopped";
}

TEST(PreparationThreads, TellAFaultAndKeepTheOtherChannelsAtWork) {
  std::latch faulted(1);
  std::latch other_worked(1000);
  std::string told;
  {
    const PreparationThreads threads(
        2,
        [&](int index) -> Progress {
          if (index == 0) throw std::runtime_error("broken");
          if (!other_worked.try_wait()) other_worked.count_down();
          return Progress::worked;
        },
        [](int) { return false; },
        [&](int index, std::string_view reason) {
          told = std::to_string(index) + " " + std::string(reason);
          faulted.count_down();
        });
    faulted.wait();
    other_worked.wait();
  }
  EXPECT_EQ(told, "0 broken");
}

class Notebook final : public CycleListener {
 public:
  void on_output(const channels::CycleOutput& output) override { cycles.push_back(output.cycle); }
  void on_event(const channels::Event& event) override { events.push_back(event.cycle); }
  void on_input(const channels::InputRecord& input) override { inputs.push_back(input.cycle); }

  std::vector<std::int64_t> cycles, events, inputs;
};

struct Rings {
  Ring<channels::CycleOutput> outputs{64};
  Ring<channels::Event> events{8};
  Ring<channels::InputRecord> inputs{8};
  Ring<channels::InputChange> changes{8};
  [[nodiscard]] CycleRings all() { return {outputs, events, inputs, changes}; }
};

TEST(Drain, HandsEverythingToEveryListenerInOrder) {
  Rings rings;
  Notebook first;
  Notebook second;
  auto output = std::make_unique<channels::CycleOutput>();
  for (std::int64_t cycle = 1; cycle <= 5; ++cycle) {
    output->cycle = cycle;
    ASSERT_TRUE(rings.outputs.push(*output));
  }
  channels::Event event;
  event.cycle = 3;
  ASSERT_TRUE(rings.events.push(event));
  EXPECT_EQ(drain(rings.all(), {&first, &second}), 6U);
  for (const Notebook* book : {&first, &second}) {
    EXPECT_EQ(book->cycles, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(book->events, std::vector<std::int64_t>{3});
  }
  EXPECT_EQ(drain(rings.all(), {&first}), 0U);
}

class Order final : public CycleListener {
 public:
  void on_output(const channels::CycleOutput& output) override {
    seen.push_back("output " + std::to_string(output.cycle));
  }
  void on_input(const channels::InputRecord& input) override {
    seen.push_back("input " + std::to_string(input.cycle));
  }
  void on_change(const channels::InputChange& change) override {
    seen.push_back("change " + std::to_string(change.cycle));
  }
  void on_program_read(const recording::ProgramRead& read) override { seen.push_back(read.name); }

  std::vector<std::string> seen;
};

// While the publisher asks for the texts, another cycle is over that may have seen a newer one.
TEST(Drain, HandsInputsAndTextsOnBeforeTheOutputsTheyLedTo) {
  Rings rings;
  Order order;
  const auto output = std::make_unique<channels::CycleOutput>();
  const auto cycle = [&](std::int64_t number) {
    channels::InputRecord input;
    input.cycle = number;
    output->cycle = number;
    ASSERT_TRUE(rings.inputs.push(input));
    ASSERT_TRUE(rings.changes.push({.cycle = number, .content = channels::Arrivals{}}));
    ASSERT_TRUE(rings.outputs.push(*output));
  };
  std::int64_t next = 1;
  CycleRings all = rings.all();
  all.program_reads = [&] {
    const recording::ProgramRead read{.name = "text " + std::to_string(next)};
    cycle(++next);
    return std::vector{read};
  };
  cycle(1);
  drain(all, {&order});
  drain(all, {&order});
  EXPECT_EQ(order.seen,
            (std::vector<std::string>{"text 1", "input 1", "input 2", "change 1", "change 2",
                                      "output 1", "text 2", "input 3", "change 3", "output 2"}));
}

TEST(PublisherThread, HandsOverWhatIsLeftBeforeItEnds) {
  Rings rings;
  Notebook book;
  const auto output = std::make_unique<channels::CycleOutput>();
  {
    const PublisherThread thread(rings.all(), {&book}, [](std::string_view) { FAIL(); });
    for (std::int64_t cycle = 1; cycle <= 1000; ++cycle) {
      output->cycle = cycle;
      while (!rings.outputs.push(*output)) std::this_thread::yield();
    }
  }
  ASSERT_EQ(book.cycles.size(), 1000U);
  for (std::int64_t cycle = 1; cycle <= 1000; ++cycle)
    EXPECT_EQ(book.cycles[static_cast<std::size_t>(cycle - 1)], cycle);
}

TEST(PublisherThread, TellsAFaultOfAListener) {
  class Broken final : public CycleListener {
    void on_event(const channels::Event&) override { throw std::runtime_error("no more paper"); }
  };
  Rings rings;
  Broken broken;
  std::string told;
  std::latch done(1);
  ASSERT_TRUE(rings.events.push({}));
  const PublisherThread thread(rings.all(), {&broken}, [&](std::string_view reason) {
    told = reason;
    done.count_down();
  });
  done.wait();
  EXPECT_EQ(told, "no more paper");
}

// Who hears of an answer finds the cycle that gave it over; the recorder has no part in it.
TEST(ReplyThread, TellsAReplyBehindTheCycleThatGaveIt) {
  Ring<channels::OperatorReply> replies(8);
  std::atomic<std::int64_t> over{0};
  std::atomic<std::int64_t> heard_behind{0};
  std::latch heard(1);
  const ReplyThread thread(
      replies, [&] { return over.load(); },
      [&](const channels::OperatorReply& reply) {
        EXPECT_EQ(reply.id, 9U);
        heard_behind = over.load();
        heard.count_down();
      },
      [](std::string_view) { FAIL(); });
  over = 41;
  channels::OperatorReply reply;
  reply.id = 9;
  ASSERT_TRUE(replies.push(reply));  // in cycle 42, which goes on for a while
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(heard.try_wait());
  over = 42;
  heard.wait();
  EXPECT_EQ(heard_behind, 42);
}

TEST(NewestOutput, IsWholeAndNeverOlderThanTheOneBefore) {
  const auto first = std::make_unique<channels::CycleOutput>();
  first->cycle = 0;
  NewestOutput newest(*first);
  EXPECT_EQ(newest.get().cycle, 0);
  std::atomic<bool> ends{false};
  std::jthread cycle([&] {
    const auto output = std::make_unique<channels::CycleOutput>();
    output->channel_count = 3;
    for (std::int64_t n = 1; n <= 20'000; ++n) {
      output->cycle = n;
      for (int k = 0; k < 3; ++k) output->channels[k].path_speed = static_cast<double>(n);
      newest.put(*output);
    }
    ends = true;
  });
  const auto look = [&] {
    std::int64_t before = 0;
    while (!ends) {
      const channels::CycleOutput seen = newest.get();
      ASSERT_GE(seen.cycle, before);
      before = seen.cycle;
      for (int k = 0; k < seen.channel_count; ++k)
        ASSERT_EQ(seen.channels[k].path_speed, static_cast<double>(seen.cycle));
    }
  };
  std::jthread other(look);
  look();
  cycle.join();
  EXPECT_EQ(newest.get().cycle, 20'000);
}

}  // namespace
}  // namespace stanok::daemon
