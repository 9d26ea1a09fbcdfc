// [[signal]]: an input or output of programs and its place on the bus.
#pragma once

#include <vector>

#include "config/text/key_table.h"
#include "drives/signals.h"

namespace stanok::config {

[[nodiscard]] std::vector<drives::SignalConfig> read_signals(Subtables signals, const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> signal_key_rows();

}  // namespace stanok::config
