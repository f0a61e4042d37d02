// heft-studio: the desktop program. It parses, makes sure there is a screen (its own with --offscreen), and shows the
// window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSettings>
#include <QSocketNotifier>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <optional>

#include <unistd.h>

#include "app/version.h"
#include "core/base/heap.h"
#include "core/base/json_file.h"
#include "ui/main_window/main_window.h"
#include "ui/offscreen/private_display.h"
#include "ui/robot_view/graphics_setup.h"
#include "ui/studio/script_runner.h"
#include "ui/studio/studio.h"

namespace {

constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

struct Options {
  std::string file;
  bool offscreen = false;
  std::string picture;
  std::string script;
  QSize size{1440, 900};
  std::string theme, language;
  std::optional<double> time;
  bool details = false;
};

int complain(int code, const std::string& sentence) {
  fmt::print(stderr, "heft-studio: {}\n", sentence);
  return code;
}

/// The lines of --script, or those that FILE and -o stand for.
heft::Result<std::vector<heft::ScriptLine>> scriptOf(const Options& options) {
  if (!options.script.empty()) {
    const auto text = heft::readTextFile(options.script);
    if (!text) return text.error();
    return heft::parseScript(*text, options.script);
  }
  std::vector<heft::ScriptLine> lines{{1, {"open", QString::fromLocal8Bit(options.file.c_str())}}};
  if (options.details) lines.push_back({1, {"details", "on"}});
  if (options.time) lines.push_back({1, {"time", QString::number(*options.time, 'g', 17)}});
  lines.push_back({1, {"picture", QString::fromLocal8Bit(options.picture.c_str())}});
  return lines;
}

/// A signal writes a byte, and the window ends in its own time: nothing else is safe in a signal.
int endingPipe[2] = {-1, -1};
void askToEnd(int) {
  const char byte = 1;
  [[maybe_unused]] const auto written = ::write(endingPipe[1], &byte, 1);
}

void endWhenAsked(QApplication& application, heft::Studio& studio) {
  if (::pipe(endingPipe) != 0) return;
  auto* ending = new QSocketNotifier(endingPipe[0], QSocketNotifier::Read, &application);
  QObject::connect(ending, &QSocketNotifier::activated, &application, [&studio, ending] {
    ending->setEnabled(false);
    studio.endBySystem();
  });
  for (const int signal : {SIGTERM, SIGHUP, SIGINT}) std::signal(signal, askToEnd);
}

int run(int argc, char** argv, const Options& options) {
  std::unique_ptr<heft::PrivateDisplay> display;
  std::vector<heft::ScriptLine> lines;
  if (options.offscreen) {
    auto script = scriptOf(options);
    if (!script) return complain(kFailed, script.error().message);
    lines = std::move(script).value();
    const QSize screen = heft::screenFor(lines, options.size);
    auto started = heft::PrivateDisplay::start(screen.width(), screen.height());
    if (!started) return complain(kFailed, started.error().message);
    display = std::move(started).value();
  } else if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
    const auto answers = heft::displayAnswers();
    if (!answers) return complain(kFailed, answers.error().message);
    // VTK draws through GLX: under Wayland the window has to be an X11 one.
    qputenv("QT_QPA_PLATFORM", "xcb");
  }

