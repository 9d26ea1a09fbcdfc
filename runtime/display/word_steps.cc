#include "runtime/display/word_steps.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/enum_names.h"
#include "channels/contract/motion_config.h"
#include "channels/preparation/face_transformation.h"
#include "kinematics/linear_axes.h"
#include "kinematics/scheme.h"

namespace stanok::runtime {
namespace {

using kinematics::PointMode;
using kinematics::ToolVector;
using lang::AxisValues;
using lang::MeaningTerms;

constexpr auto term_names = enum_names<WordTerm>({
    {WordTerm::machine, "machine"},
    {WordTerm::scheme_zero, "scheme_zero"},
    {WordTerm::kinematics, "kinematics"},
    {WordTerm::tool_length, "tool_length"},
    {WordTerm::work_offset, "work_offset"},
    {WordTerm::overhang, "overhang"},
    {WordTerm::work_offset_rotation, "work_offset_rotation"},
    {WordTerm::set_up_error, "set_up_error"},
    {WordTerm::local_shift, "local_shift"},
    {WordTerm::axis_shift, "axis_shift"},
    {WordTerm::plane, "plane"},
    {WordTerm::plane_shift, "plane_shift"},
    {WordTerm::rotation, "rotation"},
    {WordTerm::transformation, "transformation"},
    {WordTerm::scaling, "scaling"},
    {WordTerm::polar, "polar"},
    {WordTerm::diameter, "diameter"},
    {WordTerm::rest, "rest"},
});

// Rounding of sums of offsets: nobody sees it, and it would be a term of its own.
constexpr double noise = 1e-9;

class Walk {
 public:
  explicit Walk(const AxisValues& axes_M) : value_(axes_M) {
    steps_.push_back({WordTerm::machine, Adds::everywhere_the_same, axes_M, axes_M});
  }

  [[nodiscard]] const AxisValues& value() const { return value_; }
  [[nodiscard]] std::vector<WordStep> steps() { return std::move(steps_); }

  void go_to(WordTerm term, Adds adds, const AxisValues& next) {
    WordStep step{term, adds, {}, next};
    bool is_there = false;
    for (std::size_t k = 0; k < next.size(); ++k) {
      step.amount[k] = next[k] - value_[k];
      is_there = is_there || std::abs(step.amount[k]) > noise;
    }
    value_ = next;
    if (is_there) steps_.push_back(step);
  }
  void subtract(WordTerm term, const AxisValues& amount) {
    AxisValues next = value_;
    for (std::size_t k = 0; k < next.size(); ++k) next[k] -= amount[k];
    go_to(term, Adds::everywhere_the_same, next);
  }

