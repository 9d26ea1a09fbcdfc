// The modal state as text: what save_gvector returns and restore_gvector takes.
//
//   GV1;modal G17 G21 ... work_offset=1;feed F=200 ...;crc=1a2b3c4d
//
// Printable, on one line. Numbers are written so that they read back to the bit; the check sum is
// the CRC-32 (IEEE 802.3) of all that stands before it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lang/actions/modal_restore.h"

namespace stanok::lang {

struct SavedState {
  StateParts parts = 0;
  ModalState state;  // what belongs to no part has its default value
};

[[nodiscard]] std::string saved_state_text(const ModalState& state, StateParts parts);
// Nothing when the text is damaged or of another version.
[[nodiscard]] std::optional<SavedState> read_saved_state(std::string_view text);

}  // namespace stanok::lang
