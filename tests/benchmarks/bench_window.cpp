// The whole window under software rendering, on a private X server:
//   bench_window frames [MINUTES]    a recording of ten minutes at 1 kHz, opened as a user opens it: what one frame of
//                                    zooming, panning and playing takes with plots, marks and the 3D view together
//   bench_window playing [MINUTES]   pictures a second of the plots' cursor and of the 3D view while a recording plays,
//   a
//                                    short one and one of ten minutes, in one run
//   bench_window start PROGRAM       from the start of heft-studio until its window, and its arm, stand on the screen
//   bench_window live [MINUTES]      a robot that sends 1 kHz over UDP: once a minute what came, what was drawn, how
//   long
//                                    the window was deaf at most, and the memory held
//   bench_window knobs [SECONDS]     a step of each slider of "What if" with all that follows it, drawn
#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QLineEdit>
#include <QLocale>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <clocale>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <set>
#include <thread>

#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "core/simulation/virtual_rig.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/main_window.h"
#include "ui/offscreen/private_display.h"
#include "ui/record_panel/record_panel.h"
#include "ui/record_panel/source_form.h"
#include "ui/robot_view/graphics_setup.h"
#include "ui/robot_view/robot_view.h"
#include "ui/robot_view/viewport.h"
#include "ui/theme/theme.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/time_cursor.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

constexpr QSize kWindow(1440, 900);

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Knows how long the window was busy with one event, that is deaf to the user.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_ > 0) return QApplication::notify(receiver, event);
    ++depth_;
    const char* name = receiver->metaObject()->className();  // It may be gone afterwards.
    const auto type = static_cast<int>(event->type());
    QElapsedTimer clock;
    clock.start();
    const double before = threadSeconds();
    const bool done = QApplication::notify(receiver, event);
    --depth_;
    const double milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    longest = std::max(longest, milliseconds);
    if (milliseconds > 30.0) {
      ++over30;
      if (slow.size() < 20)
        slow.push_back(fmt::format("{} event {}: {:.0f} ms, {:.0f} of the processor's", name, type, milliseconds,
                                   1e3 * (threadSeconds() - before)));
    }
    return done;
  }
  double longest = 0.0;  ///< [ms]
  int over30 = 0;
  std::vector<std::string> slow;  ///< Which events those were, the first ones

 private:
  int depth_ = 0;
};

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double machineLoad() {
  std::ifstream file("/proc/loadavg");
  double load = 0;
  file >> load;
  return load;
}

void turnUntil(const std::function<bool()>& done) {
  while (!done()) QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
}

void turnFor(int milliseconds) {
  QElapsedTimer clock;
  for (clock.start(); clock.elapsed() < milliseconds;) QApplication::processEvents(QEventLoop::AllEvents, 5);
}

/// `act` and everything that it causes, drawn: until two turns of the event loop in a row had nothing to do.
void measure(const char* what, int frames, const std::function<void(int)>& act) {
  std::vector<double> wall, processor;
  for (int k = 0; k < frames; ++k) {
    QElapsedTimer clock;
    clock.start();
    const double before = processorSeconds();
    act(k);
    QApplication::processEvents();
    QApplication::processEvents();
    wall.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
    processor.push_back(1000 * (processorSeconds() - before));
  }
  std::sort(wall.begin(), wall.end());
  std::sort(processor.begin(), processor.end());
  const auto share = [](const std::vector<double>& sorted, double part) {
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
  };
  fmt::print("{:34}  {:8.1f}  {:8.1f}  {:8.1f}  {:14.1f}\n", what, share(wall, 0.5), share(wall, 0.95), wall.back(),
             share(processor, 0.5));
  std::fflush(stdout);
}

/// A simulated recording of so many seconds at 1 kHz; false, with the reason said, where that failed.
bool writeLong(const std::string& file, double seconds) {
  Payload payload;
  payload.mass = 0.9;
  payload.com = {0.005, -0.01, 0.06};
  payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
  SimulateOptions options;
  options.duration = seconds;
  const auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) return fmt::print(stderr, "{}\n", simulated.error().message), false;
  if (auto written = writeRecording(simulated->recording, file); !written)
    return fmt::print(stderr, "{}\n", written.error().message), false;
  return true;
}

