#include "drives/modbus/position_reference.h"

namespace stanok::drives {

void PositionReference::take(const DriveTarget& target) RT_SAFE {
  accepted_ = target.position_accepted;
  if (accepted_) offset_ = target.position_offset;
}

void PositionReference::lose_sight(const Band& reach) RT_SAFE {
  reach_ = reach;
  found_ = found_ && encoder_ == Encoder::absolute;
}

void PositionReference::confirm() RT_SAFE {
  moved_out_of_sight_ = false;
  found_ = true;
}

}  // namespace stanok::drives
