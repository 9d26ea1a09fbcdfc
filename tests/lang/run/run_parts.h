// The small parts that those who execute a program share, put together without a ProgramExecution.
#pragma once

#include "lang/run/block_state.h"
#include "lang/run/parameter_store.h"
#include "lang/run/pending_answer.h"
#include "lang/run/run_stage.h"
#include "lang/run/vm.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {

struct RunParts {
  // The compiled program of a text, before its first instruction.
  void load(const std::string& text) {
    files.texts["main.nc"] = text;
    Diagnostics warnings;
    auto program = compile("main.nc", files, &channel, warnings);
    ASSERT_TRUE(program) << to_text(program.error().front());
    load(*program);
  }
  void load(const std::shared_ptr<const Program>& program) {
    parameters.begin(program);
    vm.begin(program);
    run.begin();
  }
  // Up to the next instruction that the machine does not execute itself.
  const Instruction& next_effect() {
    while (true) {
      if (const Instruction* const other = vm.step()) return *other;
    }
  }
  // The only command in the queue.
  Payload emitted() {
    Command command;
    EXPECT_FALSE(state.queue.empty());
    if (!state.queue.empty()) state.queue.take(command);
    EXPECT_TRUE(state.queue.empty());
    return command.payload;
  }

  MemoryFiles files;
  const ChannelDescription channel = mill_xyzbc();
  MemoryTables tables;
  BlockState state{channel, tables};
  RunStage run{state.queue};
  Vm vm{state.channel_words, run};
  ParameterStore parameters{state.around, vm};
  PendingAnswer pending;
};

}  // namespace stanok::lang::testing