int knobs(double seconds) {
  const QTemporaryDir folder;
  const std::string file = folder.filePath("rec.csv").toStdString();
  if (!writeLong(file, seconds)) return 1;
  Workspace workspace;
  MainWindow window(&workspace, false);
  window.resize(kWindow);
  window.show();
  workspace.open(QString::fromStdString(file));
  turnUntil([&] { return window.settled(); });
  window.showStep(Step::realityCheck);
  (void)window.panel(Step::realityCheck)->obey({"whatif", "on"});
  turnUntil([&] { return window.settled(); });
  turnFor(500);
  fmt::print("{:34}  {:>8}  {:>8}  {:>8}  {:>14}\n", "wall time of a step, drawn [ms]", "median", "95 %", "longest",
             "processor, ms");
  for (auto* slider : window.panel(Step::realityCheck)->findChildren<QSlider*>()) {
    measure(slider->objectName().toUtf8().constData(), 40, [&](int k) { slider->setValue(2 + 2 * k); });
    slider->setValue(0);
  }
  return 0;
}

int frames(double minutes) {
  const QTemporaryDir folder;
  const std::string file = folder.filePath("long.csv").toStdString();
  if (!writeLong(file, 60 * minutes)) return 1;
  Workspace workspace;
  MainWindow window(&workspace, false);
  window.resize(kWindow);
  window.show();
  turnUntil([&] { return window.settled(); });
  auto& application = *static_cast<TimedApplication*>(QApplication::instance());
  application.longest = 0;
  application.over30 = 0;
  QElapsedTimer opening;
  opening.start();
  workspace.open(QString::fromStdString(file));
  turnUntil([&] { return window.settled(); });
  turnFor(500);
  if (!workspace.report()) return fmt::print(stderr, "no result\n"), 1;
  fmt::print(
      "{} samples opened and estimated in {:.1f} s; meanwhile the window was deaf for {:.0f} ms at most, {} times "
      "over 30 ms; {:.0f} MB; load of the machine {:.1f}\n\n",
      workspace.opened()->recording.rows(), static_cast<double>(opening.elapsed()) / 1000, application.longest,
      application.over30, residentMegabytes(), machineLoad());
  for (const Step step : kAllSteps) {
    if (step == Step::realityCheck) continue;  // Its search would go on beside what is measured below.
    window.showStep(step);
    turnFor(300);
  }
  fmt::print("{} times over 30 ms with each step but the reality check shown once{}", application.over30,
             application.slow.empty() ? "" : ":\n");
  for (const std::string& event : application.slow) fmt::print("  {}\n", event);
  fmt::print("\n{:34}  {:>8}  {:>8}  {:>8}  {:>14}\n", "wall time of a frame [ms]", "median", "95 %", "longest",
             "processor, ms");
  TimeAxis* axis = window.recordingPane()->timeAxis();
  const double end = axis->fullUpper();
  for (const Step step : {Step::result, Step::mark}) {
    window.showStep(step);
    turnFor(800);
    fmt::print("step {}\n", stepId(step));
    measure("zoom, nearly all", 100, [&](int k) { axis->show(0.0 + k % 7, end - 1.0); });
    measure("zoom in by steps", 100, [&](int k) {
      const double half = 0.5 * end * std::pow(0.9, k % 60);
      axis->show(0.5 * end - half, 0.5 * end + half);
    });
    measure("pan, a minute shown", 100, [&](int k) { axis->show(0.3 * end + k, 0.3 * end + k + 60); });
    measure("pan, a second shown", 100, [&](int k) { axis->show(0.3 * end + 0.01 * k, 0.3 * end + 0.01 * k + 1); });
    axis->show(0.0, end);
    turnFor(800);
    measure("time moves: cursor, arm, arrows", 100, [&](int k) { window.playback()->setTime(10 + 0.033 * k); });
    measure("pan while the arm moves", 100, [&](int k) {
      window.playback()->setTime(10 + 0.033 * k);
      axis->show(5 + 0.033 * k, 15 + 0.033 * k);
    });
    fmt::print("{:34}  {:>8}  {:>8}  {:>8}  {:14.1f}\n", "a 3D picture, in its own thread", "", "", "",
               window.robotView()->lastFrameMilliseconds());
    // What follows a moment after the last quick picture: the smooth one. The window must not feel it.
    application.longest = 0;
    for (int k = 0; k < 8; ++k) {
      window.playback()->setTime(20 + k);
      turnFor(600);
    }
    fmt::print("{:34}  {:>8}  {:>8}  {:8.1f}  {:14.1f}\n", "smooth 3D picture at rest", "", "", application.longest,
               window.robotView()->lastFrameMilliseconds());
  }
  fmt::print("load of the machine {:.1f}\n", machineLoad());
  return 0;
}

