#include "protocol/contract/discovery.h"

#include <nlohmann/json.hpp>

#include "protocol/contract/json_text.h"
#include "protocol/contract/method_table.h"
#include "protocol/contract/result_shapes.h"

namespace stanok::protocol {
namespace {

using nlohmann::json;

json choices_json(const Parameter& parameter) {
  json choices = json::array();
  for (const std::string_view choice : parameter.choices) choices.push_back(choice);
  return choices;
}

// JSON Schema of the values that checked_parameters accepts.
json schema(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::integer:
    case ParameterType::number:
      return {{"type", type_name(parameter.type)},
              {"minimum", parameter.minimum},
              {"maximum", parameter.maximum}};
    case ParameterType::text:
      return {
          {"type", "string"}, {"minLength", parameter.minimum}, {"maxLength", parameter.maximum}};
    case ParameterType::choice:
      return {{"type", "string"}, {"enum", choices_json(parameter)}};
    case ParameterType::text_list:
      return {{"type", "array"},
              {"items", {{"type", "string"}, {"enum", choices_json(parameter)}}}};
  }
  return json::object();
}

json parameter_json(const Parameter& parameter) {
  json document = {{"name", parameter.name},
                   {"description", parameter.help},
                   {"required", parameter.presence == Presence::required},
                   {"schema", schema(parameter)}};
  if (!parameter.unit.empty()) document["x-unit"] = parameter.unit;
  return document;
}

json method_json(const Method& method) {
  json parameters = json::array();
  for (const Parameter& parameter : method.parameters)
    parameters.push_back(parameter_json(parameter));
  return {{"name", method.name},
          {"summary", method.help},
          {"params", std::move(parameters)},
          {"result", {{"name", "result"}, {"schema", result_schema(method)}}},
          {"x-role", role_name(method.role)},
          {"x-effect", effect_name(method.effect)}};
}

std::string range_text(const Parameter& parameter) {
  const std::string unit = parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
  switch (parameter.type) {
    case ParameterType::integer:
    case ParameterType::number: {
      std::string low = json_text(json(parameter.minimum));
      std::string high = json_text(json(parameter.maximum));
      if (low.ends_with(".0")) low.resize(low.size() - 2);
      if (high.ends_with(".0")) high.resize(high.size() - 2);
      return std::string(type_name(parameter.type)) + " " + low + "–" + high + unit;
    }
    case ParameterType::text:
      return "string";
    case ParameterType::choice:
    case ParameterType::text_list: {
      std::string text = parameter.type == ParameterType::choice ? "" : "list of ";
      for (const std::string_view choice : parameter.choices) {
        text +=
            (choice == parameter.choices.front() ? "" : ", ") + ("`" + std::string(choice) + "`");
      }
      return text;
    }
  }
  return "";
}

std::string parameters_text(const Method& method) {
  std::string text;
  for (const Parameter& parameter : method.parameters) {
    if (!text.empty()) text += "; ";
    text += "`" + std::string(parameter.name) + "`" +
            (parameter.presence == Presence::required ? "" : " (optional)") + ": " +
            range_text(parameter);
  }
  return text;
}

}  // namespace

json discovery_document(std::string_view version) {
  json document = {
      {"openrpc", "1.2.6"},
      {"info",
       {{"title", "stanok operator protocol"}, {"version", version}, {"x-api", api_version}}},
      {"methods", json::array()}};
  for (const Method& method : methods()) document["methods"].push_back(method_json(method));
  return document;
}

std::string methods_markdown() {
  std::string text = "| method | role | what it does | parameters |\n|---|---|---|---|\n";
  for (const Method& method : methods()) {
    text += "| `" + std::string(method.name) + "` | " + std::string(role_name(method.role)) +
            " | " + std::string(method.help) + " | " + parameters_text(method) + " |\n";
  }
  return text;
}

}  // namespace stanok::protocol
