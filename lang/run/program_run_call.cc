// Calls of functions, O-subprograms, numbered programs and files, and the way back.
#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/run/program_run.h"
#include "lang/text/limits.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

// M98 P30100 is three calls of O100 (P of 5 to 8 digits, the last four are the program).
constexpr int numbers_per_repeat = 10000;

}  // namespace

bool ProgramRun::check_call_depth() {
  if (frames_.size() <= limits::call_depth) return true;
  fail("E8001", "more than 64 nested calls", "one call too many");
  return false;
}

void ProgramRun::call_function(const Callee& callee) {
  if (!check_call_depth()) return;
  const FunctionCode& function = program_->files[callee.file]->functions[callee.function];
  Frame frame;
  frame.file = callee.file;
  frame.position = function.entry;
  frame.slots = slots_.size();
  frame.function = &function;
  frame.stack = stack_.size() - function.signature.parameters.size();
  slots_.resize(slots_.size() + function.slots);
  for (std::size_t i = function.signature.parameters.size(); i-- > 0;) {
    slots_[frame.slots + i] = pop();
  }
  frames_.push_back(std::move(frame));
}

void ProgramRun::return_from_function(bool with_value) {
  Value result;
  if (with_value) result = pop();
  pop_frame();
  if (with_value) push(std::move(result));
}

// Leaves the innermost call; what it had for itself is gone.
void ProgramRun::pop_frame() {
  leave_state_level(frames_.size() - 1);
  Frame& frame = frames_.back();
  slots_.resize(frame.slots);
  stack_.resize(frame.stack);
  if (frame.context) {
    if (frame.context->file_slots_before) {
      file_slots_[frame.file] = *frame.context->file_slots_before;
    }
    if (frame.context->of_caller) {
      exchange_local_parameters(std::move(*frame.context->of_caller));
    }
  }
  frames_.pop_back();
}

// O... call: the arguments are #1, #2, ... of the subprogram; those left out are 0.
void ProgramRun::call_o_subprogram(const Instruction& instruction) {
  const auto callee = find_o_subprogram(file().o_calls[instruction.operand]);
  if (!callee || !check_call_depth()) return;
  LocalParameters parameters = fresh_local_parameters();
  for (std::size_t i = instruction.count; i-- > 0;) parameters.numbered[i] = pop_number();
  const FunctionCode& function = program_->files[callee->file]->functions[callee->function];
  Frame frame = subprogram_frame(callee->file);
  frame.position = function.entry;
  frame.function = &function;
  slots_.resize(slots_.size() + function.slots);
  frame.context->of_caller = exchange_local_parameters(std::move(parameters));
  o_value_ = 0.0;
  o_value_returned_ = false;
  frames_.push_back(std::move(frame));
}

// The subprogram of a call; the number of a computed one stands on the stack.
std::optional<Callee> ProgramRun::find_o_subprogram(const OCallCode& call) {
  if (!call.computed) return call.callee;
  const auto number = pop_integer("the number of a subprogram");
  if (!number) return std::nullopt;
  const std::string label = std::to_string(*number);
  std::vector<std::uint16_t> candidates{frames_.back().file};
  candidates.insert(candidates.end(), file().includes.begin(), file().includes.end());
  for (const std::uint16_t candidate : candidates) {
    const auto& known = program_->files[candidate]->o_subprograms;
    const auto found = known.find(label);
    if (found != known.end()) return Callee{candidate, found->second};
  }
  fail("E7005", "there is no subprogram O" + label, "not in this file, nor in an included one");
  return std::nullopt;
}

void ProgramRun::return_from_o_subprogram(bool with_value) {
  o_value_ = with_value ? pop_number() : 0.0;
  o_value_returned_ = with_value;
  pop_frame();
}

ProgramRun::Frame ProgramRun::subprogram_frame(std::uint16_t of_file) const {
  Frame frame;
  frame.file = of_file;
  frame.slots = slots_.size();
  frame.stack = stack_.size();
  frame.subprogram = true;
  frame.context = std::make_unique<CallContext>();
  return frame;
}

// The file's variables are new for this call.
void ProgramRun::renew_file_variables(Frame& frame) {
  frame.context->file_slots_before = file_slots_[frame.file];
  file_slots_[frame.file] = slots_.size();
  slots_.resize(slots_.size() + program_->files[frame.file]->file_slots);
}

// call ("file"): its variables and local parameters are its own.
void ProgramRun::call_file() {
  const Value name = pop();
  const auto found = program_->file_by_name.find({frames_.back().file, text_of(name)});
  if (found == program_->file_by_name.end()) {
    return fail("E7005", "\"" + text_of(name) + "\" is not part of this program",
                "unknown subprogram");
  }
  if (!check_call_depth()) return;
  Frame frame = subprogram_frame(found->second);
  renew_file_variables(frame);
  frame.context->of_caller = exchange_local_parameters(fresh_local_parameters());
  frames_.push_back(std::move(frame));
}

