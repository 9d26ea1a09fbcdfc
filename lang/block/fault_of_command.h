// Why a command of an earlier block cannot be executed, found when a later one is known.
#pragma once

#include <optional>

#include "lang/contract/command.h"
#include "lang/words/block_fault.h"

namespace stanok::lang {

struct FaultOfCommand {
  BlockFault fault;
  Origin origin;
};
using StageResult = std::optional<FaultOfCommand>;

}  // namespace stanok::lang
