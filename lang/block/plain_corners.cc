#include "lang/block/plain_corners.h"

#include <algorithm>

#include "lang/words/corner_word.h"

namespace stanok::lang {
namespace {

const Code* motion_of(const BlockCodes& codes) {
  const auto* const found = std::find_if(
      codes.begin(), codes.end(), [](const Code* row) { return row->group == Group::motion; });
  return found == codes.end() ? nullptr : *found;
}

}  // namespace

bool may_have_plain_corners(const BlockWords& words, const BlockCodes& codes,
                            const ChannelDescription& channel) {
  if (!channel.plain_corners || !words.rules.is_fanuc() || channel.kind != ChannelKind::lathe)
    return false;
  const Code* const motion = motion_of(codes);
  return motion == nullptr || motion->number == g(1);
}

void find_plain_corners(ActiveBlock& block, const BlockCodes& codes) {
  if (!may_have_plain_corners(block.words, codes, block.channel)) return;
  const bool is_line = motion_of(codes) != nullptr || block.modal.code(Group::motion) == g(1);
  if (!is_line) return;
  block.plain_corners =
      block.words.letters & plain_corner_letters & ~block.channel_words.letters() & ~codes.words;
}

}  // namespace stanok::lang
