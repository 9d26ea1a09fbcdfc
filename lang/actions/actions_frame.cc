// Actions of work offsets and shifts of the coordinate system.
#include <array>
#include <optional>
#include <string>

#include "lang/actions/actions.h"
#include "lang/words/dialect_codes.h"

namespace stanok::lang {
namespace {

constexpr int work_offset_last = 309;

// Index of the work offset that a code selects: 1 = G54 ... 9 = G59.3.
int offset_number(CodeNumber code) {
  return code <= g(59) ? (code - g(54)) / 10 + 1 : 6 + (code - g(59));
}

// The code that selects a work offset.
CodeNumber code_of_offset(int number) {
  constexpr int last_of_g59 = 6;
  if (number >= first_extended_offset) return g(54, 1);
  return number <= last_of_g59 ? g(53 + number) : g(59, number - last_of_g59);
}

// The work offset that the table is to carry, by its number; 0: none. Nothing after a failure.
std::optional<int> carried_page(ActiveBlock& block, CodeNumber code) {
  if (code == g(254)) return block.modal.frames.work_offset_number;
  if (code == g(255)) return 0;
  if (!block.has('P')) {
    block.fail("E4007", code_word(code), "`G54.2` needs P, the work offset", "no P");
    return std::nullopt;
  }
  const auto page = block.integer('P', 0, work_offset_last);
  if (!page || *page == 0 || !block.words.rules.is_fanuc()) return page;
  block
      .fail("E4016", {'P', -1, {}}, "`G54.2 P` of Fanuc controls takes a table of fixtures",
            "a different table there")
      .help.emplace_back(
          "write the values of that table into a work offset; in a program of the dialect stanok, "
          "P is the work offset that the table carries");
  return std::nullopt;
}

}  // namespace

void take_work_offset(ModalState& modal, const Tables& tables, int number) {
  take_work_offset(modal, tables, number, modal.frame().base_from_work(modal.position_W));
}

void take_work_offset(ModalState& modal, const Tables& tables, int number,
                      const AxisValues& position_B) {
  modal.frames.work_offset_number = number;
  modal.frames.work_offset = tables.work_offset(number).value_or(modal.frames.work_offset);
  if (modal.frames.is_carried) {
    modal.frames.work_offset = tables.carried_by_table(modal.frames.work_offset, position_B)
                                   .value_or(modal.frames.work_offset);
  }
  modal.frames.work_offset_rotation =
      Rotation::about({0.0, 0.0, 1.0}, tables.work_offset_rotation(number));
}

void publish_frame(ActiveBlock& block, const WorkFrame& before, int work_offset_before) {
  const bool changed = block.modal.frame() != before;
  if (changed) block.modal.reexpress_position(before);
  if (changed || block.modal.frames.work_offset_number != work_offset_before) {
    block.queue.emit(frame_of(block.modal));
  }
}

void publish_frame(ActiveBlock& block, const WorkFrame& before) {
  publish_frame(block, before, block.modal.frames.work_offset_number);
}

void restore_work_offset(ActiveBlock& block, const ModalState& saved) {
  const WorkFrame before = block.modal.frame();
  const int number_before = block.modal.frames.work_offset_number;
  block.modal.frames.is_carried = saved.frames.is_carried;
  take_work_offset(block.modal, block.tables, saved.frames.work_offset_number);
  publish_frame(block, before, number_before);
}

void restore_shifts(ActiveBlock& block, const ModalState& saved) {
  const WorkFrame before = block.modal.frame();
  block.modal.frames.local_shift = saved.frames.local_shift;
  block.modal.frames.axis_shift = saved.frames.axis_shift;
  block.modal.frames.axis_shift_active = saved.frames.axis_shift_active;
  block.modal.frames.rotation = saved.frames.rotation;
  block.modal.frames.plane = saved.frames.plane;
  block.modal.frames.set_up = saved.frames.set_up;
  block.modal.frames.set_up_angles = {};
  block.modal.map = saved.map;
  for (const Group group : {Group::rotation, Group::scaling, Group::mirror}) {
    if (block.modal.code(group) != saved.code(group)) block.set_modal(group, saved.code(group));
  }
  publish_frame(block, before);
}

void select_work_offset(ActiveBlock& block, CodeNumber code) {
  int number = offset_number(code);
  if (is_offset_of_haas(code)) {
    number = first_extended_offset + (code - first_offset_of_haas) / 10;
    block.kept_groups |= group_bit(Group::work_offset);
    block.set_modal(Group::work_offset, g(154));
  }
  if (code == g(54, 1) || code == g(154)) {
    if (!block.has('P')) {
      block.fail("E4007", {'G', code, {}}, "`" + code_text('G', code) + "` needs P", "no P");
      return;
    }
    const auto page = block.integer('P', 1, 300);
    if (!page) return;
    number = first_extended_offset + *page - 1;
  }
  if (!block.tables.work_offset(number)) {
    block.fail("E5001", {'G', code, {}},
               "the machine has no work offset `" + code_text('G', code) + "`",
               "unknown work offset");
    return;
  }
  const WorkFrame before = block.modal.frame();
  const int number_before = block.modal.frames.work_offset_number;
  block.modal.frames.is_carried = false;
  take_work_offset(block.modal, block.tables, number);
  publish_frame(block, before, number_before);
}

// G54.2 P: work offset P, carried by the rotary table; P0: the active one, where its table has it.
void carry_work_offset(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code,
                       {Exclusion::radius_compensation, Exclusion::tcp, Exclusion::transformation,
                        Exclusion::tilted_plane, Exclusion::drilling_cycle})) {
    return;
  }
  const auto page = carried_page(block, code);
  if (!page) return;
  FrameSettings& frames = block.modal.frames;
  const int number = *page == 0 ? frames.work_offset_number : *page;
  const auto offset = block.tables.work_offset(number);
  if (!offset) {
    block.fail("E5001", {'P', -1, {}}, "there is no work offset " + std::to_string(number),
               "unknown work offset");
    return;
  }
  if (*page != 0 && !block.tables.carried_by_table(*offset, *offset)) {
    block
        .fail("E4353", code_word(code),
              "`" + code_text('G', code) +
                  "` needs a rotary table to carry the work offset, but the kinematic scheme has "
                  "none",
              "a dynamic work offset without a table")
        .help.emplace_back("select a scheme of type head_table or table_table with `#kinematics`");
    return;
  }
  const WorkFrame before = block.modal.frame();
  const int number_before = frames.work_offset_number;
  frames.is_carried = *page != 0;
  take_work_offset(block.modal, block.tables, number);
  publish_frame(block, before, number_before);
  if (*page != 0) return;
  block.kept_groups |= group_bit(Group::work_offset);
  block.set_modal(Group::work_offset, code_of_offset(number));
}

