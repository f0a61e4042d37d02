// heft: the command line. It parses, calls one subcommand and turns every way to fail into an exit code and a sentence.
#include <fmt/format.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <array>
#include <exception>
#include <new>

#include "app/cli/cli.h"
#include "app/version.h"
#include "core/base/text.h"

namespace {

using heft::cli::Command;

// CLI11 separates groups by two empty lines; and a subcommand does not know whose it is.
std::string helpText(const CLI::App& app, const CLI::App& root) {
  std::string text = app.help(&app == &root ? "" : "heft");
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// CLI11 says what is wrong in the words of a parser and offers no nearest match.
std::string explain(const CLI::ParseError& error, CLI::App& root, const CLI::App& at) {
  const std::string what = error.what();
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {  // "Could not convert: --trim = ten"
    const auto name = what.find("--"), value = what.find(" = ");
    if (name < value && value != std::string::npos)
      return fmt::format("{} expects a number with a decimal point, not '{}'.", what.substr(name, value - name),
                         heft::printable(what.substr(value + 3)));
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)  // "--output: 1 required FILE missing"
    return fmt::format("{} needs a value.", what.substr(0, what.find(':')));
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return what + ".";
  for (const auto& word : root.remaining(true)) {
    if (word.starts_with("-"))
      return fmt::format("There is no option {}.{}", heft::printable(word),
                         heft::cli::didYouMean(word.substr(0, word.find('=')), optionNames(at)));
  }
  const auto rest = root.remaining(true);
  return rest.empty() ? std::string(error.what())
                      : fmt::format("'{}' is one argument too many.", heft::printable(rest.front()));
}

int wrongUsage(const CLI::App& at, const CLI::App& root, const std::string& message) {
  const std::string name = &at == &root ? "heft" : "heft " + at.get_name();
  heft::cli::tell(fmt::format("{}: {}\nTry '{} --help'.\n", name, message, name));
  return heft::cli::kWrongUsage;
}

int runCommandLine(int argc, char** argv) {
  CLI::App root{
      "Heft estimates the mass, centre of mass and inertia of a robot's payload, from a recording of its motion\n"
      "and of the force/torque sensor, and writes the payload file that the controller reads."};
  root.name("heft");
  root.set_version_flag("--version", heft::versionText("heft"), "Print the version and end");
  root.set_help_flag("-h,--help", "Print this help and end");
  root.get_formatter()->column_width(34);
  root.footer(
      "Quick start:\n"
      "  heft simulate --motion excitation --seed 1 -o rec.csv      (or use your own recording)\n"
      "  heft estimate rec.csv --json result.json\n"
      "  heft export result.json --format franka-desk -o tool.json\n\n"
      "Exit codes: 0 success, 1 failure, 2 usage error. 'heft COMMAND --help' describes a command.");

  const std::array commands{heft::cli::makeEstimateCommand(root),    heft::cli::makeDiagnoseCommand(root),
                            heft::cli::makeSegmentCommand(root),     heft::cli::makeLiveCommand(root),
                            heft::cli::makeCoachCommand(root),       heft::cli::makeExciteCommand(root),
                            heft::cli::makeRoomCommand(root),        heft::cli::makeCompensateCommand(root),
                            heft::cli::makeProveCommand(root),       heft::cli::makePassportCommand(root),
                            heft::cli::makeSimulateCommand(root),    heft::cli::makeExportCommand(root),
                            heft::cli::makeExportModelCommand(root), heft::cli::makeConvertCommand(root),
                            heft::cli::makeReproduceCommand(root)};
  const auto names = [&] {
    std::vector<std::string> list;
    for (const Command& command : commands) list.push_back(command.app->get_name());
    return list;
  }();
  if (argc < 2) {
    heft::cli::tell(fmt::format("{}", helpText(root, root)));
    return heft::cli::kWrongUsage;
  }
  if (const std::string first = argv[1]; !first.starts_with("-") && std::ranges::find(names, first) == names.end()) {
    return wrongUsage(root, root,
                      fmt::format("There is no command '{}'.{} The commands are {}.", heft::printable(first),
                                  heft::cli::didYouMean(first, names), fmt::join(names, ", ")));
  }

  const CLI::App* at = &root;
  try {
    root.parse(argc, argv);
    for (const Command& command : commands) {
      if (!command.app->parsed()) continue;
      at = command.app;
      command.run();
      return heft::cli::kDone;
    }
    return wrongUsage(root, root, "A command is missing.");
  } catch (const CLI::CallForHelp&) {
    for (const Command& command : commands)
      if (command.app->parsed()) at = command.app;
    heft::cli::print(helpText(*at, root));
    return heft::cli::kDone;
  } catch (const CLI::CallForVersion& version) {
    heft::cli::print(fmt::format("{}\n", version.what()));
    return heft::cli::kDone;
  } catch (const CLI::Success&) {
    return heft::cli::kDone;  // A list was printed.
  } catch (const CLI::ParseError& error) {
    for (const Command& command : commands)
      if (command.app->parsed()) at = command.app;
    return wrongUsage(*at, root, explain(error, root, *at));
  } catch (const heft::cli::WrongUsage& error) {
    return wrongUsage(*at, root, error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  ::signal(SIGXFSZ, SIG_IGN);  // A file that may not grow is then an error like a full disk, and not the end.
  try {
    return runCommandLine(argc, argv);
  } catch (const heft::cli::Failed& error) {
    heft::cli::tell(fmt::format("heft: {}\n", error.what()));
  } catch (const std::bad_alloc&) {
    heft::cli::tell("heft: There is not enough memory for this; use a shorter recording or a lower rate.\n");
  } catch (const std::exception& error) {
    heft::cli::tell(
        fmt::format("heft: Something inside the program went wrong ({}); please report it.\n", error.what()));
  }
  return heft::cli::kFailed;
}
