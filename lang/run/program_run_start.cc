// How a run begins: a program with the default modal state, a line with that of the line before.
#include <utility>

#include "lang/actions/actions.h"
#include "lang/run/program_run.h"

namespace stanok::lang {
namespace {

constexpr std::size_t r_parameter_count = 1000;

// A block search passes a text once, whatever its length: a block has at least two bytes.
constexpr std::uint64_t free_steps_of_byte = limits::steps_of_block / 2;

}  // namespace

ProgramRun::ProgramRun(const ChannelDescription& channel, Tables& tables)
    : channel_(channel),
      tables_(tables),
      channel_words_(channel),
      compensation_(channel_words_),
      around_{modal_, channel_words_, channel_, tables_, queue_, probe_, states_, this},
      r_parameters_(r_parameter_count, 0.0) {}

void ProgramRun::reset(std::shared_ptr<const Program> program) {
  keep_channel_parameters();
  program_ = std::move(program);
  queue_.clear();
  compensation_.reset();
  plain_ = {};
  states_.clear();
  contour_return_.reset();
  rest_.reset();
  block_ = 0;
  instructions_ = 0;
  renewed_at_ = 0;
  steps_max_ = channel_.bounds.steps;
  for (const auto& one : program_->files)
    steps_max_ += free_steps_of_byte * one->source.text().size();
  stop_.reset();
  stack_.clear();
  slots_.clear();
  file_slots_.clear();
  frames_.clear();
  for (const auto& one : program_->files) {
    file_slots_.push_back(slots_.size());
    slots_.resize(slots_.size() + one->file_slots);
  }
  begin_parameters();
  frames_.emplace_back();
  frames_.back().slots = slots_.size();
  answer_use_ = AnswerUse::position_only;
  answer_owed_ = false;
  channel_error_.clear();
  error_ = {};
}

void ProgramRun::start(std::shared_ptr<const Program> program, const AxisValues& position_B) {
  reset(std::move(program));
  is_line_ = false;
  line_state_lasts_ = false;
  begin_modal_state(position_B);
  begin();
}

void ProgramRun::start_line(std::shared_ptr<const Program> program, const AxisValues& position_B) {
  reset(std::move(program));
  is_line_ = true;
  if (std::exchange(line_state_lasts_, true)) {
    continue_modal_state(position_B);
  } else {
    begin_modal_state(position_B);
  }
  begin();
}

void ProgramRun::begin_modal_state(const AxisValues& position_B) {
  const int tool_active = modal_.tool_active;
  modal_ = default_modal_state(channel_.kind);
  modal_.tool_active = tool_active;
  modal_.geometry = channel_words_.geometry();
  take_work_offset(modal_, tables_, modal_.work_offset_number);
  modal_.position_W = modal_.frame().work_from_base(position_B);
}

// Tables and axes may have changed since the line before.
void ProgramRun::continue_modal_state(const AxisValues& position_B) {
  read_tables_again();
  modal_.adopt_position(position_B);
}

void ProgramRun::begin() {
  queue_.set_origin({}, 0);
  code_changes_.note(0, modal_.codes);
  queue_.emit(frame_of(modal_));
  queue_.emit(modal_.length);
  phase_ = Phase::running;
}

}  // namespace stanok::lang
