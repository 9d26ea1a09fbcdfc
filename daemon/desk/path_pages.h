// A planned path as answers: a page of points at a time.
//
// `system` says in which system the points lie, `part` how the part system lies in the base of the
// scheme that carries it. The member `geometry` holds the page: points as Float32 (x, y, z, mm) and
// behind them their lines as Uint32, all little endian, in base64; `rapid` and `begins` name the
// points to which a rapid move or no line leads, as ranges [first, behind the last]; `feeds` and
// `tools` are [point, value] of what holds on the way to this point and those behind it. `more` is
// the request for the next page. stanok-web makes binary frames of these pages.
#pragma once

#include <nlohmann/json.hpp>

#include "daemon/desk/command_desk.h"
#include "jobs/foresight/planned_path.h"

namespace stanok::daemon {

// `path` is nullptr where there is none.
[[nodiscard]] CommandResult path_answer(const jobs::PlannedPath* path, int channel,
                                        const nlohmann::json& parameters);

}  // namespace stanok::daemon