void follow_table(ActiveBlock& block) {
  follow_table(block, block.modal.frame().base_from_work(block.modal.position_W));
}

void follow_table(ActiveBlock& block, const AxisValues& position_B) {
  if (!block.modal.frames.is_carried) return;
  const WorkFrame before = block.modal.frame();
  take_work_offset(block.modal, block.tables, block.modal.frames.work_offset_number, position_B);
  if (block.modal.frame() == before) return;
  if (excluded_by_mode(block, g(54, 2), {Exclusion::radius_compensation})) return;
  publish_frame(block, before);
}

namespace {

// The error that the words of G54.4 say; nothing: the block has failed.
std::optional<SetUpError> set_up_error_of(ActiveBlock& block) {
  const WordName word = code_word(g(54, 4));
  const bool has_angles = (block.words.letters & letters_of("IJK")) != 0;
  const bool says_error = block.programmed != 0 || has_angles;
  SetUpError error;
  if (block.has('P')) {
    if (block.value('P') == 0.0 && !says_error) return error;
    block.fail("E4016", {'P', -1, {}}, "`G54.4` has no table of set-up errors", "only P0 is known")
        .help.emplace_back(
            "write the error itself: the shift as X Y Z, the rotations about these axes as I J K, "
            "e.g. `G54.4 X0.2 I0.5`");
    return std::nullopt;
  }
  if (!says_error) {
    block.fail("E4007", word, "`G54.4` needs the set-up error, or P0", "no shift and no rotation");
    return std::nullopt;
  }
  std::array<double, 3> shift{};
  AxisSet geometry = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisIndex axis = block.modal.geometry[k];
    geometry = static_cast<AxisSet>(geometry | axis_bit(axis));
    if (axis.exists() && is_programmed(block, axis)) shift[k] = block.values[axis];
  }
  if (!only_axes(block, g(54, 4), geometry)) return std::nullopt;
  const auto angle = [&](char letter) { return block.has(letter) ? block.value(letter) : 0.0; };
  error.set(shift, {angle('I'), angle('J'), angle('K')});
  return error;
}

}  // namespace

