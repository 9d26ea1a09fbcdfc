// Instructions that ask something of the channel, the machine or other channels.
//
// Owner: ProgramExecution, on the thread of the preparation. Owns nothing: it checks the values on
// the stack, makes the ProgramRequest, and says in PendingAnswer what its answer is for. Invariant:
// every request emitted here has its use set before.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "lang/program/code.h"
#include "lang/run/block_state.h"
#include "lang/run/pending_answer.h"
#include "lang/run/vm.h"
#include "lang/tree/builtin.h"

namespace stanok::lang {

class ChannelRequests {
 public:
  // All must outlive this.
  ChannelRequests(Vm& vm, BlockState& state, PendingAnswer& pending)
      : vm_(vm), state_(state), pending_(pending) {}

  // Executes one of these; false for other instructions.
  bool execute(const Instruction& instruction);

  // Emits a request of the current instruction, whose answer has its use already.
  void ask(ProgramRequest request);
  void ask(ProgramRequest request, AnswerUse use);

 private:
  // Whether a call may name its own channel.
  enum class OwnChannel : std::uint8_t { allowed, refused };

  std::optional<int> channel_of(double number, OwnChannel own);
  std::optional<int> mark_of(double number);
  void ask_builtin(const Instruction& instruction);
  bool name_arguments(const Builtin& builtin, const Instruction& instruction,
                      ProgramRequest& request);
  void ask_value(const Instruction& instruction);
  void ask_kinematics();
  bool check_own_kinematics();
  void terminate();
  void take_mark(const Instruction& instruction);

  // channel_requests_data.cc: tables of the machine and shared variables
  void ask_table(const Instruction& instruction);
  bool name_offset(std::span<const Value> arguments, ProgramRequest& request, double& unit);
  bool name_tool_value(const Instruction& instruction, std::span<const Value> arguments,
                       ProgramRequest& request, double& unit);
  void read_shared(const Instruction& instruction);
  void send_shared(const Instruction& instruction);
  bool pop_shared_element(const Instruction& instruction, ProgramRequest& request);

  Vm& vm_;
  BlockState& state_;
  PendingAnswer& pending_;
};

}  // namespace stanok::lang
