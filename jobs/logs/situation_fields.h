// A situation of a log by its names. Lengths mm, angles deg, axes by their words.
#pragma once

#include <stanok_messages/situation_t.hpp>

#include "base/fields.h"
#include "recording/read/log_contents.h"

namespace stanok::jobs {

// `contents` of the log that it is from: words of the axes, and when the log begins.
[[nodiscard]] Fields situation_fields(const situation_t& situation,
                                      const recording::LogContents& contents);

}  // namespace stanok::jobs