  if (options.offscreen) {
    // For scripts stderr holds our sentences only, not what Qt thinks of the environment.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
      if (type == QtCriticalMsg || type == QtFatalMsg) fmt::print(stderr, "{}\n", text.toStdString());
    });
  }
  heft::prepareGraphics();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setOrganizationName("heft");
  QApplication::setApplicationName("heft-studio");
  QApplication::setApplicationVersion(QString::fromUtf8(heft::version().data()));
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QApplication application(argc, argv);
  // Qt takes the user's locale over; numbers in files must not follow it.
  std::setlocale(LC_NUMERIC, "C");
  heft::StudioOptions studioOptions;
  studioOptions.offscreen = options.offscreen;
  studioOptions.size = options.size;
  studioOptions.theme = QString::fromStdString(options.theme);
  studioOptions.language = QString::fromStdString(options.language);
  heft::Studio studio(application, studioOptions);
  studio.show();
  if (!options.offscreen) {
    endWhenAsked(application, studio);
    if (options.details) studio.window().showDetails(true);
    if (!options.file.empty()) studio.workspace().open(QString::fromLocal8Bit(options.file.c_str()));
    return QApplication::exec();
  }
  int code = kDone;
  heft::ScriptRunner runner(&studio, std::move(lines), options.script);
  QObject::connect(&runner, &heft::ScriptRunner::finished, &application, [&](const QString& failure) {
    if (!failure.isEmpty()) code = complain(kFailed, failure.toStdString());
    application.exit(code);
  });
  // The window shows what failed: the picture is worth having, and the exit code reports the failure anyway.
  runner.start(options.script.empty());
  return QApplication::exec();
}

int parseAndRun(int argc, char** argv) {
  Options options;
  std::string size;
  CLI::App app{"Heft Studio shows a recording of a robot arm and its tool, and what the tool weighs."};
  app.name("heft-studio");
  app.set_version_flag("--version", heft::versionText("heft-studio"), "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.add_option("FILE", options.file, "Recording (CSV, with NAME.meta.json beside it) to open");
  app.add_flag("--offscreen", options.offscreen, "Draw the window without a screen and save it as a picture");
  app.add_option("--script", options.script, "Commands to carry out with --offscreen, one a line; see below");
  app.add_option("--language", options.language, "en or de")->check(CLI::IsMember({"en", "de"}));
  auto* picture = app.add_option("-o,--output", options.picture, "Picture to write with --offscreen (.png)");
  auto* sizeOption = app.add_option("--size", size, "Size of the window with --offscreen, for instance 1440x900");
  app.add_option("--theme", options.theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
  auto* time = app.add_option("--time", options.time, "Instant to show with --offscreen [s]");
  app.add_flag("--details", options.details, "Show the engineer's details, too");
  app.footer(
      "Without a screen:\n"
      "  heft-studio --offscreen rec.csv -o picture.png\n"
      "  heft-studio --offscreen --script walk.txt\n\n"
      "Lines of a script:\n" +
      heft::scriptHelp(heft::ScriptRunner::forms()) +
      "\n"
      "Exit codes: 0 success, 1 failure, 2 usage error.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return kDone;
  } catch (const CLI::CallForVersion& version) {
    fmt::print("{}\n", version.what());
    return kDone;
  } catch (const CLI::ParseError& error) {
    return complain(kWrongUsage, fmt::format("{}\nTry 'heft-studio --help'.", error.what()));
  }
  if (options.offscreen && options.script.empty() && (options.file.empty() || options.picture.empty())) {
    return complain(kWrongUsage,
                    "--offscreen needs a recording and -o PICTURE.png, or --script FILE.\nTry 'heft-studio --help'.");
  }
  if (!options.script.empty() && (!options.file.empty() || *picture || *time)) {
    return complain(kWrongUsage, "--script says itself what to open and to save.\nTry 'heft-studio --help'.");
  }
  if (!options.offscreen && (*picture || *sizeOption || *time || !options.script.empty())) {
    return complain(kWrongUsage, "-o, --script, --size and --time go with --offscreen.\nTry 'heft-studio --help'.");
  }
  if (*sizeOption) {
    const auto parsed = heft::parseSize(QString::fromStdString(size));
    if (!parsed) {
      return complain(kWrongUsage,
                      fmt::format("--size expects WIDTHxHEIGHT between 640x400 and 7680x4320, not '{}'.", size));
    }
    options.size = *parsed;
  }
  return run(argc, argv, options);
}

}  // namespace

int main(int argc, char** argv) {
  heft::useTwoHeaps();
  try {
    return parseAndRun(argc, argv);
  } catch (const std::exception& error) {
    return complain(kFailed,
                    fmt::format("Something inside the program went wrong ({}); please report it.", error.what()));
  }
}
