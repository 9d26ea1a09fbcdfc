// LoadDesk: programs, lines and searches that the preparation of a channel is asked to load, and
// what came of the latest one.
//
// Thread: the real-time cycle. Owner: the channel. Invariant: outcome() is pending from a begin
// until the preparation's LoadDone, or a reset.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/rt_safe.h"
#include "channels/cycle/channel_terms.h"
#include "channels/cycle/run_control.h"
#include "channels/messages/channel_link.h"

namespace stanok::channels {

class LoadDesk {
 public:
  // Both outlive the desk.
  LoadDesk(RunControl& run, ChannelLink& link) : run_(run), link_(link) {}

  void begin(const ShortText& text, Job job) RT_SAFE;
  // Where the loaded program begins when it is started the next time.
  void begin_search(const BlockSearch& search) RT_SAFE;
  void take(const LoadDone& load) RT_SAFE;
  // A reset: what was being loaded is given up.
  void end() RT_SAFE;

  [[nodiscard]] Outcome outcome() const RT_SAFE { return outcome_; }
  // Name of what was loaded, or why it was not.
  [[nodiscard]] const ShortText& text() const RT_SAFE { return text_; }
  // The load of the program that is there; 0: none.
  [[nodiscard]] std::int32_t program() const RT_SAFE { return program_; }

  // A run of the program begins, where it was searched for last.
  void begin_run() RT_SAFE;
  // The run has begun at the first block.
  [[nodiscard]] bool runs_whole() const RT_SAFE { return start_ == Start::at_first_block; }
  // It has run to its end, and did so before with the same texts: of the newest programs.
  void note_end() RT_SAFE;
  [[nodiscard]] bool has_run_before() const RT_SAFE;

 private:
  static constexpr std::size_t ended_max = 64;
  enum class Start : std::uint8_t { at_first_block, in_the_middle };

  RunControl& run_;
  ChannelLink& link_;
  std::int32_t begun_ = 0;  // loads of programs
  std::int32_t program_ = 0;
  Job job_ = Job::program;
  Start next_start_ = Start::at_first_block;
  Start start_ = Start::at_first_block;  // of the newest run
  Outcome outcome_ = Outcome::succeeded;
  ShortText text_;
  std::uint64_t digest_ = 0;  // of the program that is there
  std::array<std::uint64_t, ended_max> ended_{};
  std::size_t ended_count_ = 0;  // ever
};

}  // namespace stanok::channels
