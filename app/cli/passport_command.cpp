// heft passport: one page of a tool's numbers, with what speaks for them and what has changed.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/cli/cli.h"
#include "core/base/json_file.h"
#include "core/base/text.h"
#include "core/compensation/passport.h"
#include "core/compensation/passport_page.h"
#include "core/diagnosis/wording/unseen.h"
#include "core/twin/found.h"

namespace heft::cli {
namespace {

using nlohmann::json;

constexpr double kSameNumbers = 1e-6;  // Relative: what a file's rounding leaves

struct PassportArguments {
  std::string result, tool, date, causes, proof, since, json, page;
  bool force = false;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  return fmt::format("{:%Y-%m-%d}", local);
}

std::string fileName(const json& object) {
  const auto found = object.find("file");
  return found != object.end() && found->is_string()
             ? std::filesystem::path(found->get<std::string>()).filename().string()
             : std::string();
}

/// The payloads are the same but for rounding.
bool sameNumbers(const json& one, const json& other) {
  const auto a = payloadFromJson(one, "one"), b = payloadFromJson(other, "other");
  return a && b && toParameters(*a).isApprox(toParameters(*b), kSameNumbers);
}

/// Adds what a heft.diagnose/1 says about the numbers in `result`.
void addCauses(const PassportArguments& options, const json& result, PassportContent& content) {
  const json found = orFail(readJsonFile(options.causes));
  if (const auto error = whatIsMissing(found, options.causes, {})) throw Failed(error->message);
  const std::string of = fileName(result.value("recording", json::object())), with = fileName(found);
  if (of != with)
    throw Failed(fmt::format("{} is a diagnosis of the recording {}, but the result is of {}: diagnose that one.",
                             options.causes, printable(with), printable(of)));
  content.lookedForCauses = true;
  const bool applied = sameNumbers(found.at("payload_after"), result.at("payload"));
  for (const json& cause : found.at("causes"))
    content.causes.push_back({cause.at("cause").get<std::string>(), printable(cause.value("text", ""), 400), applied});
  std::vector<Smallest> smallest;
  for (const json& each : found.value("smallest_visible", json::array()))
    if (each.is_object() && each.value("value", json()).is_number())
      smallest.push_back({each.value("cause", ""), each.value("parameter", ""), printable(each.value("unit", "")),
                          each["value"].get<double>()});
  constexpr int kMostUnseen = 6;  // One line of the page
  content.notSeen = couldNotBeSeen(smallest, kMostUnseen);
}

void addProof(const PassportArguments& options, const json& result, PassportContent& content) {
  content.proof = orFail(readJsonFile(options.proof));
  const Payload now = orFail(payloadFromJson(result, options.result));
  const auto text = proofText(content.proof, &now);
  if (!text)
    throw Failed(
        fmt::format("{} is not a proof; make one with heft prove {} REC --json FILE.", options.proof, options.result));
  if (text->outdated)
    throw Failed(fmt::format("{} proves other numbers than those in {}; prove these: heft prove {} REC --json FILE.",
                             options.proof, options.result, options.result));
}

void makePassport(PassportArguments options) {
  if (options.date.empty()) options.date = today();
  if (!std::regex_match(options.date, std::regex(R"(\d{4}-(0[1-9]|1[0-2])-(0[1-9]|[12]\d|3[01]))")))
    throw WrongUsage(fmt::format("--date expects a day such as 2026-11-29, not '{}'.", printable(options.date)));
  if (!options.json.empty()) requireWritable(options.json, {options.force, {}});
  if (!options.page.empty()) requireWritable(options.page, {options.force, {}});
  const json result = orFail(readJsonFile(options.result));
  PassportContent content{printable(options.tool, 200), options.date, programVersion(), false, {}, {}, {}};
  orFail(passportOf(content, result, options.result));  // What is wrong with it comes first.
  if (!options.causes.empty()) addCauses(options, result, content);
  if (!options.proof.empty()) addProof(options, result, content);
  json passport = orFail(passportOf(content, result, options.result));
  if (!options.since.empty())
    passport["since"] = toJson(orFail(changeSince(orFail(readJsonFile(options.since)), options.since, passport)));
  if (!options.json.empty()) writeOutput(options.json, fileText(passport), {options.force, {}});
  if (!options.page.empty()) writeOutput(options.page, passportPage(passport), {options.force, {}});
  if (options.json != "-" && options.page != "-") print(passportText(passport));
}

}  // namespace

Command makePassportCommand(CLI::App& root) {
  auto options = std::make_shared<PassportArguments>();
  CLI::App* app =
      root.add_subcommand("passport", "Write a sheet of a tool's numbers, their proof and what has changed");
  app->add_option("RESULT", options->result, "The --json file of 'heft estimate', or --result of 'heft diagnose'")
      ->type_name("")
      ->required();
  app->add_option("--tool", options->tool, "Name of the tool; passports of the same name can be compared")
      ->type_name("NAME")
      ->required();
  app->add_option("--proof", options->proof, "The --json file of 'heft prove' for these numbers")->type_name("FILE");
  app->add_option("--causes", options->causes, "The --json file of 'heft diagnose' for the same recording")
      ->type_name("FILE");
  app->add_option("--since", options->since, "An earlier passport of the tool: say what has changed")
      ->type_name("FILE");
  app->add_option("--date", options->date, "Of the passport, such as 2026-11-29; otherwise today")->type_name("DAY");
  app->add_option("--json", options->json, "Write the passport as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--page", options->page, "Write the page as HTML; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_flag("--force", options->force, "Overwrite existing files");
  app->footer(
      "Examples:\n"
      "  heft passport result.json --tool \"Gripper 3\" --json gripper.json --page gripper.html\n"
      "  heft passport result.json --tool \"Gripper 3\" --proof proof.json --causes found.json --json gripper.json\n"
      "  heft passport result.json --tool \"Gripper 3\" --since gripper-october.json\n\n"
      "Heft Studio saves the same page as PDF; here it is HTML, which any browser prints. The exit code is 0\n"
      "whatever the passport says: a change beyond chance is reported in the text and in \"since\".");
  return {app, [options] { makePassport(*options); }};
}

}  // namespace heft::cli
