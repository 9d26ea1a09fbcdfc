// Parameters: every row of the table against values inside and outside of it.
#include <gtest/gtest.h>

#include "protocol/contract/json_rpc.h"
#include "protocol/contract/machine_request.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

json sound_value(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::integer:
      return static_cast<int>(parameter.minimum);
    case ParameterType::number:
      return (parameter.minimum + parameter.maximum) / 2.0;
    case ParameterType::text:
      return "part.nc";
    case ParameterType::choice:
      return parameter.choices.front();
    case ParameterType::text_list:
      return json::array({parameter.choices.front()});
  }
  return nullptr;
}

json sound_parameters(const Method& method) {
  json parameters = json::object();
  for (const Parameter& parameter : method.parameters) {
    parameters[std::string(parameter.name)] = sound_value(parameter);
  }
  return parameters;
}

class EveryMethod : public ::testing::TestWithParam<Method> {};

TEST_P(EveryMethod, TakesSoundParametersByNameAndByPosition) {
  const Method& method = GetParam();
  const json named = sound_parameters(method);
  const auto by_name = checked_parameters(method, named);
  ASSERT_TRUE(by_name) << by_name.error().message;
  EXPECT_EQ(*by_name, named);
  json list = json::array();
  for (const Parameter& parameter : method.parameters) list.push_back(sound_value(parameter));
  const auto by_position = checked_parameters(method, list);
  ASSERT_TRUE(by_position) << by_position.error().message;
  EXPECT_EQ(*by_position, named);
  list.push_back(1);
  EXPECT_FALSE(checked_parameters(method, list)) << "one too many";
}

TEST_P(EveryMethod, RefusesUnknownParameters) {
  json parameters = sound_parameters(GetParam());
  parameters["chanel"] = 1;
  const auto checked = checked_parameters(GetParam(), parameters);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().kind, FailureKind::invalid_parameters);
  EXPECT_NE(checked.error().message.find("chanel"), std::string::npos);
}

TEST_P(EveryMethod, MissesRequiredParametersAndNoOthers) {
  for (const Parameter& parameter : GetParam().parameters) {
    json parameters = sound_parameters(GetParam());
    parameters.erase(std::string(parameter.name));
    EXPECT_EQ(checked_parameters(GetParam(), parameters).has_value(),
              parameter.presence == Presence::optional)
        << parameter.name;
  }
}

TEST_P(EveryMethod, RefusesValuesOfAnotherTypeOrBeyondTheRange) {
  for (const Parameter& parameter : GetParam().parameters) {
    const bool is_claim = parameter.type == ParameterType::integer && parameter.minimum == 0.0 &&
                          parameter.maximum == 1.0;
    std::vector<json> wrong = {nullptr, json::object()};
    if (!is_claim) wrong.emplace_back(true);
    if (parameter.type == ParameterType::integer) wrong.push_back(1.5);
    if (parameter.type == ParameterType::integer || parameter.type == ParameterType::number) {
      wrong.insert(wrong.end(), {"1", parameter.minimum - 1.0, parameter.maximum + 1.0});
    }
    if (parameter.type == ParameterType::text) {
      const auto too_long = static_cast<std::size_t>(parameter.maximum) + 1;
      wrong.insert(wrong.end(), {1, "", std::string(too_long, 'a')});
      if (parameter.spelling != Spelling::file)
        wrong.insert(wrong.end(), {"a\nb", std::string("a\0b", 3)});
    }
    if (parameter.type == ParameterType::choice) wrong.insert(wrong.end(), {1, "neither"});
    if (parameter.type == ParameterType::text_list) {
      wrong.insert(wrong.end(), {"machine", json::array({"neither"}), json::array({1})});
    }
    for (const json& value : wrong) {
      json parameters = sound_parameters(GetParam());
      parameters[std::string(parameter.name)] = value;
      EXPECT_FALSE(checked_parameters(GetParam(), parameters)) << parameter.name << " = " << value;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod,
                         ::testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(Parameters, OfClaimsMayBeFalseOrTrue) {
  const Method& method = *find_method("tool.touch");
  json parameters = sound_parameters(method);
  for (const bool claim : {false, true}) {
    parameters["confirmed"] = claim;
    const auto checked = checked_parameters(method, parameters);
    ASSERT_TRUE(checked);
    EXPECT_EQ((*checked)["confirmed"], json(claim ? 1 : 0));
    EXPECT_TRUE((*checked)["confirmed"].is_number());
  }
}

TEST(MachineRequest, TurnsPercentIntoAFactor) {
  const auto request =
      machine_request(*find_method("override.feed"), {{"percent", 80}, {"channel", 2}});
  EXPECT_EQ(request.action, "override_feed");
  EXPECT_DOUBLE_EQ(request.value, 0.8);
  EXPECT_EQ(request.channel, 2);
}

TEST(MachineRequest, CarriesProgramAndScheme) {
  EXPECT_EQ(machine_request(*find_method("program.run"), {{"program", "a.nc"}}).text, "a.nc");
  EXPECT_EQ(machine_request(*find_method("program.run"), {{"program", "a.nc"}}).channel, 0);
  EXPECT_EQ(machine_request(*find_method("kinematics.select"), {{"scheme", 2}}).number, 2);
}

}  // namespace
}  // namespace stanok::protocol
