// KeptAnswers: answers to changes of the tables, given when the disk has them.
//
// What the disk does not take is in force all the same, and its asker is told that it is not kept
// (E9025). One thread, that of the desk; the machine tells of the disk from another one.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "daemon/desk/command_desk.h"

namespace stanok::daemon {

// Told from any thread when the tables as they were at the call are on the disk, or why they are
// not.
using KeepDone = std::function<void(const std::optional<std::string>& fault)>;
using KeepTables = std::function<void(KeepDone done)>;

class KeptAnswers {
 public:
  // Without `keep` nothing is kept, and nothing waits.
  explicit KeptAnswers(KeepTables keep) : keep_(std::move(keep)) {}

  // The same answer, behind the disk; a refusal at once.
  [[nodiscard]] Answer behind_disk(Answer answer);
  // Gives the answers that may be given now.
  void tick();

 private:
  struct Done {
    Answer answer;
    CommandResult outcome;
  };
  // Shared with those who tell of the disk, who may outlive this.
  struct Finished {
    std::mutex mutex;
    std::vector<Done> all;
  };

  KeepTables keep_;
  std::shared_ptr<Finished> finished_ = std::make_shared<Finished>();
};

}  // namespace stanok::daemon
