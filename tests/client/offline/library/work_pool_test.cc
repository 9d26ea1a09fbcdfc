// Pieces of work in processes of their own: in their order, and only the piece is lost whose
// process dies.
#include "client/offline/library/work_pool.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace stanok::client {
namespace {

struct Taken {
  std::size_t index = 0;
  PieceResult result;
};

std::vector<Taken> done(std::size_t count, int processes,
                        const std::function<std::string(std::size_t)>& work) {
  std::vector<Taken> taken;
  const PoolCalls calls{
      .work = work,
      .take = [&](std::size_t index,
                  PieceResult result) { taken.push_back({index, std::move(result)}); },
      .progress = [](std::size_t) {},
      .gives_up = [] { return false; }};
  EXPECT_TRUE(do_in_processes(count, processes, calls));
  EXPECT_EQ(taken.size(), count);
  for (std::size_t k = 0; k < taken.size(); ++k) EXPECT_EQ(taken[k].index, k);
  return taken;
}

TEST(WorkPool, GivesResultsInTheOrderOfThePieces) {
  const auto work = [](std::size_t index) {
    if (index % 7 == 0) ::usleep(3000);  // that others overtake
    return std::to_string(index) + std::string(index * 97, 'x');
  };
  for (const int processes : {1, 2, 5, 64}) {
    for (const Taken& one : done(60, processes, work)) {
      EXPECT_EQ(one.result.death, "");
      EXPECT_EQ(one.result.bytes, work(one.index));
    }
  }
}

TEST(WorkPool, CarriesLargeAndEmptyResults) {
  constexpr std::size_t large = 5'000'000;
  const auto taken = done(6, 3, [](std::size_t index) {
    return index % 2 == 0 ? std::string() : std::string(large + index, 'y');
  });
  for (const Taken& one : taken)
    EXPECT_EQ(one.result.bytes.size(), one.index % 2 == 0 ? 0 : large + one.index);
}

TEST(WorkPool, LosesOnlyThePieceWhoseProcessDies) {
  const auto taken = done(40, 3, [](std::size_t index) {
    if (index == 5) ::kill(::getpid(), SIGKILL);
    if (index == 6) ::_exit(9);
    return std::string("done");
  });
  for (const Taken& one : taken) {
    const bool is_lost = one.index == 5 || one.index == 6;
    EXPECT_EQ(one.result.death.empty(), !is_lost) << one.index << one.result.death;
    EXPECT_EQ(one.result.bytes, is_lost ? "" : "done");
  }
  EXPECT_NE(taken[5].result.death.find("signal 9"), std::string::npos);
  EXPECT_NE(taken[6].result.death.find("exit code 9"), std::string::npos);
}

TEST(WorkPool, ThrowsWhatTheWorkThrows) {
  const PoolCalls calls{.work = [](std::size_t index) -> std::string {
                          if (index == 3) throw std::invalid_argument("there is no channel 9");
                          return "done";
                        },
                        .take = [](std::size_t, const PieceResult&) {},
                        .progress = [](std::size_t) {},
                        .gives_up = [] { return false; }};
  try {
    static_cast<void>(do_in_processes(10, 2, calls));
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "there is no channel 9");
  }
}

TEST(WorkPool, EndsItsProcessesWhenItGivesUp) {
  std::size_t count = 0;
  bool has_begun = false;
  const PoolCalls calls{.work =
                            [](std::size_t index) {
                              if (index > 0) ::pause();
                              return std::to_string(::getpid());
                            },
                        .take =
                            [&](std::size_t, const PieceResult& result) {
                              ++count;
                              has_begun = true;
                              EXPECT_GT(std::stoi(result.bytes), 0);
                            },
                        .progress = [](std::size_t) {},
                        .gives_up = [&] { return has_begun; }};
  EXPECT_FALSE(do_in_processes(10, 2, calls));
  EXPECT_EQ(count, 1U);
}

TEST(WorkPool, OfNothingIsDone) {
  EXPECT_TRUE(done(0, 4, [](std::size_t) { return std::string(); }).empty());
}

}  // namespace
}  // namespace stanok::client