/// Counts what a widget draws.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QWidget* of) : QObject(of) { of->installEventFilter(this); }
  int paints = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++paints;
    return false;
  }
};

int playing(double minutes) {
  constexpr int kSeconds = 8;
  const QTemporaryDir folder;
  Workspace workspace;
  MainWindow window(&workspace, false);
  window.resize(kWindow);
  window.show();
  TimeCursor* cursor = nullptr;  // It has no meta-object of its own.
  for (auto* child : window.recordingPane()->findChildren<QWidget*>())
    if (auto* found = dynamic_cast<TimeCursor*>(child)) cursor = found;
  auto* viewport = window.robotView()->findChild<Viewport*>();
  if (!cursor || !viewport) return 1;
  PaintCounter plots(cursor);
  int pictures = 0;
  QObject::connect(viewport, &Viewport::rendered, viewport, [&] { ++pictures; });
  fmt::print("{:24}  {:>14}  {:>10}  {:>24}\n", "recording, step", "plots [1/s]", "3D [1/s]",
             "processor, ms a picture");
  for (const double length : {20.0, 60.0 * minutes}) {
    const std::string file = folder.filePath(QString::number(length) + ".csv").toStdString();
    if (!writeLong(file, length)) return 1;
    workspace.open(QString::fromStdString(file));
    turnUntil([&] { return window.settled(); });
    for (const Step step : {Step::result, Step::mark}) {
      window.showStep(step);
      turnFor(1500);
      window.playback()->setTime(2.0);
      window.playback()->setPlaying(true);
      turnFor(1000);
      plots.paints = pictures = 0;
      const double before = processorSeconds();
      QElapsedTimer clock;
      clock.start();
      QEventLoop loop;  // As the program runs, asleep between events
      QTimer::singleShot(1000 * kSeconds, &loop, &QEventLoop::quit);
      loop.exec();
      const double each = 1000.0 * (processorSeconds() - before) / std::max(1, pictures);
      const double seconds = 1e-3 * static_cast<double>(clock.elapsed());
      window.playback()->setPlaying(false);
      fmt::print("{:24}  {:14.1f}  {:10.1f}  {:24.1f}\n", fmt::format("{:.0f} s, {}", length, stepId(step)),
                 plots.paints / seconds, pictures / seconds, each);
      std::fflush(stdout);
    }
  }
  fmt::print("load of the machine {:.1f}\n", machineLoad());
  return 0;
}

/// Colours of every fourth pixel of the screen.
std::size_t coloursOnScreen() {
  const QImage image = QGuiApplication::primaryScreen()->grabWindow(0).toImage().convertToFormat(QImage::Format_RGB32);
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 4)
    for (int x = 0; x < image.width(); x += 4) colours.insert(image.pixel(x, y));
  return colours.size();
}

