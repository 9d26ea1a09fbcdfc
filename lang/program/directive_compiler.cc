#include "lang/program/directive_compiler.h"

#include <utility>

namespace stanok::lang {

void DirectiveCompiler::compile(const WorkpieceDirective& directive) {
  for (const Expression& argument : directive.arguments) {
    if (!expressions_.require(argument, Type::number, "the argument")) return;
  }
  const auto count = static_cast<std::uint8_t>(directive.arguments.size());
  if (directive.file.empty()) {
    code_.emit(Op::workpiece, code_.statement_span(), 0, count, directive.position ? 1 : 0);
    return;
  }
  // Where there is none the loader has said so.
  if (!context_.program.blanks.contains({context_.file, directive.file})) return;
  file_.texts.push_back(directive.file);
  code_.emit(Op::workpiece, code_.statement_span(),
             static_cast<std::uint32_t>(file_.texts.size() - 1), count, 2);
}

void DirectiveCompiler::compile(const ToolOverhangDirective& directive) {
  const auto& arguments = directive.arguments;
  if (!arguments.empty() && !expressions_.require(arguments[0], Type::number, "the overhang"))
    return;
  if (arguments.size() == 2 && !expressions_.require(arguments[1], Type::axis, "the radial axis"))
    return;
  code_.emit(Op::tool_overhang, code_.statement_span(), 0,
             static_cast<std::uint8_t>(arguments.size()));
}

void DirectiveCompiler::compile(const AdaptiveDirective& directive) {
  for (const Expression& argument : directive.arguments) {
    if (!expressions_.require(argument, Type::number, "a value of force control")) return;
  }
  code_.emit(Op::adaptive, code_.statement_span(), 0,
             static_cast<std::uint8_t>(directive.arguments.size()),
             static_cast<std::uint16_t>(directive.kind));
}

void DirectiveCompiler::compile(const OrientationDirective& directive) {
  code_.emit(Op::orientation, code_.statement_span(), 0, 0,
             static_cast<std::uint16_t>(directive.way));
}

void DirectiveCompiler::compile(const FeedLawDirective& directive) {
  for (const Expression& array : directive.arguments) {
    const ValueType type = expressions_.compile_expression(array);
    if (!type.known()) return;
    if (type.type == Type::number && type.dimensions != 0) continue;
    reporter_.error("E3004", array.span, "a curve takes arrays of num", "not such an array");
    return;
  }
  code_.emit(Op::feed_law, code_.statement_span(), 0,
             static_cast<std::uint8_t>(directive.arguments.size()));
}

void DirectiveCompiler::compile(const KinematicsDirective& directive) {
  const Expression& scheme = directive.arguments[0];
  const Expression& channel = directive.arguments[1];
  const bool good = expressions_.require(scheme, Type::number, "the scheme") &&
                    expressions_.require(channel, Type::number, "the channel");
  if (!good) return;
  code_.emit(Op::kinematics, code_.statement_span());
  const auto target =
      expressions_.calls().constant_channel(channel, OwnChannel::allowed, "#kinematics");
  if (target) note_dispatch(*target, scheme);
}

// Scheme and channel that are constant are known before the program runs, and can be checked.
void DirectiveCompiler::note_dispatch(int channel, const Expression& scheme) {
  const auto number = symbols_.constant_of(scheme);
  if (!number) return;
  ConstantDispatch dispatch;
  dispatch.kind = RequestKind::kinematics;
  dispatch.channel = channel;
  dispatch.scheme = static_cast<int>(number->number);
  dispatch.place = file_.source.place(code_.statement_span());
  context_.program.dispatches.push_back(dispatch);
  if (context_.channel == nullptr || number->number == 0.0) return;
  std::string known;
  for (const auto& [of, id] : context_.channel->schemes) {
    if (of != channel) continue;
    if (id == number->number) return;
    known += (known.empty() ? "" : ", ") + std::to_string(id);
  }
  Diagnostic& diagnostic =
      reporter_.error("E5201", scheme.span,
                      "channel " + std::to_string(channel) + " has no kinematic scheme " +
                          std::string(file_.source.text(scheme.span)),
                      "unknown scheme");
  if (!known.empty()) diagnostic.notes.push_back({"schemes of this channel: " + known, {}});
}

}  // namespace stanok::lang
