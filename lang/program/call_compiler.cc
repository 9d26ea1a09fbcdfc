#include "lang/program/call_compiler.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lang/program/expression_compiler.h"
#include "lang/text/number.h"

namespace stanok::lang {
namespace {

Type type_of_letter(char letter) {
  switch (letter) {
    case 'b':
      return Type::boolean;
    case 's':
      return Type::string;
    case 'a':
      return Type::axis;
    default:
      return Type::number;
  }
}

// How many arguments a call takes.
struct ArgumentCount {
  std::size_t least = 0;
  std::size_t most = 0;
  bool any = false;  // from `least` on
};

// "3 arguments", "1 or 2 arguments", "at least 2 arguments"
std::string expected_count(const ArgumentCount& count) {
  const auto& [least, most, any] = count;
  std::string text = std::to_string(least);
  if (any) text = "at least " + text;
  if (!any && most != least) text += " or " + std::to_string(most);
  return text + (most == 1 && !any ? " argument" : " arguments");
}

}  // namespace

ValueType CallCompiler::compile_call(const Expression& call, Form form) {
  const std::string wanted = folded(call.text);
  if (const Builtin* const builtin = find_builtin(wanted)) {
    return compile_builtin(*builtin, call, form);
  }
  const SymbolTable::NameTest defines = [](const FileNames& names, const std::string& name) {
    return names.functions.contains(name);
  };
  if (symbols_.refuse_ambiguous(call.text, call.span, defines)) return {};
  if (const auto callee = symbols_.find_function(call.text))
    return compile_user_call(*callee, call, form);
  symbols_.report_unknown(call.text, call.span, "function");
  return {};
}

bool CallCompiler::check_argument_count(const Builtin& builtin, const Expression& call) {
  const bool any = builtin.arguments.ends_with('*');
  const std::size_t most = builtin.arguments.size() - (any ? 1 : 0);
  const std::size_t least = most - static_cast<std::size_t>(builtin.optional_arguments);
  const std::size_t given = call.children.size();
  if (given >= least && (given <= most || any) && given <= 255) return true;
  reporter_.error("E3005", call.span,
                  "`" + call.text + "` takes " + expected_count({least, most, any}) + ", not " +
                      std::to_string(given),
                  "the number of arguments is wrong");
  return false;
}

CallCompiler::Arguments CallCompiler::compile_arguments(const Builtin& builtin,
                                                        const Expression& call) {
  Arguments arguments = Arguments::plain;
  const std::size_t most = builtin.arguments.size() - (builtin.arguments.ends_with('*') ? 1 : 0);
  for (std::size_t i = 0; i < call.children.size(); ++i) {
    const char letter = i < most ? builtin.arguments[i] : 'n';
    if (letter == 'x' || letter == 'p') {
      const auto kind = compile_entry_name(call.children[i], letter);
      if (!kind) return Arguments::faulty;
      arguments = *kind == Type::number ? Arguments::entry_by_number : Arguments::plain;
    } else if (!expressions_.require(call.children[i], type_of_letter(letter), "the argument")) {
      return Arguments::faulty;
    }
  }
  return arguments;
}

ValueType CallCompiler::compile_builtin(const Builtin& builtin, const Expression& call, Form form) {
  if (!check_argument_count(builtin, call)) return {};
  if (form == Form::expression && builtin.result == Type::none) {
    reporter_.error("E3004", call.span, "`" + call.text + "` has no value", "a statement only");
    return {};
  }
  const Arguments arguments = compile_arguments(builtin, call);
  if (arguments == Arguments::faulty) return {};
  if (builtin.takes_channel) check_channel_call(builtin, call);
  emit_builtin(builtin, call, form, arguments);
  return {builtin.result, 0};
}

void CallCompiler::emit_builtin(const Builtin& builtin, const Expression& call, Form form,
                                Arguments arguments) {
  const auto row = static_cast<std::uint32_t>(&builtin - builtins().data());
  const auto count = static_cast<std::uint8_t>(call.children.size());
  const bool statement = form == Form::statement && !builtin.failure_code.empty();
  switch (builtin.effect) {
    case Effect::none:
      code_.emit(Op::builtin, call.span, row, count);
      break;
    case Effect::message:
      code_.emit(Op::message, call.span, 0, 0, static_cast<std::uint16_t>(builtin.message));
      break;
    case Effect::request:
      code_.emit(Op::request, call.span, row, count, statement ? 1 : 0);
      break;
    case Effect::terminate:
      code_.emit(Op::terminate, call.span);
      break;
    case Effect::call_file:
      code_.emit(Op::call_file, call.span);
      break;
    case Effect::argument:
      code_.emit(Op::argument, call.span);
      break;
    case Effect::has_argument:
      code_.emit(Op::argument, call.span, 0, 1);
      break;
    case Effect::save_state:
      code_.emit(Op::save_gvector, call.span);
      break;
    case Effect::restore_state:
      code_.emit(Op::restore_gvector, call.span, 0, form == Form::statement ? 1 : 0);
      break;
    case Effect::channel_error:
      code_.emit(Op::channel_error, call.span);
      break;
    case Effect::table:
      code_.emit(Op::table, call.span, row, count,
                 static_cast<std::uint16_t>((statement ? 1 : 0) +
                                            (arguments == Arguments::entry_by_number ? 2 : 0)));
      break;
    case Effect::mark:
    case Effect::mark_wait:
      check_mark_call(call);
      code_.emit(Op::mark, call.span, row, count);
      break;
  }
}

std::optional<int> CallCompiler::constant_channel(const Expression& argument, OwnChannel own,
                                                  std::string_view function) {
  const auto constant = symbols_.constant_of(argument);
  if (!constant || constant->type != Type::number) return std::nullopt;
  if (!is_integer(constant->number)) {
    reporter_.error("E3010", argument.span, "a channel number must be whole", "not a channel");
    return std::nullopt;
  }
  const int id = static_cast<int>(std::lround(constant->number));
  if (context_.channel == nullptr) return id;
  const std::vector<int>& channels = context_.channel->channels;
  if (std::find(channels.begin(), channels.end(), id) == channels.end()) {
    std::string known;
    for (const int channel : channels)
      known += (known.empty() ? "" : ", ") + std::to_string(channel);
    reporter_
        .error("E6001", argument.span, "there is no channel " + std::to_string(id),
               "unknown channel")
        .notes.push_back({"channels of the machine: " + known, {}});
    return std::nullopt;
  }
  if (own == OwnChannel::refused && id == context_.channel->id) {
    reporter_
        .error("E6031", argument.span, "`" + std::string(function) + "` on its own channel",
               "this is the program's own channel")
        .help.push_back("use M0 to stop here, M99 to begin again, or terminate () to end");
    return std::nullopt;
  }
  return id;
}

// What names an entry of a table: an axis, bare or as a string; a tool value, as a string or
// number.
std::optional<Type> CallCompiler::compile_entry_name(const Expression& argument, char letter) {
  if (letter == 'x' && argument.node == Node::axis) {
    code_.push_text(argument.text, argument.span);
    return Type::string;
  }
  const ValueType type = expressions_.compile_expression(argument);
  if (type.is(Type::string) || (letter == 'p' && type.is(Type::number))) return type.type;
  if (type.known()) {
    reporter_.error("E3004", argument.span,
                    letter == 'x' ? "the argument is an axis or its name as a string"
                                  : "the argument is the name or number of a tool value",
                    "a different type");
  }
  return std::nullopt;
}

// Mark and partners, where they are constant.
void CallCompiler::check_mark_call(const Expression& call) {
  const Expression& mark = call.children[0];
  const auto constant = symbols_.constant_of(mark);
  if (constant &&
      (!is_integer(constant->number) || constant->number < 0.0 || constant->number > mark_max)) {
    reporter_.error("E6023", mark.span, "marks are the whole numbers 0 to 199", "not a mark");
  }
  for (std::size_t i = 1; i < call.children.size(); ++i) {
    static_cast<void>(constant_channel(call.children[i], OwnChannel::allowed, call.text));
  }
}

void CallCompiler::check_channel_call(const Builtin& builtin, const Expression& call) {
  const OwnChannel own = builtin.refuses_own_channel ? OwnChannel::refused : OwnChannel::allowed;
  const auto channel = constant_channel(call.children[0], own, builtin.name);
  const bool names_program =
      builtin.request == RequestKind::channel_load || builtin.request == RequestKind::channel_run;
  if (!names_program) return;
  const auto name = symbols_.constant_of(call.children[1]);
  if (!name || name->type != Type::string) return;
  if (!context_.program.file_by_name.contains({context_.file, name->text})) {
    reporter_
        .warning("W710", call.children[1].span,
                 "\"" + name->text + "\" is not included; it is looked for at run time",
                 "it is not part of this program")
        .help.push_back("add `#include \"" + name->text + "\"`");
  }
  if (!channel) return;
  ConstantDispatch dispatch;
  dispatch.kind = builtin.request;
  dispatch.channel = *channel;
  dispatch.program = name->text;
  dispatch.place = file_.source.place(call.span);
  context_.program.dispatches.push_back(std::move(dispatch));
}

ValueType CallCompiler::compile_user_call(const Callee& callee, const Expression& call, Form form) {
  const FunctionSignature& signature =
      context_.program.files[callee.file]->functions[callee.function].signature;
  const std::size_t most = signature.parameters.size();
  const auto least = static_cast<std::size_t>(
      std::count_if(signature.parameters.begin(), signature.parameters.end(),
                    [](const FunctionParameter& parameter) { return !parameter.initial; }));
  const std::size_t given = call.children.size();
  if (given < least || given > most) {
    reporter_.error("E3005", call.span,
                    "`" + call.text + "` takes " + expected_count({least, most, false}) + ", not " +
                        std::to_string(given),
                    "the number of arguments is wrong");
    return {};
  }
  if (form == Form::expression && signature.result == Type::none) {
    reporter_.error("E3004", call.span, "`" + call.text + "` has no value", "a statement only");
    return {};
  }
  for (std::size_t i = 0; i < most; ++i) {
    const FunctionParameter& parameter = signature.parameters[i];
    if (i >= given && parameter.initial) {
      code_.push_constant(symbols_.constant_of(*parameter.initial).value_or(Constant{}), call.span);
    } else if (!compile_argument(parameter, call.children[i])) {
      return {};
    }
  }
  file_.callees.push_back(callee);
  code_.emit(Op::call, call.span, static_cast<std::uint32_t>(file_.callees.size() - 1));
  return {signature.result, 0};
}

bool CallCompiler::compile_argument(const FunctionParameter& parameter,
                                    const Expression& argument) {
  if (parameter.reference && !parameter.array) return compile_reference(parameter, argument);
  if (!parameter.array) {
    return expressions_.require(argument, parameter.type, "argument `" + parameter.name + "`");
  }
  const ValueType type = expressions_.compile_expression(argument);
  if (!type.known()) return false;
  if (type.type == parameter.type && type.dimensions != 0) return true;
  reporter_.error("E3004", argument.span,
                  "argument `" + parameter.name + "` must be an array of " +
                      std::string(type_name(parameter.type)),
                  "not such an array");
  return false;
}

bool CallCompiler::compile_reference(const FunctionParameter& parameter,
                                     const Expression& argument) {
  const Symbol* const symbol = argument.node == Node::name || argument.node == Node::element
                                   ? symbols_.find(argument.text)
                                   : nullptr;
  if (symbol != nullptr && symbol->shared >= 0) {
    reporter_.error("E3004", argument.span, "a shared variable cannot be passed by reference",
                    "use a variable of the program");
    return false;
  }
  if (symbol == nullptr || symbol->read_only) {
    reporter_.error("E3004", argument.span,
                    "argument `" + parameter.name + "` must be a variable, because it is changed",
                    "not a variable");
    return false;
  }
  ValueType type = symbol->type;
  if (argument.node == Node::element) {
    type = expressions_.compile_element_address(argument);
    if (!type.known()) return false;
    code_.emit(Op::element_reference, argument.span, 0,
               static_cast<std::uint8_t>(argument.children.size()));
  } else if (symbol->file_level) {
    code_.emit(Op::reference_file, argument.span, symbol->slot);
  } else {
    // A parameter that is a reference itself is handed on.
    code_.emit(symbol->reference ? Op::load_local : Op::reference_local, argument.span,
               symbol->slot);
  }
  if (type.is(parameter.type)) return true;
  reporter_.error(
      "E3004", argument.span,
      "argument `" + parameter.name + "` must be a " + std::string(type_name(parameter.type)),
      "a different type");
  return false;
}

void CallCompiler::compile(const CallStatement& statement) {
  const ValueType type = compile_call(statement.call, Form::statement);
  if (type.known() && type.type != Type::none) code_.emit(Op::pop, statement.call.span);
}

}  // namespace stanok::lang
