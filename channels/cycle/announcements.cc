#include "channels/cycle/announcements.h"

namespace stanok::channels {
namespace {

constexpr int announced_per_cycle = 8;  // bound of work

}  // namespace

void Announcements::advance(const motion::BlockTag& path, PathEnd end) RT_SAFE {
  for (int n = 0; n < announced_per_cycle && !remarks_.empty(); ++n) {
    const Remark& remark = remarks_.front();
    const bool is_passed = path.run == remark.tag.run && path.block > remark.tag.block;
    if (!is_passed && end == PathEnd::not_reached) return;
    show(remark);
    remarks_.pop_front();
  }
}

void Announcements::show(const Remark& remark) RT_SAFE {
  if (const auto* spoken = std::get_if<SpokenText>(&remark.news))
    return log_.tell(spoken->code.view(), spoken->text.view(), remark.tag);
  ++workpiece_.announcements;
  if (const auto* blank = std::get_if<BlankNews>(&remark.news)) {
    ++workpiece_.shapes;
    workpiece_.shape = blank->shape;
    workpiece_.file = blank->file;
    workpiece_.frame = blank->frame;
    workpiece_.has_shape = true;
  } else if (const auto* position = std::get_if<lang::WorkpiecePosition>(&remark.news)) {
    workpiece_.position = *position;
    workpiece_.has_position = true;
  }
}

}  // namespace stanok::channels
