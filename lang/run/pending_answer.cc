#include "lang/run/pending_answer.h"

#include <algorithm>
#include <utility>

#include "lang/text/source.h"

namespace stanok::lang {
namespace {

// The text of an answer may begin with the code of its reason, and have notes on further lines.
PendingAnswer::Refusal refusal_of(std::string_view code, const Answer& answer) {
  PendingAnswer::Refusal refusal;
  const std::string_view whole = answer.text;
  const std::string_view text = whole.substr(0, whole.find('\n'));
  const std::size_t blank = text.find(' ');
  const bool coded = text.size() > 2 && (text[0] == 'E' || text[0] == 'A') && is_digit(text[1]) &&
                     blank != std::string_view::npos;
  if (coded) {
    refusal.code = text.substr(0, blank);
    refusal.message = text.substr(blank + 1);
  } else {
    refusal.code = code;
    refusal.message = text.empty() ? "the channel refused this" : text;
  }
  for (std::size_t end = text.size(); end < whole.size();) {
    const std::size_t begin = end + 1;
    end = std::min(whole.find('\n', begin), whole.size());
    refusal.notes.push_back({std::string(whole.substr(begin, end - begin)), {}});
  }
  return refusal;
}

}  // namespace

void PendingAnswer::reset() {
  owed_ = false;
  use_ = AnswerUse::position_only;
  channel_error_.clear();
}

void PendingAnswer::expect_number(double unit, double shift) {
  use_ = AnswerUse::push_number;
  unit_ = unit;
  shift_ = shift;
}

void PendingAnswer::expect_statement(const Statement& statement) {
  use_ = AnswerUse::statement;
  statement_ = statement;
}

void PendingAnswer::expect_restoring(Restoring restoring) {
  use_ = AnswerUse::restore_state;
  restoring_ = std::move(restoring);
}

void PendingAnswer::expect_overhang(const ToolOverhang& overhang) {
  use_ = AnswerUse::overhang;
  overhang_ = overhang;
}

void PendingAnswer::expect_end(Diagnostic error) {
  use_ = AnswerUse::fail_run;
  end_ = std::move(error);
}

void PendingAnswer::deliver(const ProgramRequest& request, const Origin& origin) {
  owed_ = true;
  origin_ = origin;
  if (request.kind == RequestKind::input_wait) {
    use_ = request.statement ? AnswerUse::feedback : AnswerUse::input_result;
    feedback_ = {request.number, request.index == 3, request.seconds};
  }
  if (request.kind == RequestKind::probe_result)
    use_ = request.statement ? AnswerUse::probe_or_alarm : AnswerUse::probe;
}

bool PendingAnswer::accept() {
  return std::exchange(owed_, false);
}

PendingAnswer::Taken PendingAnswer::take(const Answer& answer) {
  if (!answer.ok && answer.raises) return {{}, refusal_of("E5010", answer)};
  const AnswerUse use = std::exchange(use_, AnswerUse::position_only);
  switch (use) {
    case AnswerUse::position_only:
      if (!answer.ok) return {{}, refusal_of("E5010", answer)};
      return {};
    case AnswerUse::push_truth:
      return take_truth(answer);
    case AnswerUse::push_number:
      return take_number(answer);
    case AnswerUse::push_text:
      return {value_of(answer.text), {}};
    case AnswerUse::statement:
      return take_statement(answer);
    case AnswerUse::input_result:
    case AnswerUse::feedback:
    case AnswerUse::restore_state:
    case AnswerUse::fail_run:
    case AnswerUse::probe:
    case AnswerUse::probe_or_alarm:
    case AnswerUse::restart:
    case AnswerUse::overhang:
    case AnswerUse::work_position:
    case AnswerUse::timer:
      return {{}, {}, use};
  }
  return {};
}

PendingAnswer::Taken PendingAnswer::take_truth(const Answer& answer) {
  channel_error_ = answer.ok ? "" : answer.text;
  return {value_of(answer.ok), {}};
}

PendingAnswer::Taken PendingAnswer::take_number(const Answer& answer) {
  const double unit = std::exchange(unit_, 1.0);
  if (!answer.ok) return {{}, refusal_of("E6032", answer)};
  return {value_of(answer.number / unit + std::exchange(shift_, 0.0)), {}};
}

// A statement whose value nobody reads: a false result must not be lost.
PendingAnswer::Taken PendingAnswer::take_statement(const Answer& answer) {
  Taken taken{value_of(answer.ok), {}};
  if (answer.ok) return taken;
  channel_error_ = answer.text;
  taken.refusal = Refusal{std::string(statement_.code),
                          "`" + std::string(statement_.name) + "` failed: " + answer.text,
                          "returned false",
                          {}};
  return taken;
}

}  // namespace stanok::lang
