#include "lang/program/code_builder.h"

#include <utility>

namespace stanok::lang {

std::size_t CodeBuilder::emit(Op op, const Span& span, std::uint32_t operand, std::uint8_t count,
                              std::uint16_t extra) {
  file_.code.push_back({op, count, extra, operand});
  file_.spans.push_back(span);
  return file_.code.size() - 1;
}

void CodeBuilder::push_number(double number, const Span& span) {
  file_.numbers.push_back(number);
  emit(Op::push_number, span, static_cast<std::uint32_t>(file_.numbers.size() - 1));
}

void CodeBuilder::push_text(std::string text, const Span& span) {
  file_.texts.push_back(std::move(text));
  emit(Op::push_text, span, static_cast<std::uint32_t>(file_.texts.size() - 1));
}

void CodeBuilder::push_constant(const Constant& constant, const Span& span) {
  if (constant.type == Type::string) {
    push_text(constant.text, span);
  } else {
    push_number(constant.number, span);
  }
}

std::uint32_t CodeBuilder::position() const {
  return static_cast<std::uint32_t>(file_.code.size());
}

void CodeBuilder::patch(std::size_t jump) {
  file_.code[jump].operand = position();
}

void CodeBuilder::patch_all_to(const std::vector<std::size_t>& jumps, std::uint32_t target) {
  for (const std::size_t jump : jumps) file_.code[jump].operand = target;
}

void CodeBuilder::drop_from(std::size_t start) {
  file_.code.resize(start);
  file_.spans.resize(start);
}

void CodeBuilder::patch_all(const std::vector<std::size_t>& jumps) {
  for (const std::size_t jump : jumps) patch(jump);
}

}  // namespace stanok::lang
