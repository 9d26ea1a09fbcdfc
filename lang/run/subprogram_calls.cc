#include "lang/run/subprogram_calls.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/actions/modal_restore.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

// M98 P30100 is three calls of O100 (P of 5 to 8 digits, the last four are the program).
constexpr int numbers_per_repeat = 10000;

}  // namespace

SubprogramCalls::SubprogramCalls(Vm& vm, BlockState& state, ParameterStore& parameters)
    : vm_(vm), state_(state), parameters_(parameters) {}

bool SubprogramCalls::execute(const Instruction& instruction) {
  switch (instruction.op) {
    case Op::call:
      call_function(vm_.file().callees[instruction.operand]);
      return true;
    case Op::return_value:
    case Op::return_nothing:
      return_from_function(instruction);
      return true;
    case Op::call_o_sub:
      call_o_subprogram(instruction);
      return true;
    case Op::return_from_o_sub: {
      std::optional<double> value;
      if (instruction.count != 0) value = vm_.stack().pop_number();
      return_from_o_subprogram(value);
      return true;
    }
    case Op::call_file:
      call_file();
      return true;
    case Op::argument:
      push_argument(instruction);
      return true;
    default:
      return false;
  }
}

void SubprogramCalls::call_function(const Callee& callee) {
  if (!vm_.check_call_depth()) return;
  const FunctionCode& function = vm_.program().files[callee.file]->functions[callee.function];
  CallFrame frame = vm_.frame_at_top(callee.file);
  frame.position = function.entry;
  frame.function = &function;
  frame.stack -= function.signature.parameters.size();
  vm_.add_slots(function);
  vm_.take_arguments(frame);
  vm_.enter(std::move(frame));
}

void SubprogramCalls::return_from_function(const Instruction& instruction) {
  if (instruction.op == Op::return_nothing) return pop_frame();
  Value result = vm_.stack().pop();
  pop_frame();
  vm_.stack().push(std::move(result));
}

// Leaves the innermost call; what it had for itself is gone.
void SubprogramCalls::pop_frame() {
  leave_state_level(vm_.frames().size() - 1);
  CallFrame& frame = vm_.frame();
  if (frame.context && frame.context->of_caller) {
    LocalParameters left = parameters_.exchange_locals(std::move(*frame.context->of_caller));
    const bool modal = frame.context->modal_call && modal_ && std::exchange(modal_->runs, false);
    if (modal && modal_->macro.number == g(66)) modal_->locals = std::move(left);
  }
  vm_.leave();
}

// The call of `level` returns: what M73 saved in it holds again.
void SubprogramCalls::leave_state_level(std::size_t level) {
  const auto saved = state_.states.leave(level);
  if (!saved) return;
  const std::string_view reason = reason_against_restoring(state_.modal, *saved, state_of_m70);
  if (!reason.empty()) {
    return vm_.fail("E4014", "the state saved by M73 cannot be restored", std::string(reason));
  }
  ActiveBlock block = state_.block_at(vm_.span().line);
  restore_state(block, *saved, state_of_m70);
}

// O... call: the arguments are #1, #2, ... of the subprogram; those left out are 0.
void SubprogramCalls::call_o_subprogram(const Instruction& instruction) {
  const auto callee = called_o_subprogram(vm_.file().o_calls[instruction.operand]);
  if (!callee || !vm_.check_call_depth()) return;
  LocalParameters locals = parameters_.fresh_locals(rules_of(callee->file));
  for (std::size_t i = instruction.count; i-- > 0;) locals.numbered[i] = vm_.stack().pop_number();
  const FunctionCode& function = vm_.program().files[callee->file]->functions[callee->function];
  CallFrame frame = subprogram_frame(callee->file);
  frame.position = function.entry;
  frame.function = &function;
  vm_.add_slots(function);
  frame.context->of_caller = parameters_.exchange_locals(std::move(locals));
  parameters_.set_returned_value(std::nullopt);
  vm_.enter(std::move(frame));
}

