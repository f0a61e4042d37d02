// heft-studio: the desktop program. It parses, makes sure there is a screen (its own with --offscreen), and shows the
// window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSettings>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <optional>

#include "ui/controller/workspace.h"
#include "ui/main_window/main_window.h"
#include "ui/offscreen/private_display.h"
#include "ui/robot_view/graphics_setup.h"
#include "ui/theme/theme.h"
#include "ui/widgets/message_bar.h"

namespace {

constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

struct Options {
  std::string file;
  bool offscreen = false;
  std::string picture;
  int width = 1440, height = 900;
  std::string theme;
  std::optional<double> time;
  bool details = false;
};

/// "1440x900"; empty if it is no size.
std::optional<std::pair<int, int>> parseSize(const std::string& text) {
  const QStringList parts = QString::fromStdString(text).split('x');
  if (parts.size() != 2) return std::nullopt;
  bool first = false, second = false;
  const int width = parts[0].toInt(&first), height = parts[1].toInt(&second);
  if (!first || !second || width < 640 || height < 400 || width > 7680 || height > 4320) return std::nullopt;
  return std::pair(width, height);
}

int complain(int code, const std::string& sentence) {
  fmt::print(stderr, "heft-studio: {}\n", sentence);
  return code;
}

heft::ThemeKind themeFor(const Options& options) {
  if (options.theme == "dark") return heft::ThemeKind::dark;
  if (options.theme == "light" || options.offscreen) return heft::ThemeKind::light;
  return QSettings().value("window/theme").toString() == "dark" ? heft::ThemeKind::dark : heft::ThemeKind::light;
}

/// Opens, estimates, renders, saves; then ends the event loop with the exit code.
int takePicture(QApplication& application, heft::Workspace& workspace, heft::MainWindow& window,
                const Options& options) {
  int code = kDone;
  std::optional<std::string> failure;
  QObject::connect(&workspace, &heft::Workspace::failed, &window,
                   [&](const QString& sentence) { failure = sentence.toStdString(); });
  QTimer poll;
  QObject::connect(&poll, &QTimer::timeout, &window, [&] {
    if (!window.settled()) return;
    poll.stop();
    if (!workspace.opened()) {
      code = complain(kFailed, failure.value_or("The recording could not be opened."));
      return application.exit(code);
    }
    if (options.time) window.playback()->setTime(*options.time);
    // One turn of the event loop lays out what the result changed; then the plots have drawn themselves smoothly, too.
    QTimer::singleShot(300, &window, [&] {
      const QImage picture = window.picture();
      if (!picture.save(QString::fromStdString(options.picture))) {
        code = complain(kFailed,
                        fmt::format("{} could not be written: check that the folder exists, may be written to, and "
                                    "that the name ends in .png.",
                                    options.picture));
      } else if (failure) {
        // The window shows it, too; a script must learn it all the same.
        code = complain(kFailed, *failure);
      }
      application.exit(code);
    });
  });
  poll.start(20);
  return QApplication::exec();
}

int run(int argc, char** argv, const Options& options) {
  std::unique_ptr<heft::PrivateDisplay> display;
  if (options.offscreen) {
    auto started = heft::PrivateDisplay::start(options.width, options.height);
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
  QApplication::setApplicationVersion(HEFT_VERSION);
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QApplication application(argc, argv);
  // Qt takes the user's locale over; numbers in files must not follow it.
  std::setlocale(LC_NUMERIC, "C");
  // The texts are English so far; numbers follow them.
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  heft::applyTheme(application, themeFor(options));

  heft::Workspace workspace;
  heft::MainWindow window(&workspace, !options.offscreen);
  QObject::connect(&window, &heft::MainWindow::themeWanted, &application, [&](heft::ThemeKind kind) {
    heft::applyTheme(application, kind);
    if (!options.offscreen) QSettings().setValue("window/theme", kind == heft::ThemeKind::dark ? "dark" : "light");
  });
  if (options.offscreen) {
    window.setWindowFlag(Qt::FramelessWindowHint);
    window.setGeometry(0, 0, options.width, options.height);
  }
  if (options.details) window.showDetails(true);
  window.show();
  if (!options.file.empty()) workspace.open(QString::fromLocal8Bit(options.file.c_str()));
  if (options.offscreen) return takePicture(application, workspace, window, options);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  std::string size;
  CLI::App app{"Heft Studio shows a recording of a robot arm and its tool, and what the tool weighs."};
  app.name("heft-studio");
  app.set_version_flag("--version", "heft-studio " HEFT_VERSION, "Print the version and end");
  app.set_help_flag("-h,--help", "Print this help and end");
  app.add_option("FILE", options.file, "Recording (CSV, with NAME.meta.json beside it) to open");
  app.add_flag("--offscreen", options.offscreen, "Draw the window without a screen and save it as a picture");
  auto* picture = app.add_option("-o,--output", options.picture, "Picture to write with --offscreen (.png)");
  auto* sizeOption = app.add_option("--size", size, "Size of the window with --offscreen, for instance 1440x900");
  app.add_option("--theme", options.theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
  auto* time = app.add_option("--time", options.time, "Instant to show with --offscreen [s]");
  app.add_flag("--details", options.details, "Show the engineer's details, too");
  app.footer(
      "Without a screen:\n"
      "  heft-studio --offscreen rec.csv -o picture.png\n\n"
      "Exit codes: 0 done, 1 could not be done, 2 wrong usage.");
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
  if (options.offscreen && (options.file.empty() || options.picture.empty())) {
    return complain(kWrongUsage, "--offscreen needs a recording and -o PICTURE.png.\nTry 'heft-studio --help'.");
  }
  if (!options.offscreen && (*picture || *sizeOption || *time)) {
    return complain(kWrongUsage, "-o, --size and --time go with --offscreen.\nTry 'heft-studio --help'.");
  }
  if (*sizeOption) {
    const auto parsed = parseSize(size);
    if (!parsed) {
      return complain(kWrongUsage,
                      fmt::format("--size expects WIDTHxHEIGHT between 640x400 and 7680x4320, not '{}'.", size));
    }
    std::tie(options.width, options.height) = *parsed;
  }
  try {
    return run(argc, argv, options);
  } catch (const std::exception& error) {
    return complain(kFailed,
                    fmt::format("Something inside the program went wrong ({}); please report it.", error.what()));
  }
}
