#include "channels/cycle/settling.h"

namespace stanok::channels {

// Of two different rows of a table all of them are read again.
void Settling::want(const lang::ChangedRows& rows) RT_SAFE {
  const bool other_tool =
      rows.tool != 0 && rows_.tool != 0 && (rows.tool != rows_.tool || rows.edge != rows_.edge);
  const bool other_offset =
      rows.work_offset != 0 && rows_.work_offset != 0 && rows.work_offset != rows_.work_offset;
  rows_.all = rows_.all || rows.all || other_tool || other_offset;
  if (rows.tool != 0) {
    rows_.tool = rows.tool;
    rows_.edge = rows.edge;
  }
  if (rows.work_offset != 0) rows_.work_offset = rows.work_offset;
  is_wanted_ = true;
}

void Settling::ask(const Stand& stand) RT_SAFE {
  if (!is_wanted_ || is_asked_) return;
  link_.tell(Settle{.stand = stand, .rows = rows_});
  rows_ = {};
  is_wanted_ = false;
  is_asked_ = true;
}

void Settling::ask_at_start(const Stand& stand) {
  is_asked_ = false;
  want({.all = true});
  ask(stand);
}

}  // namespace stanok::channels
