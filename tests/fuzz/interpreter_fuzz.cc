// libFuzzer target: any bytes as a program to run, on a mill or a lathe and in a dialect by the
// first byte. Every step is bounded; after a failure there is a diagnostic; numbers in motion are
// finite.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/fuzzed_channel.h"

using namespace stanok;
using namespace stanok::lang;

namespace {

// A loop for ever is a valid program. One that moves nothing computes many statements in a step.
constexpr int steps_max = 3000;
constexpr int working_steps_max = 100;

void check(const Command& command) {
  const Move* const move = move_of(command.payload);
  if (move == nullptr) return;
  for (const double value : move->end) {
    if (!std::isfinite(value)) std::abort();
  }
  if (!std::isfinite(move->feed) || move->feed < 0.0) std::abort();
}

Answer answer_to(const Command& command) {
  Answer answer;
  const auto* const request = std::get_if<ProgramRequest>(&command.payload);
  answer.ok = request == nullptr || request->number % 5 != 4;
  answer.number = 2.0;
  answer.text = "E6006 the machine is off";
  return answer;
}

void run(const ChannelDescription& channel, const Files& files) {
  Diagnostics warnings;
  const auto program = compile("fuzz.nc", files, &channel, warnings);
  if (!program) return;
  fuzz::SomeTables tables;
  Interpreter interpreter(channel, tables, files);
  interpreter.start(*program, {});
  Command command;
  int working_steps = 0;
  for (int step = 0; step < steps_max && working_steps < working_steps_max; ++step) {
    switch (interpreter.next(command)) {
      case Step::command:
        check(command);
        break;
      case Step::working:
        ++working_steps;
        break;
      case Step::waiting:
        interpreter.answer(answer_to(command));
        break;
      case Step::stopped:
      case Step::ended:
        return;
      case Step::failed:
        if (interpreter.error().code.empty()) std::abort();
        return;
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::OneFile files(std::string(reinterpret_cast<const char*>(bytes), size));
  const bool turns = size > 0 && (bytes[0] & 1U) != 0;
  ChannelDescription channel = turns ? fuzz::lathe() : fuzz::mill();
  if (size > 0) channel.rules = fuzz::rules_of(static_cast<std::uint8_t>(bytes[0] >> 1U));
  run(channel, files);
  return 0;
}