// M98 P L and M198 P L: #1 to #30 are those of the caller.
void ProgramRun::call_numbered(CodeNumber code) {
  const auto place = named_program(code);
  if (!place || place->repeats == 0 || !check_call_depth()) return;
  frames_.push_back(numbered_frame(*place));
}

// What P and L of M98, M198 or G65 name; nothing after a failure.
std::optional<ProgramRun::NumberedProgramPlace> ProgramRun::named_program(CodeNumber code) {
  const double number = words_.value('P');
  const double repeats = words_.has('L') ? words_.value('L') : 1.0;
  if (!is_integer(number) || !is_integer(repeats) || repeats < 0.0) {
    fail("E3010", "P and L of a subprogram call are whole numbers", "not a whole number");
    return std::nullopt;
  }
  const bool only_files = code == m(198);
  int program = static_cast<int>(std::lround(number));
  int count = static_cast<int>(std::lround(repeats));
  auto place = find_numbered(program, only_files);
  const bool counts = code == m(98) && program >= numbers_per_repeat && !words_.has('L');
  if (!place && counts && phase_ != Phase::failed) {
    count = program / numbers_per_repeat;
    program %= numbers_per_repeat;
    place = find_numbered(program, only_files);
  }
  if (phase_ == Phase::failed) return std::nullopt;
  if (!place) {
    fail("E7005", "there is no program O" + std::to_string(program),
         only_files ? "no file of that number"
                    : "not in this file, nor in an included one, nor a file of that number");
    return std::nullopt;
  }
  place->number = program;
  place->repeats = count;
  return place;
}

ProgramRun::Frame ProgramRun::numbered_frame(const NumberedProgramPlace& place) {
  Frame frame = subprogram_frame(place.file);
  frame.position = place.position;
  frame.entry = place.position;
  frame.program_number = place.number;
  frame.repeats = place.repeats - 1;
  if (place.other_file) renew_file_variables(frame);
  return frame;
}

// In this file, then in the included ones (once), then the file of that number.
std::optional<ProgramRun::NumberedProgramPlace> ProgramRun::find_numbered(int number,
                                                                          bool only_files) {
  const std::uint16_t own = frames_.back().file;
  const auto place_of = [](std::uint16_t in_file, std::uint32_t position) {
    NumberedProgramPlace place;
    place.file = in_file;
    place.position = position;
    return place;
  };
  const auto look_in = [&](std::uint16_t candidate) -> std::optional<NumberedProgramPlace> {
    const auto& programs = program_->files[candidate]->numbered_programs;
    const auto found = programs.find(number);
    if (found == programs.end()) return std::nullopt;
    return place_of(candidate, found->second);
  };
  std::optional<NumberedProgramPlace> hit;
  if (!only_files) {
    hit = look_in(own);
    if (hit) return hit;
    for (const std::uint16_t candidate : file().includes) {
      const auto found = look_in(candidate);
      if (!found || (hit && hit->file == candidate)) continue;
      if (hit) {
        fail("E7006", "O" + std::to_string(number) + " stands in two included files",
             "which one is meant?");
        error_.notes.push_back({"in " + program_->files[hit->file]->source.name() + " and in " +
                                    program_->files[candidate]->source.name(),
                                {}});
        return std::nullopt;
      }
      hit = found;
    }
    if (hit) return hit;
  }
  const auto file_found = program_->file_by_number.find({own, number});
  if (file_found == program_->file_by_number.end()) return std::nullopt;
  hit = look_in(file_found->second);
  if (!hit) hit = place_of(file_found->second, 0);
  hit->other_file = true;
  return hit;
}

// M99, M17 or the end of a called text: back to the caller, or once more; the main program begins
// again.
void ProgramRun::leave_subprogram() {
  std::size_t depth = frames_.size();
  while (depth > 1 && !frames_[depth - 1].subprogram) --depth;
  if (depth <= 1) return ask_restart();
  while (frames_.size() > depth) pop_frame();
  Frame& frame = frames_.back();
  plain_ = {};
  if (frame.function != nullptr && frame.function->o_subprogram) {
    return return_from_o_subprogram(false);
  }
  if (frame.repeats == 0) return pop_frame();
  --frame.repeats;
  frame.position = frame.entry;
  stack_.resize(frame.stack);
  if (frame.context->arguments) {
    exchange_local_parameters(parameters_of(*frame.context->arguments));
  }
}

void ProgramRun::ask_restart() {
  if (is_line_) return end_program(ProgramEndKind::restart);
  Request request;
  request.kind = RequestKind::program_restart;
  ask(std::move(request), AnswerUse::restart);
}

// From the first line, in the modal state of the last one.
void ProgramRun::begin_again() {
  while (frames_.size() > 1) pop_frame();
  plain_ = {};
  contour_return_.reset();
  stack_.clear();
  frames_.back().position = 0;
}

}  // namespace stanok::lang
