// Instructions that act like a block without being one: messages, #feedlaw, #adaptive,
// #tool_overhang, #orientation, #workpiece, and the saved state of save_gvector and
// restore_gvector.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns nothing. Invariant: what changes
// the modal state while the axes may still move is asked first and done with the answer
// (finish_...).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lang/actions/actions.h"
#include "lang/program/code.h"
#include "lang/run/block_state.h"
#include "lang/run/channel_requests.h"
#include "lang/run/pending_answer.h"
#include "lang/run/run_stage.h"
#include "lang/run/vm.h"

namespace stanok::lang {

class BlockDirectives {
 public:
  // All must outlive this.
  BlockDirectives(Vm& vm, RunStage& run, BlockState& state, PendingAnswer& pending,
                  ChannelRequests& requests);

  // Executes one of these; false for other instructions.
  bool execute(const Instruction& instruction);

  // With the answer to what was asked.
  void finish_overhang();
  void finish_restoring();

 private:
  void send_message(const Instruction& instruction);
  void set_feed_law(const Instruction& instruction);
  bool pop_curve(const Instruction& instruction, std::array<std::vector<double>, 3>& numbers);
  void fail_feed_law(BlockFault fault);
  void order_force_control(const Instruction& instruction);
  void ask_overhang(const Instruction& instruction);
  std::optional<ToolOverhang> pop_overhang(const Instruction& instruction);
  void announce_workpiece(const Instruction& instruction);
  void announce_file(const std::string& name, const std::vector<double>& arguments);
  void place_workpiece(const std::vector<double>& arguments);
  bool check_workpiece(const std::vector<double>& arguments);
  bool check_file(const std::vector<double>& arguments, const std::array<double, 3>& size_mm);
  bool check_display(const std::vector<double>& arguments);
  bool refuse_workpiece(const char* message, const char* label);
  void save_gvector();
  void restore_gvector(const Instruction& instruction);

  Vm& vm_;
  RunStage& run_;
  BlockState& state_;
  PendingAnswer& pending_;
  ChannelRequests& requests_;
};

}  // namespace stanok::lang