// The subprogram of a call; the number of a computed one stands on the stack.
std::optional<Callee> SubprogramCalls::called_o_subprogram(const OCallCode& call) {
  if (!call.computed) return call.callee;
  const auto number = vm_.pop_integer("the number of a subprogram");
  if (!number) return std::nullopt;
  const std::string label = std::to_string(*number);
  if (auto found = find_o_subprogram(vm_.program(), vm_.frame().file, label)) return found;
  vm_.fail("E7005", "there is no subprogram O" + label, "not in this file, nor in an included one");
  return std::nullopt;
}

void SubprogramCalls::return_from_o_subprogram(std::optional<double> value) {
  parameters_.set_returned_value(value);
  pop_frame();
}

CallFrame SubprogramCalls::subprogram_frame(std::uint16_t of_file) const {
  CallFrame frame = vm_.frame_at_top(of_file);
  frame.subprogram = true;
  frame.context = std::make_unique<CallContext>();
  return frame;
}

// call ("file"): its variables and local parameters are its own.
void SubprogramCalls::call_file() {
  const Value name = vm_.stack().pop();
  const auto& known = vm_.program().file_by_name;
  const auto found = known.find({vm_.frame().file, text_of(name)});
  if (found == known.end()) {
    return vm_.fail("E7005", "\"" + text_of(name) + "\" is not part of this program",
                    "unknown subprogram");
  }
  if (!vm_.check_call_depth()) return;
  CallFrame frame = subprogram_frame(found->second);
  vm_.renew_file_variables(frame);
  frame.context->of_caller =
      parameters_.exchange_locals(parameters_.fresh_locals(rules_of(found->second)));
  vm_.enter(std::move(frame));
}

void SubprogramCalls::call_numbered(CodeNumber code) {
  const auto call = numbered_call(code);
  if (!call || call->repeats == 0 || !vm_.check_call_depth()) return;
  vm_.enter(numbered_frame(*call));
}

// What P and L of M98, M198 or G65 name; nothing after a failure.
std::optional<SubprogramCalls::NumberedCall> SubprogramCalls::numbered_call(CodeNumber code) {
  const BlockWords& words = state_.words;
  const double number = words.value('P');
  const double repeats = words.has('L') ? words.value('L') : 1.0;
  if (!is_integer(number) || !is_integer(repeats) || repeats < 0.0) {
    vm_.fail("E3010", "P and L of a subprogram call are whole numbers", "not a whole number");
    return std::nullopt;
  }
  NumberedCall call;
  call.number = static_cast<int>(std::lround(number));
  call.repeats = static_cast<int>(std::lround(repeats));
  NumberedProgramSearch search = find_numbered(code, call.number);
  const bool counts = code == m(98) && call.number >= numbers_per_repeat && !words.has('L');
  if (!search.place && !search.rivals && counts) {
    call.repeats = call.number / numbers_per_repeat;
    call.number %= numbers_per_repeat;
    search = find_numbered(code, call.number);
  }
  if (search.rivals) return std::nullopt;
  if (!search.place) {
    vm_.fail("E7005", "there is no program O" + std::to_string(call.number),
             code == m(198)
                 ? "no file of that number"
                 : "not in this file, nor in an included one, nor a file of that number");
    return std::nullopt;
  }
  call.place = *search.place;
  return call;
}

// Fails the run when two included files have the number.
NumberedProgramSearch SubprogramCalls::find_numbered(CodeNumber code, int number) {
  const SearchedTexts texts = code == m(198) ? SearchedTexts::files_only : SearchedTexts::all;
  NumberedProgramSearch search =
      find_numbered_program(vm_.program(), vm_.frame().file, number, texts);
  if (!search.rivals) return search;
  const auto& files = vm_.program().files;
  Diagnostic diagnostic =
      vm_.diagnostic("E7006", "O" + std::to_string(number) + " is in two included files",
                     "it is not clear which one is meant");
  diagnostic.notes.push_back({"in " + files[search.rivals->first]->source.name() + " and in " +
                                  files[search.rivals->second]->source.name(),
                              {}});
  vm_.fail_with(std::move(diagnostic));
  return search;
}

