#include "lang/run/interpreter.h"

#include <utility>

#include "lang/run/program_execution.h"

namespace stanok::lang {

struct Interpreter::State {
  State(const ChannelDescription& of_channel, Tables& tables)
      : channel(of_channel), run(channel, tables) {}

  ChannelDescription channel;
  ProgramExecution run;
};

Interpreter::Interpreter(const ChannelDescription& channel, Tables& tables, const Files&)
    : state_(std::make_unique<State>(channel, tables)) {}

Interpreter::~Interpreter() = default;

void Interpreter::start(std::shared_ptr<const Program> program, const AxisValues& position_B) {
  state_->run.start(std::move(program), position_B);
}

void Interpreter::start_line(std::shared_ptr<const Program> line, const AxisValues& position_B) {
  state_->run.start_line(std::move(line), position_B);
}

void Interpreter::start_search(std::shared_ptr<const Program> program, const AxisValues& position_B,
                               const StopPlace& place) {
  state_->run.start(std::move(program), position_B);
  state_->run.stop_before(place);
}

std::optional<Diagnostic> Interpreter::start_at(std::shared_ptr<const Program> program,
                                                const AxisValues& position_B,
                                                const StopPlace& place) {
  return state_->run.start_at(std::move(program), position_B, place);
}

void Interpreter::reset(const ToolInPlace& tool) {
  state_->run.block_runner().stand_in_default();
  state_->run.block_runner().take_tool(tool);
}

void Interpreter::break_off() {
  state_->run.break_off();
}

Meaning Interpreter::standing() const {
  return state_->run.block_runner().standing();
}

void Interpreter::take_tool(const ToolInPlace& tool) {
  state_->run.block_runner().take_tool(tool);
}

void Interpreter::take_changed_rows(const ChangedRows& rows) {
  state_->run.block_runner().take_changed_rows(rows);
}

void Interpreter::follow_lengths() {
  state_->run.block_runner().follow_lengths();
}

Step Interpreter::next(Command& command) {
  return state_->run.next(command);
}

void Interpreter::answer(const Answer& answer) {
  state_->run.answer(answer);
}

const Diagnostic& Interpreter::error() const {
  return state_->run.error();
}

Passed Interpreter::pass_fault() {
  return state_->run.pass_fault();
}

Origin Interpreter::origin() const {
  return state_->run.origin();
}

std::uint64_t Interpreter::steps() const {
  return state_->run.steps();
}

void Interpreter::renew_steps() {
  state_->run.renew_steps();
}

std::uint64_t Interpreter::blocks() const {
  return state_->run.blocks();
}

std::vector<MeaningChange> Interpreter::take_meanings() {
  return state_->run.take_meanings();
}

void Interpreter::set_block_skip(std::uint16_t levels) {
  state_->run.set_block_skip(levels);
}

}  // namespace stanok::lang
