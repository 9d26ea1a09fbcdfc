// SituationBook: what gave the words of a channel their meaning, by its number, and where its
// blocks end; kept by the preparation until the cycle has executed them. For displays; no effect on
// motion.
//
// The preparation is ahead of the motion by as many blocks as the path queue holds; a display asks
// for the situation whose number the cycle shows, and what lies far behind that is forgotten: a run
// may last for days. Any thread. Invariant: a number stands for one meaning for ever.
#pragma once

#include <deque>
#include <mutex>

#include "channels/contract/reports.h"
#include "lang/contract/meaning.h"
#include "motion/path/path.h"

namespace stanok::channels {

class SituationBook {
 public:
  // Preparation side.
  void begin_run(std::uint32_t run);
  // The number of the meaning: the one before and 1.
  std::uint32_t enter(const lang::Meaning& meaning);
  void tell_end(const motion::BlockTag& tag, const motion::Point& end_W);

  // The meaning with the number of the tag, and where its block ends, when its run goes on. An
  // older number than those that are kept: the oldest.
  [[nodiscard]] SituationReport at(const motion::BlockTag& tag);
  // Meanings and ends that are kept.
  [[nodiscard]] std::size_t size();

 private:
  // More than the path queue and the look-ahead hold.
  static constexpr std::size_t blocks_max = 32768;
  // Displays and the recorder ask with outputs of different ages.
  static constexpr std::size_t kept_behind = 8192;
  struct End {
    std::uint64_t block = 0;
    motion::Point end_W{};
  };

  void forget_behind(const motion::BlockTag& tag);

  std::mutex mutex_;
  std::uint32_t run_ = 0;
  std::uint32_t newest_ = 0;
  std::deque<lang::Meaning> meanings_ = std::deque<lang::Meaning>(1);  // the last one is `newest_`
  std::deque<End> ends_;                                               // by block
};

}  // namespace stanok::channels