CallFrame SubprogramCalls::numbered_frame(const NumberedCall& call) {
  CallFrame frame = subprogram_frame(call.place.file);
  frame.position = call.place.position;
  frame.entry = call.place.position;
  frame.program_number = call.number;
  frame.repeats = call.repeats - 1;
  if (call.place.other_file) vm_.renew_file_variables(frame);
  return frame;
}

std::optional<MacroCode> SubprogramCalls::macro_of_block() const {
  auto macro = macro_of(state_.words, state_.channel_words.dialect());
  if (!macro || macro->user_code == nullptr) return macro;
  const auto& frames = vm_.frames();
  const bool runs = std::any_of(frames.begin(), frames.end(), [&](const CallFrame& frame) {
    return frame.context && frame.context->user_code == macro->user_code;
  });
  return runs ? std::nullopt : macro;
}

void SubprogramCalls::call_macro(const MacroCode& macro) {
  if (macro.user_code != nullptr) return call_user_code(macro);
  if (macro.number != g(65)) return make_modal(macro);
  const auto call = numbered_call(g(65));
  if (!call || call->repeats == 0 || !vm_.check_call_depth()) return;
  CallFrame frame = numbered_frame(*call);
  give_arguments(frame, state_.words, macro);
  vm_.enter(std::move(frame));
}

void SubprogramCalls::make_modal(const MacroCode& macro) {
  if (modal_) {
    return vm_.fail("E4013", "a macro is already called for each block", "end it with `G67`");
  }
  const auto call = numbered_call(g(65));
  if (call) modal_ = ModalCall{*call, macro, state_.words, {}, false};
  state_.calls_modal = modal_.has_value();
}

void SubprogramCalls::end_modal() {
  modal_.reset();
  state_.calls_modal = false;
}

bool SubprogramCalls::modal_call_runs() const {
  return std::ranges::any_of(vm_.frames(), [](const CallFrame& frame) {
    return frame.context && frame.context->modal_call;
  });
}

bool SubprogramCalls::calls_behind_moves() const {
  return modal_ && modal_->macro.number == g(66) && !modal_call_runs();
}

bool SubprogramCalls::calls_for_blocks() const {
  return modal_ && modal_->macro.number == g(66, 1) && !state_.words.g.has(g(67)) &&
         !modal_call_runs();
}

void SubprogramCalls::call_modal() {
  if (modal_->call.repeats == 0 || !vm_.check_call_depth()) return;
  CallFrame frame = numbered_frame(modal_->call);
  const bool each = modal_->macro.number == g(66, 1);
  give_arguments(frame, each ? state_.words : modal_->words, modal_->macro);
  if (modal_->locals) parameters_.exchange_locals(*modal_->locals);
  modal_->runs = true;
  frame.context->modal_call = true;
  frame.context->plain_of_caller = std::exchange(vm_.plain(), {});
  vm_.enter(std::move(frame));
}

void SubprogramCalls::call_block(int repeats, int block) {
  if (!vm_.check_call_depth()) return;
  const CallFrame& caller = vm_.frame();
  CallFrame frame = subprogram_frame(caller.file);
  frame.position = caller.position;
  frame.entry = caller.position;
  frame.program_number = caller.program_number;
  frame.repeats = repeats - 1;
  frame.block = block;
  vm_.enter(std::move(frame));
}

void SubprogramCalls::call_user_code(const MacroCode& macro) {
  const UserCode& code = *macro.user_code;
  const auto& known = vm_.program().file_by_macro;
  const auto found = known.find(code.program);
  if (found == known.end()) {
    return vm_.fail("E7005", "\"" + code.program + "\" is not part of this program",
                    "a computed code can call only macros that the program also calls by name");
  }
  if (!vm_.check_call_depth()) return;
  CallFrame frame = subprogram_frame(found->second);
  if (code.function.empty()) {
    vm_.renew_file_variables(frame);
  } else if (!enter_function(frame, code.function)) {
    return vm_.fail("E7005",
                    "\"" + code.program + "\" has no function " + code.function +
                        " without parameters and result",
                    "the macro of this code");
  }
  give_arguments(frame, state_.words, macro);
  frame.context->user_code = macro.user_code;
  vm_.enter(std::move(frame));
}

