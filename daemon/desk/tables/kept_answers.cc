#include "daemon/desk/tables/kept_answers.h"

#include <utility>

namespace stanok::daemon {

Answer KeptAnswers::behind_disk(Answer answer) {
  return [this, answer = std::move(answer)](const CommandResult& outcome) {
    if (!outcome || !keep_) return answer(outcome);
    keep_([finished = finished_, answer, outcome](const std::optional<std::string>& fault) {
      const std::lock_guard lock(finished->mutex);
      if (!fault) return finished->all.push_back({answer, outcome});
      finished->all.push_back(
          {answer, Unexpected<protocol::Failure>(
                       protocol::Failure{protocol::FailureKind::internal,
                                         "E9025",
                                         "the change is active, but could not be saved: " + *fault,
                                         0,
                                         {}})});
    });
  };
}

void KeptAnswers::tick() {
  std::vector<Done> now;
  {
    const std::lock_guard lock(finished_->mutex);
    now.swap(finished_->all);
  }
  for (const Done& done : now) done.answer(done.outcome);
}

}  // namespace stanok::daemon
