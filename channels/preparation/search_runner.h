// SearchRunner: block search: the loaded program is interpreted up to a block and nothing of it is
// executed; then the axes approach and it goes on.
//
// Thread: that of the preparation. Owner: the channel's preparation. Invariant: from its beginning
// to its outcome a search has the interpreter and the feed of the parts for itself.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "channels/messages/notice.h"
#include "channels/preparation/preparation_parts.h"
#include "channels/preparation/program_search.h"

namespace stanok::channels {

class SearchRunner {
 public:
  enum class Result {
    working,
    computing,   // nothing that the cycle could wait for
    found,       // the operator was told; the search waits for the start of the program
    entered,     // the run can go on: its entry first, then the interpreter
    failed,      // see `fault`
    run_failed,  // the same of a search at the beginning of a run
  };

  // The parts outlive the search.
  explicit SearchRunner(PreparationParts& parts) : parts_(parts) {}

  // Looks in `program` for a block.
  [[nodiscard]] Result look(const BlockSearch& search,
                            std::shared_ptr<const lang::Program> program);
  // The run begins where a block was found: is_set() holds, the parts are restarted.
  [[nodiscard]] Result begin_run();
  // Goes on by so many commands at most; is_under_way() holds.
  [[nodiscard]] Result advance(int commands);

  // The next run shall begin in the middle, or it is searched for.
  [[nodiscard]] bool is_set() const { return search_.has_value(); }
  [[nodiscard]] bool is_under_way() const {
    return search_ && search_->stage != ProgramSearch::Stage::found;
  }
  [[nodiscard]] const Diagnostic& fault() const { return fault_; }

  // The next command of an entry in the middle; false: there is none.
  [[nodiscard]] bool next_entry(lang::Command& command);
  void forget_entry() { entry_.clear(); }
  void forget();

 private:
  [[nodiscard]] Result enter(ProgramSearch::Stage stage);
  [[nodiscard]] Result fail(const Diagnostic& fault);
  [[nodiscard]] Result arrive();
  [[nodiscard]] std::optional<Diagnostic> pass(const lang::Command& command);
  [[nodiscard]] std::optional<Diagnostic> pass_request(const lang::Command& command,
                                                       const lang::ProgramRequest& request);
  [[nodiscard]] std::optional<lang::Answer> answer_of_tables(
      const lang::ProgramRequest& request) const;
  [[nodiscard]] std::optional<Diagnostic> obstacle_at_target() const;
  void note_motion(const lang::Command& command, const motion::Point& start_W);
  [[nodiscard]] Approach approach_to_target(const motion::Point& target) const;
  [[nodiscard]] motion::Point out_along_tool(const motion::Point& point_W, int infeed) const;
  [[nodiscard]] bool is_within_travel(const std::optional<motion::Point>& point_W) const;
  [[nodiscard]] SearchReport report(const motion::Point& target);
  void approach(const motion::Point& target);
  void enter_leg(const std::optional<motion::Point>& end, motion::Point& before,
                 lang::Command command, double feed_mm_min);

  PreparationParts& parts_;
  std::optional<ProgramSearch> search_;
  std::deque<lang::Command> entry_;
  Diagnostic fault_;
  std::uint32_t searches_ = 0;   // so far
  std::uint32_t situation_ = 0;  // when the newest one was asked for
};

}  // namespace stanok::channels