// The words of the block are the arguments and the local parameters of the called text.
void SubprogramCalls::give_arguments(CallFrame& frame, const BlockWords& words,
                                     const MacroCode& macro) {
  frame.context->arguments = arguments_of(words, macro);
  frame.context->of_caller =
      parameters_.exchange_locals(parameters_of(*frame.context->arguments, rules_of(frame.file)));
}

// Makes `frame` that of a function of its file which takes and returns nothing.
bool SubprogramCalls::enter_function(CallFrame& frame, const std::string& name) {
  const CompiledFile& text = *vm_.program().files[frame.file];
  const auto found = text.function_by_name.find(name);
  if (found == text.function_by_name.end()) return false;
  const FunctionCode& function = text.functions[found->second];
  if (!function.signature.parameters.empty() || function.signature.result != Type::none) {
    return false;
  }
  frame.function = &function;
  frame.position = function.entry;
  vm_.add_slots(function);
  return true;
}

const TextRules& SubprogramCalls::rules_of(std::uint16_t file) const {
  return vm_.program().files[file]->source.rules();
}

LocalParameters SubprogramCalls::parameters_of(const BlockWords& arguments,
                                               const TextRules& rules) const {
  LocalParameters locals = parameters_.fresh_locals(rules);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const int number = parameter_of_argument(letter);
    if (number == 0 || !arguments.has(letter)) continue;
    locals.numbered[whole_number(number - 1)] = arguments.value(letter);
  }
  for (const NamedWord& word : arguments.named) {
    const int number = parameter_of_repeated(word.name);
    if (number != 0) locals.numbered[whole_number(number - 1)] = word.value;
  }
  return locals;
}

// Those of the macro that runs, in functions it calls too.
const BlockWords* SubprogramCalls::current_arguments() const {
  const auto& frames = vm_.frames();
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    if (frame->context && frame->context->arguments) return &*frame->context->arguments;
  }
  return nullptr;
}

// arg ("X"), has_arg ("X")
void SubprogramCalls::push_argument(const Instruction& instruction) {
  const Value name = vm_.stack().pop();
  const BlockWords* const arguments = current_arguments();
  const auto value = arguments != nullptr ? find_argument(*arguments, text_of(name)) : std::nullopt;
  const bool asks_for_presence = instruction.count != 0;
  if (asks_for_presence) return vm_.stack().push(value_of(value.has_value()));
  if (value) return vm_.stack().push(value_of(*value));
  vm_.fail("E3019", "the macro was called without `" + text_of(name) + "`",
           arguments != nullptr ? "not among its arguments" : "no macro runs here");
}

SubprogramCalls::Left SubprogramCalls::leave_subprogram(Repeats repeats) {
  const auto& frames = vm_.frames();
  std::size_t depth = frames.size();
  while (depth > 1 && !frames[depth - 1].subprogram) --depth;
  if (depth <= 1) return Left::main_program;
  while (frames.size() > depth) pop_frame();
  CallFrame& frame = vm_.frame();
  vm_.plain() = {};
  if (frame.function != nullptr && frame.function->o_subprogram) {
    return_from_o_subprogram(std::nullopt);
  } else if (frame.repeats == 0 || repeats == Repeats::forgotten) {
    pop_frame();
  } else {
    --frame.repeats;
    frame.position = frame.entry;
    vm_.stack().cut_to(frame.stack);
    // There the arguments are set for the first one of the repeats only.
    if (frame.context->arguments && !rules_of(frame.file).is_fanuc()) {
      parameters_.exchange_locals(parameters_of(*frame.context->arguments, rules_of(frame.file)));
    }
    if (frame.block >= 0) return Left::again;
  }
  return Left::subprogram;
}

void SubprogramCalls::begin_again() {
  while (vm_.frames().size() > 1) pop_frame();
  vm_.begin_again();
}

}  // namespace stanok::lang