// G54.4: the workpiece lies otherwise in its work offset; P0: as the program takes it to lie.
void compensate_set_up(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(
          block, code,
          {Exclusion::radius_compensation, Exclusion::transformation, Exclusion::tilted_plane,
           Exclusion::drilling_cycle, Exclusion::carried_offset})) {
    return;
  }
  const auto error = set_up_error_of(block);
  if (!error) return;
  const WorkFrame before = block.modal.frame();
  block.modal.frames.set_up = *error;
  block.modal.frames.set_up_angles = {};
  publish_frame(block, before);
}

void shift_locally(ActiveBlock& block, CodeNumber) {
  const WorkFrame before = block.modal.frame();
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_programmed(block, i)) continue;
    TiltedPlane& plane = block.modal.frames.plane;
    const int coordinate = block.channel.axes[i].geometry;
    const bool within = plane.is_on && coordinate >= 0 && coordinate < 3;
    double& shift = within ? plane.local_shift[AxisIndex(coordinate).place()]
                           : block.modal.frames.local_shift[i];
    shift = block.values[i];
  }
  publish_frame(block, before);
}

namespace {

// The shift with which the point where the axes stand is called as the axis words say.
AxisValues shift_to_words(const ActiveBlock& block) {
  const ModalState& modal = block.modal;
  AxisValues distance_W{};
  for (std::size_t i = 0; i < block.channel.axes.size(); ++i) {
    if (!is_programmed(block, i)) continue;
    distance_W[i] = modal.position_W[i] - modal.map.to_work(i, block.values[i]);
  }
  AxisValues shift = turned(modal.frames.rotation.rotation, modal.geometry, distance_W);
  for (std::size_t i = 0; modal.frames.axis_shift_active && i < shift.size(); ++i) {
    shift[i] += modal.frames.axis_shift[i];
  }
  return shift;
}

}  // namespace

// G92 X..: the point where the axes stand is called X.. from here on.
void shift_axes(ActiveBlock& block, CodeNumber code) {
  if (excluded_by_mode(block, code, {Exclusion::tilted_plane})) return;
  const WorkFrame before = block.modal.frame();
  if (code == g(92)) {
    if (block.has('S')) limit_speed(block);
    if (block.programmed == 0) {
      if (!block.has('S')) block.fail("E4007", {'G', g(92), {}}, "`G92` needs an axis word", "");
      return;
    }
    block.modal.frames.axis_shift = shift_to_words(block);
    block.modal.frames.axis_shift_active = true;
  } else {
    if (code == g(92, 1)) block.modal.frames.axis_shift = {};
    block.modal.frames.axis_shift_active = code != g(92, 2);
  }
  publish_frame(block, before);
  for (std::size_t i = 0; code == g(92) && i < block.channel.axes.size(); ++i) {
    if (is_programmed(block, i)) {
      block.modal.position_W[i] = block.modal.map.to_work(i, block.values[i]);
    }
  }
}

}  // namespace stanok::lang
