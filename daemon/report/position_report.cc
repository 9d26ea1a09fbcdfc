#include "daemon/report/position_report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "channels/stores/live_tables.h"
#include "daemon/report/channel_display.h"
#include "daemon/report/status_report.h"
#include "runtime/display/word_steps.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using runtime::WordStep;
using runtime::WordTerm;

struct Shown {
  const channels::MachineConfig& machine;
  const channels::ChannelConfig& channel;
  const channels::ChannelOutput& output;
  const lang::Meaning& meaning;
};

// A term by its name, and by what it is of in any language: an axis, a scheme, a tool, a code.
struct Named {
  std::string name;
  std::string of;
};

Named of_scheme(const char* what, const Shown& shown) {
  const std::string number = std::to_string(shown.output.scheme);
  const auto scheme =
      std::ranges::find(shown.channel.schemes, shown.output.scheme, &kinematics::SchemeConfig::id);
  const bool is_known = scheme != shown.channel.schemes.end();
  const std::string type = is_known ? " (" + scheme->type + ")" : "";
  return {what + (" scheme " + number) + type, number + type};
}

Named length_of(const Shown& shown) {
  const lang::ToolLength& length = shown.meaning.terms->length;
  const std::string code = lang::code_text('G', shown.meaning.codes[lang::Group::length]);
  if (length.row == lang::ToolLength::Row::none) return {"tool length (" + code + ")", code};
  const std::string edge = std::to_string(length.edge);
  const std::string tool = std::to_string(length.tool);
  return {"length of tool " + tool + ", edge " + edge + " (" + code + ")",
          "T" + tool + (length.edge == 1 ? "" : "." + edge) + " " + code};
}

Named with_code(const std::string& what, const std::string& code) {
  return {what + " (" + code + ")", code};
}

Named with_active_code(const std::string& what, const Shown& shown, lang::Group group) {
  return with_code(what, lang::code_text('G', shown.meaning.codes[group]));
}

Named named_term(WordTerm term, const Shown& shown, std::size_t axis) {
  const std::string offset = channels::work_offset_name(shown.meaning.terms->frame.work_offset);
  const std::string& name = shown.machine.axes[shown.channel.axes[axis]].name;
  switch (term) {
    case WordTerm::machine:
      return {"machine position of " + name, name};
    case WordTerm::scheme_zero:
      return of_scheme("zero of", shown);
    case WordTerm::kinematics:
      return of_scheme("kinematics of", shown);
    case WordTerm::tool_length:
      return length_of(shown);
    case WordTerm::work_offset:
      return {"work offset " + offset, offset};
    case WordTerm::overhang:
      return with_code("overhang", "#tool_overhang");
    case WordTerm::work_offset_rotation:
      return {"rotation of " + offset, offset};
    case WordTerm::set_up_error:
      return with_code("set-up error", "G54.4");
    case WordTerm::local_shift:
      return {"shift G52", "G52"};
    case WordTerm::axis_shift:
      return {"shift G92", "G92"};
    case WordTerm::plane:
      return with_code("tilted plane", "G68.2");
    case WordTerm::plane_shift:
      return {"shift G52 in the plane", "G52"};
    case WordTerm::rotation:
      return with_code("rotation", "G68");
    case WordTerm::transformation:
      return with_active_code("transformation", shown, lang::Group::transformation);
    case WordTerm::scaling:
      return with_code("scaling, mirror", "G51, G51.1");
    case WordTerm::polar:
      return with_code("polar input", "G16");
    case WordTerm::diameter:
      return with_code("diameter", "G7");
    case WordTerm::rest:
      break;
  }
  const bool is_spindle = shown.output.drives[axis].follows_velocity;
  return {is_spindle ? "the axis turns as a spindle" : "between path and axes", name};
}

// Rounding is no term.
constexpr double noise = 1e-9;

json terms_of(const std::vector<WordStep>& steps, const Shown& shown, std::size_t axis) {
  json terms = json::array();
  for (const WordStep& step : steps) {
    const bool is_first = step.term == WordTerm::machine;
    if (!is_first && std::abs(step.amount[axis]) <= noise) continue;
    const Named named = named_term(step.term, shown, axis);
    terms.push_back({{"term", runtime::name_of(step.term)},
                     {"name", named.name},
                     {"of", named.of},
                     {"amount", step.amount[axis]},
                     {"value", step.value[axis]},
                     {"fixed", step.adds == runtime::Adds::everywhere_the_same}});
  }
  return terms;
}

}  // namespace

json position_report(RunningMachine& machine, int channel, WordTerms terms) {
  const channels::MachineConfig& config = machine.file().machine;
  const channels::ChannelConfig& own = config_of(config, channel);
  const channels::ChannelOutput output = output_of(machine.newest_output(), channel);
  const channels::SituationReport situation = machine.situation(output);
  const Shown shown{config, own, output, situation.meaning};
  const auto steps = runtime::steps_to_words(config, own, output, situation.meaning);
  json axes = json::array();
  for (std::size_t k = 0; k < own.axes.size(); ++k) {
    const channels::AxisConfig& axis = config.axes[own.axes[k]];
    axes.push_back({{"word", own.words[k]},
                    {"axis", axis.name},
                    {"unit", axis.rotary ? "deg" : "mm"},
                    {"machine", output.axes[k].position},
                    {"shown", steps.back().value[k]}});
    if (terms == WordTerms::all) axes.back()["terms"] = terms_of(steps, shown, k);
  }
  return {{"channel", channel},
          {"situation", situation.number},
          {"scheme", output.scheme},
          {"units", situation.meaning.inches() ? "inch" : "mm"},
          {"diameter", diameters_of(own, situation.meaning)},
          {"position", position_of(own, output, situation.meaning)},
          {"point_W", point_of(own, output)},
          {"axes", std::move(axes)}};
}

}  // namespace stanok::daemon