int start(const QString& program) {
  const QTemporaryDir home;
  for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
    qputenv(name, home.path().toLocal8Bit());
  fmt::print("start  window [s]  arm in 3D [s]  load of the machine\n");
  for (int round = 1; round <= 5; ++round) {
    turnUntil([] { return coloursOnScreen() < 5; });
    QProcess studio;
    QElapsedTimer clock;
    clock.start();
    studio.start(program, QStringList());
    double windowAt = 0.0, armAt = 0.0;
    while (armAt <= 0.0 && clock.elapsed() < 60000) {
      const std::size_t colours = coloursOnScreen();
      const double now = static_cast<double>(clock.elapsed()) / 1000;
      if (windowAt <= 0.0 && colours > 20) windowAt = now;
      if (colours > 600) armAt = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    fmt::print("{:5}  {:10.2f}  {:13.2f}  {:.1f}\n", round, windowAt, armAt, machineLoad());
    std::fflush(stdout);
    studio.terminate();
    studio.waitForFinished();
  }
  return 0;
}

/// A robot of its own: what it measures goes to 127.0.0.1, a datagram each sample, at the machine's clock.
class SendingRobot {
 public:
  explicit SendingRobot(std::uint16_t port)
      : thread_([this, port](const std::stop_token& stopping) { run(stopping, port); }) {}
  std::uint64_t sent() const { return sent_; }

 private:
  void run(const std::stop_token& stopping, std::uint16_t port) {
    VirtualRigOptions options;
    options.payload = practiceTool(1);
    options.mount = SensorMount{};  // Where a setup file without a place says it is
    auto rig = VirtualRig::create(RobotModel::panda(), options).value();
    rig.arm().wander();
    const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto next = std::chrono::steady_clock::now();
    std::string text;
    while (!stopping.stop_requested()) {
      const VirtualSample& s = rig.next();
      text = fmt::format(R"({{"time":{:.6f},"fx":{:.5f},"fy":{:.5f},"fz":{:.5f},"tx":{:.6f},"ty":{:.6f},"tz":{:.6f})",
                         s.time, s.wrench(0), s.wrench(1), s.wrench(2), s.wrench(3), s.wrench(4), s.wrench(5));
      for (int j = 0; j < 7; ++j) text += fmt::format(R"(,"q{}":{:.7f},"dq{}":{:.5f})", j + 1, s.q(j), j + 1, s.dq(j));
      text += '}';
      if (::sendto(socket, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to) > 0) ++sent_;
      next += std::chrono::milliseconds(1);
      std::this_thread::sleep_until(next);
    }
    ::close(socket);
  }

  std::atomic<std::uint64_t> sent_ = 0;
  std::jthread thread_;
};

int live(int minutes) {
  constexpr std::uint16_t kPort = 9871;
  const QTemporaryDir state;
  qputenv("XDG_STATE_HOME", state.path().toUtf8());
  Workspace workspace;
  MainWindow window(&workspace, false);
  window.resize(kWindow);
  window.show();
  turnUntil([&] { return window.settled(); });
  auto* panel = dynamic_cast<RecordPanel*>(window.panel(Step::record));
  panel->setWay(RecordPanel::Way::live);
  auto* form = panel->findChild<SourceForm*>();
  form->setKind(SourceForm::Kind::jsonUdp);
  form->findChildren<QLineEdit*>("sourceAddress").back()->setText(QString::number(kPort));
  form->findChildren<QPushButton*>("mountAtFlange").back()->click();
  panel->startListening();
  if (!panel->run()->running()) return fmt::print(stderr, "does not listen\n"), 1;
  const SendingRobot robot(kPort);
  auto& application = *static_cast<TimedApplication*>(QApplication::instance());
  int refreshes = 0;
  QObject::connect(panel->run(), &LiveRun::refreshed, [&] { ++refreshes; });
  fmt::print(
      "minute   sent  received  on disk  refreshes/s  longest deaf ms  over 30 ms  processor %  memory MB  load  kg\n");
  QElapsedTimer clock;
  clock.start();
  for (int minute = 1; minute <= minutes && panel->run()->running(); ++minute) {
    refreshes = 0;
    application.longest = 0;
    application.over30 = 0;
    const double before = processorSeconds();
    turnUntil([&] { return clock.elapsed() >= 60000LL * minute; });
    const auto status = panel->run()->status();
    fmt::print("{:6}  {:7}  {:7}  {:7}  {:11.1f}  {:15.0f}  {:10}  {:11.1f}  {:9.0f}  {:4.1f}  {:.4f}\n", minute,
               robot.sent(), status.samples, status.recorded, refreshes / 60.0, application.longest, application.over30,
               100 * (processorSeconds() - before) / 60, residentMegabytes(), machineLoad(),
               panel->run()->view().state.payload.mass);
    std::fflush(stdout);
  }
  const QString file = panel->run()->stop();
  const auto read = readRecording(file.toStdString());
  fmt::print("the recording holds {} samples; hidden mass {:.4f} kg\n", read ? read->recording.rows() : 0,
             practiceTool(1).mass);
  return 0;
}

}  // namespace
}  // namespace heft

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const double number = argc > 2 ? std::atof(argv[2]) : 0.0;
  const bool known = what == "frames" || what == "playing" || what == "start" || what == "live" || what == "knobs";
  if (!known || (what == "start" && argc < 3)) {
    fmt::print(
        stderr,
        "bench_window frames [MINUTES] | playing [MINUTES] | start PROGRAM | live [MINUTES] | knobs [SECONDS]\n");
    return 2;
  }
  auto display = heft::PrivateDisplay::start(heft::kWindow.width(), heft::kWindow.height());
  if (!display) return fmt::print(stderr, "{}\n", display.error().message), 1;
  QStandardPaths::setTestModeEnabled(true);
  heft::prepareGraphics();
  heft::TimedApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  heft::applyTheme(application, heft::ThemeKind::light);
  if (what == "frames") return heft::frames(number > 0 ? number : 10.0);
  if (what == "playing") return heft::playing(number > 0 ? number : 10.0);
  if (what == "knobs") return heft::knobs(number > 0 ? number : 20.0);
  if (what == "start") return heft::start(QString::fromLocal8Bit(argv[2]));
  return heft::live(number > 0 ? static_cast<int>(number) : 30);
}
