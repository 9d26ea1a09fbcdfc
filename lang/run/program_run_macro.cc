// Calls of macros: G65 and the user codes of the machine file.
#include <algorithm>
#include <utility>

#include "lang/block/macro_arguments.h"
#include "lang/run/program_run.h"

namespace stanok::lang {

// The macro that the block at hand calls. While a macro of a user code runs, the same code is the
// built-in one.
std::optional<MacroCode> ProgramRun::macro_at_hand() const {
  auto macro = macro_of(words_, channel_words_.dialect());
  if (!macro || macro->user_code == nullptr) return macro;
  const bool runs = std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
    return frame.context && frame.context->user_code == macro->user_code;
  });
  return runs ? std::nullopt : macro;
}

void ProgramRun::call_macro(const MacroCode& macro) {
  if (macro.user_code != nullptr) return call_user_code(macro);
  const auto place = named_program(650);
  if (!place || place->repeats == 0 || !check_call_depth()) return;
  Frame frame = numbered_frame(*place);
  frame.context->arguments = arguments_of(words_, macro);
  frame.context->of_caller = exchange_local_parameters(parameters_of(*frame.context->arguments));
  frames_.push_back(std::move(frame));
}

void ProgramRun::call_user_code(const MacroCode& macro) {
  const UserCode& code = *macro.user_code;
  const auto found = program_->file_by_macro.find(code.program);
  if (found == program_->file_by_macro.end()) {
    return fail("E7005", "\"" + code.program + "\" is not part of this program",
                "a computed code calls only macros that stand in the text too");
  }
  if (!check_call_depth()) return;
  Frame frame = subprogram_frame(found->second);
  if (code.function.empty()) {
    renew_file_variables(frame);
  } else if (!enter_function(frame, code.function)) {
    return fail("E7005",
                "\"" + code.program + "\" has no function " + code.function +
                    " without parameters and result",
                "the macro of this code");
  }
  frame.context->arguments = arguments_of(words_, macro);
  frame.context->of_caller = exchange_local_parameters(parameters_of(*frame.context->arguments));
  frame.context->user_code = macro.user_code;
  frames_.push_back(std::move(frame));
}

// Makes `frame` that of a function of its file which takes and returns nothing.
bool ProgramRun::enter_function(Frame& frame, const std::string& name) {
  const CompiledFile& text = *program_->files[frame.file];
  const auto found = text.function_by_name.find(name);
  if (found == text.function_by_name.end()) return false;
  const FunctionCode& function = text.functions[found->second];
  if (!function.signature.parameters.empty() || function.signature.result != Type::none) {
    return false;
  }
  frame.function = &function;
  frame.position = function.entry;
  slots_.resize(slots_.size() + function.slots);
  return true;
}

ProgramRun::LocalParameters ProgramRun::parameters_of(const BlockWords& arguments) const {
  LocalParameters parameters = fresh_local_parameters();
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const int number = parameter_of_argument(letter);
    if (number == 0 || !arguments.has(letter)) continue;
    parameters.numbered[static_cast<std::size_t>(number - 1)] = arguments.value(letter);
  }
  return parameters;
}

// Those of the macro that runs, in functions it calls too.
const BlockWords* ProgramRun::arguments_at_hand() const {
  for (auto frame = frames_.rbegin(); frame != frames_.rend(); ++frame) {
    if (frame->context && frame->context->arguments) return &*frame->context->arguments;
  }
  return nullptr;
}

// arg ("X"), has_arg ("X")
void ProgramRun::push_argument(bool asks_for_presence) {
  const Value name = pop();
  const BlockWords* const arguments = arguments_at_hand();
  const auto value = arguments != nullptr ? find_argument(*arguments, text_of(name)) : std::nullopt;
  if (asks_for_presence) return push(value_of(value.has_value()));
  if (value) return push(value_of(*value));
  fail("E3019", "the macro was called without `" + text_of(name) + "`",
       arguments != nullptr ? "not among its arguments" : "no macro runs here");
}

}  // namespace stanok::lang
