// System variables of Fanuc and Haas that the interpreter knows itself: positions, modal codes,
// offsets.
//
// Numbers and meanings are those of the operator's manuals B-63944EN (machining centres) and
// B-64304EN-1 (lathes), 16.2; lengths stand in programmed units, X in diameters where these are
// programmed.
#pragma once

#include <optional>

#include "lang/block/predefined_parameter.h"
#include "lang/contract/dialect.h"

namespace stanok::lang {

// The value of system variable #number; nothing for one that does not exist or that only the
// machine knows.
[[nodiscard]] std::optional<double> system_variable(int number, const ParameterView& view,
                                                    const TextRules& rules);

}  // namespace stanok::lang