 private:
  std::vector<WordStep> steps_;
  AxisValues value_{};
};

AxisValues axes_of(const channels::ChannelOutput& output) {
  AxisValues axes_M{};
  for (std::size_t k = 0; k < axes_M.size(); ++k) axes_M[k] = output.axes[k].position;
  return axes_M;
}

AxisValues point_of(const channels::ChannelOutput& output) {
  AxisValues point_W{};
  for (std::size_t k = 0; k < point_W.size(); ++k) point_W[k] = output.point_W[k].value;
  return point_W;
}

// The shifts of the rotary axis of a face or cylinder are part of its scheme: they come first.
enum class Shifts : std::uint8_t { all, of_rotary_axis };

void shift_by(Walk& walk, WordTerm term, const MeaningTerms& terms, const AxisValues& amount,
              Shifts which) {
  const AxisIndex rotary = terms.transformation.rotary_axis;
  AxisValues shift = which == Shifts::all ? amount : AxisValues{};
  if (rotary.exists()) shift[rotary] = which == Shifts::all ? 0.0 : amount[rotary];
  walk.subtract(term, shift);
}

void enter(Walk& walk, WordTerm term, const lang::SystemWithin& system,
           const std::array<int, 3>& geometry) {
  if (!system.is_on) return;
  AxisValues next = walk.value();
  const kinematics::LinearAxes linear(geometry);
  const Vector3<double> within = linear.of(next) - vector3(system.shift);
  linear.set(system.rotation.turned_back(within), next);
  const bool turns = !system.rotation.is_identity();
  walk.go_to(term, turns ? Adds::as_the_axes_stand : Adds::everywhere_the_same, next);
}

// From B to W. On a face and on a cylinder the rotary axis stands for one of X, Y and Z.
void walk_through_frames(Walk& walk, const MeaningTerms& terms,
                         const std::array<int, 3>& geometry) {
  shift_by(walk, WordTerm::work_offset, terms, terms.work_offset_B, Shifts::all);
  AxisValues overhang{};
  if (terms.overhang_axis >= 0) overhang[terms.overhang_axis] = -terms.overhang_mm;
  walk.subtract(WordTerm::overhang, overhang);
  const bool is_turned = !terms.work_offset_rotation.is_identity();
  enter(walk, WordTerm::work_offset_rotation, {is_turned, terms.work_offset_rotation, {}},
        geometry);
  enter(walk, WordTerm::set_up_error, terms.set_up_error, geometry);
  shift_by(walk, WordTerm::local_shift, terms, terms.local_shift, Shifts::all);
  shift_by(walk, WordTerm::axis_shift, terms, terms.axis_shift, Shifts::all);
  enter(walk, WordTerm::plane, terms.plane, geometry);
  enter(walk, WordTerm::plane_shift, {terms.plane.is_on, {}, terms.plane_shift}, geometry);
  enter(walk, WordTerm::rotation, terms.rotation, geometry);
}

// From W to the words: each of the terms alone, as words_at has them all.
void walk_to_words(Walk& walk, const lang::Meaning& meaning) {
  const auto with = [&](WordTerm term, Adds adds, auto leaves) {
    auto terms = std::make_shared<MeaningTerms>();
    lang::Meaning alone;
    terms->geometry = meaning.terms->geometry;
    leaves(*terms, alone.codes);
    alone.terms = std::move(terms);
    walk.go_to(term, adds, lang::words_at(alone, walk.value()));
  };
  with(WordTerm::transformation, Adds::as_the_axes_stand,
       [&](MeaningTerms& terms, lang::ActiveCodes&) {
         terms.transformation = meaning.terms->transformation;
       });
  with(WordTerm::scaling, Adds::as_the_axes_stand, [&](MeaningTerms& terms, lang::ActiveCodes&) {
    terms.gain = meaning.terms->gain;
    terms.shift = meaning.terms->shift;
  });
  with(WordTerm::polar, Adds::as_the_axes_stand, [&](MeaningTerms&, lang::ActiveCodes& codes) {
    codes[lang::Group::plane] = meaning.codes[lang::Group::plane];
    codes[lang::Group::polar] = meaning.codes[lang::Group::polar];
  });
  with(WordTerm::diameter, Adds::as_the_axes_stand, [&](MeaningTerms&, lang::ActiveCodes& codes) {
    codes[lang::Group::diameter] = meaning.codes[lang::Group::diameter];
  });
}

// From M to B by the active scheme, and on to W.
void walk_through_scheme(Walk& walk, const kinematics::Scheme& scheme,
                         const channels::MachineConfig& machine,
                         const channels::ChannelConfig& channel,
                         const channels::ChannelOutput& output, const MeaningTerms& terms) {
  const AxisValues axes_M = walk.value();
  kinematics::Transform programmed;
  programmed.scheme = &scheme;
  programmed.frame.offset = terms.frame.offset;
  const motion::MotionConfig motion = channels::motion_config(machine, channel);
  channels::FaceTransformation face(motion);
  if (terms.transformation.kind != lang::Transformation::off)
    face.begin(terms.transformation, scheme, axes_M);
  const kinematics::Scheme& applied = *face.applied_to(programmed).scheme;
  const PointMode mode = output.point_mode;
  ToolVector tool;
  tool.nose_to_tip_mm = Vector3<double>::Zero() - vector3(terms.length.offset_mm);
  AxisValues zero{};
  for (const int axis : scheme.config().axes)
    zero[AxisIndex(axis)] = scheme.config().zero[AxisIndex(axis)];
  walk.subtract(WordTerm::scheme_zero, zero);
  if (face.is_on()) {
    shift_by(walk, WordTerm::work_offset, terms, terms.work_offset_B, Shifts::of_rotary_axis);
    shift_by(walk, WordTerm::local_shift, terms, terms.local_shift, Shifts::of_rotary_axis);
    shift_by(walk, WordTerm::axis_shift, terms, terms.axis_shift, Shifts::of_rotary_axis);
  }
  AxisValues point_B{};
  applied.forward(mode, {}, axes_M, point_B);
  walk.go_to(face.is_on() ? WordTerm::transformation : WordTerm::kinematics,
             Adds::as_the_axes_stand, point_B);
  applied.forward(mode, tool, axes_M, point_B);
  const bool is_led = mode == PointMode::tip && applied.head_axes() != 0;
  walk.go_to(WordTerm::tool_length, is_led ? Adds::as_the_axes_stand : Adds::everywhere_the_same,
             point_B);
  walk_through_frames(walk, terms, face.geometry());
}

}  // namespace

std::string_view name_of(WordTerm term) {
  return term_names[term];
}

std::vector<WordStep> steps_to_words(const channels::MachineConfig& machine,
                                     const channels::ChannelConfig& channel,
                                     const channels::ChannelOutput& output,
                                     const lang::Meaning& meaning) {
  Walk walk(axes_of(output));
  const auto config =
      std::ranges::find(channel.schemes, output.scheme, &kinematics::SchemeConfig::id);
  const auto scheme = config == channel.schemes.end() ? nullptr : kinematics::make_scheme(*config);
  if (scheme != nullptr)
    walk_through_scheme(walk, *scheme, machine, channel, output, *meaning.terms);
  walk_to_words(walk, meaning);
  walk.go_to(WordTerm::rest, Adds::as_the_axes_stand, lang::words_at(meaning, point_of(output)));
  return walk.steps();
}

}  // namespace stanok::runtime
