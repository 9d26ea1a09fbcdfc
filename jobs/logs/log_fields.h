// What is in a log by its names: `stanok log info --json` and Python give it.
#pragma once

#include "base/fields.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {

[[nodiscard]] Fields log_fields(const recording::LogContents& contents);

}  // namespace stanok::jobs
