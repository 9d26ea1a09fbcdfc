#include "channels/coordinator/verdict.h"

namespace stanok::channels {

Verdict pending() RT_SAFE {
  Verdict verdict;
  verdict.done = false;
  return verdict;
}

Verdict success(double number) RT_SAFE {
  Verdict verdict;
  verdict.number = number;
  return verdict;
}

Verdict refusal(std::string_view code, std::string_view text) RT_SAFE {
  Verdict verdict;
  verdict.ok = false;
  verdict.code = FixedText<8>(code);
  verdict.text = ReasonText(text);
  return verdict;
}

Verdict refusal_of(int channel, std::string_view code, std::string_view claim) RT_SAFE {
  Verdict verdict = refusal(code, "channel ");
  verdict.text.append(channel).append(claim);
  return verdict;
}

}  // namespace stanok::channels
