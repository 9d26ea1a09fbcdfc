// Preparation and publisher threads: everybody is served, nothing is lost, faults are told.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <latch>
#include <stdexcept>

#include "daemon/cycle/preparation_threads.h"
#include "daemon/publish/publisher_thread.h"

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
        [](int, std::string_view) { FAIL(); });
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
  void on_reply(const channels::OperatorReply& reply) override { replies.push_back(reply.id); }

  std::vector<std::int64_t> cycles, events, inputs;
  std::vector<std::uint64_t> replies;
};

struct Rings {
  Ring<channels::CycleOutput> outputs{64};
  Ring<channels::Event> events{8};
  Ring<channels::InputRecord> inputs{8};
  Ring<channels::InputChange> changes{8};
  Ring<channels::OperatorReply> replies{8};
  [[nodiscard]] CycleRings all() { return {outputs, events, inputs, changes, replies}; }
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
  channels::OperatorReply reply;
  reply.id = 9;
  ASSERT_TRUE(rings.replies.push(reply));
  EXPECT_EQ(drain(rings.all(), {&first, &second}), 7U);
  for (const Notebook* book : {&first, &second}) {
    EXPECT_EQ(book->cycles, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(book->events, std::vector<std::int64_t>{3});
    EXPECT_EQ(book->replies, std::vector<std::uint64_t>{9});
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
  EXPECT_EQ(order.seen, (std::vector<std::string>{"text 1", "input 1", "input 2", "output 1",
                                                  "text 2", "input 3", "output 2"}));
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

}  // namespace
}  // namespace stanok::daemon
