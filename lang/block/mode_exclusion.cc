#include "lang/block/mode_exclusion.h"

#include <algorithm>
#include <iterator>

#include "base/assert.h"

namespace stanok::lang {
namespace {

struct ExcludedMode {
  Exclusion exclusion;
  Group group;
  std::string_view name;
  std::string_view remedy;
};

constexpr ExcludedMode modes[] = {
    {Exclusion::radius_compensation, Group::radius_compensation, "radius compensation is active",
     "switch it off with `G40` first"},
    {Exclusion::tcp, Group::length, "TCP (RTCP) is active", "switch it off with `G49` first"},
    {Exclusion::transformation, Group::transformation,
     "a face or cylinder transformation is active", "switch it off with `G13.1` first"},
    {Exclusion::drilling_cycle, Group::motion, "a drilling cycle is active",
     "end it with `G80` first"},
    {Exclusion::inverse_time, Group::feed_mode, "inverse time feed is active",
     "program `G94` or `G95` first"},
    {Exclusion::rotation, Group::rotation, "the coordinate system is rotated",
     "end it with `G69` first"},
    {Exclusion::own_rotation, Group::rotation, "the coordinate system is rotated by G68",
     "end it with `G69` first"},
    {Exclusion::tilted_plane, Group::rotation, "a tilted plane is active",
     "end it with `G69` first"},
    {Exclusion::scaling, Group::scaling, "the coordinates are scaled", "end it with `G50` first"},
    {Exclusion::mirror, Group::mirror, "the coordinates are mirrored", "end it with `G50.1` first"},
    {Exclusion::carried_offset, Group::work_offset, "the rotary table carries the work offset",
     "end it with `G54.2 P0` first"},
};

// The tool tip is led without G43.4, since the tool is aligned with a tilted plane.
constexpr ExcludedMode aligned{Exclusion::tcp, Group::rotation,
                               "the tool is aligned with a tilted plane",
                               "end the plane with `G69` first"};

bool is_active(const ModalState& modal, Exclusion exclusion) {
  switch (exclusion) {
    case Exclusion::radius_compensation:
      return modal.code(Group::radius_compensation) != g(40);
    case Exclusion::tcp:
      return modal.tool.length.mode == LengthMode::tip;
    case Exclusion::transformation:
      return modal.code(Group::transformation) != g(13, 1);
    case Exclusion::drilling_cycle: {
      const CodeNumber code = modal.code(Group::motion);
      return code == g(73) || code == g(74) || code == g(76) || (code > g(80) && code <= g(89));
    }
    case Exclusion::inverse_time:
      return modal.feed_mode() == FeedMode::inverse_time;
    case Exclusion::rotation:
      return modal.code(Group::rotation) != g(69);
    case Exclusion::own_rotation:
      return !modal.frames.rotation.rotation.is_identity();
    case Exclusion::tilted_plane:
      return modal.frames.plane.is_on;
    case Exclusion::scaling:
      return modal.code(Group::scaling) != g(50);
    case Exclusion::mirror:
      return modal.code(Group::mirror) != g(50, 1);
    case Exclusion::carried_offset:
      return modal.frames.is_carried;
  }
  return false;
}

}  // namespace

std::optional<ActiveMode> active_mode(const ModalState& modal,
                                      std::initializer_list<Exclusion> exclusions) {
  for (const Exclusion exclusion : exclusions) {
    if (!is_active(modal, exclusion)) continue;
    const auto* const mode =
        std::find_if(std::begin(modes), std::end(modes),
                     [exclusion](const ExcludedMode& one) { return one.exclusion == exclusion; });
    STANOK_ASSERT(mode != std::end(modes));
    const bool by_plane = exclusion == Exclusion::tcp && modal.frames.plane.is_aligned &&
                          !leads_tip(modal.code(Group::length));
    const ExcludedMode& active = by_plane ? aligned : *mode;
    return ActiveMode{active.name, active.remedy, modal.origin_of(active.group)};
  }
  return std::nullopt;
}

bool excluded_by_mode(ActiveBlock& block, CodeNumber code,
                      std::initializer_list<Exclusion> exclusions, char letter) {
  const auto mode = active_mode(block.modal, exclusions);
  if (!mode) return false;
  BlockFault& fault = block.fail(
      "E4301", {letter, code, {}},
      "`" + code_text(letter, code) + "` is not allowed while " + std::string(mode->name),
      "not in this mode");
  fault.notes.push_back(mode->set_by);
  fault.help.emplace_back(mode->remedy);
  return true;
}

}  // namespace stanok::lang
