#include "tests/ui/fixtures.h"

#include <cmath>

namespace heft::test {

Recording sineRecording(Eigen::Index rows, double rateHz) {
  Recording recording;
  recording.file = "sine.csv";
  recording.time.resize(rows);
  recording.wrench.resize(rows, 6);
  recording.position.setZero(rows, 3);
  recording.quaternion.setZero(rows, 4);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / rateHz;
    recording.time(i) = t;
    recording.wrench.row(i) << 10 * std::sin(2 * M_PI * t), 3.0, -5 + t, std::sin(2 * M_PI * t), 0.3, -0.5 + 0.1 * t;
    recording.position.row(i) << t, 2 * t, 0.5;
    recording.quaternion.row(i) << 0, 0, std::sin(t / 2), std::cos(t / 2);
  }
  return recording;
}

EstimateReport reportOn(const Recording& recording) {
  EstimateReport report;
  report.samples = recording.rows();
  report.duration = recording.duration();
  report.payload.mass = 0.812;
  report.payload.com = {0.0014, -0.0005, 0.0458};
  report.payload.inertiaCom = Vector3d(16.0e-4, 10.5e-4, 11.3e-4).asDiagonal();
  report.std.mass = 0.002;
  report.std.com = {0.0003, 0.0003, 0.0004};
  report.interval95.mass = {0.808, 0.816};
  for (int i = 0; i < 3; ++i) {
    report.interval95.com[i] = {report.payload.com(i) - 0.0006, report.payload.com(i) + 0.0006};
    for (int j = 0; j < 3; ++j) {
      report.interval95.inertiaCom[i][j] = {report.payload.inertiaCom(i, j) - 1.3e-4,
                                            report.payload.inertiaCom(i, j) + 1.3e-4};
      report.identifiability.inertia[i][j] = Source::data;
    }
    report.identifiability.com[i] = Source::data;
  }
  report.identifiability.mass = Source::data;
  report.physicallyConsistent = true;
  report.noiseStd << 0.05, 0.05, 0.05, 0.002, 0.002, 0.002;
  const double d = recording.duration();
  report.segments = {{0, 0.4 * d, MarkLabel::free, "nothing touched"},
                     {0.4 * d, 0.5 * d, MarkLabel::contact, "a push that the motion does not explain"},
                     {0.5 * d, d, MarkLabel::free, "nothing touched"}};
  report.series.time = recording.time;
  report.series.measured = recording.wrench;
  report.series.simulated = recording.wrench;
  report.series.simulated.col(0).array() -= 0.25;
  return report;
}

}  // namespace heft::test
