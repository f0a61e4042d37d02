// Weighs what a recording carries: consumer REC.csv prints the mass [kg], once by Heft's own fit and once by Ceres',
// which is loaded when it is asked for.
#include <cstdio>

#include "core/estimation/estimate.h"
#include "core/recording/csv_reader.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const auto read = heft::readRecording(argv[1]);
  if (!read) {
    std::fprintf(stderr, "%s\n", read.error().message.c_str());
    return 1;
  }
  for (const heft::Method method : {heft::Method::map, heft::Method::ceres}) {
    heft::EstimateOptions options;
    options.method = method;
    const auto report = heft::estimate(read->recording, &heft::RobotModel::panda(), options);
    if (!report || !report->termination.usable) {
      std::fprintf(stderr, "%s\n", report ? report->termination.why.c_str() : report.error().message.c_str());
      return 1;
    }
    std::printf("%.4f\n", report->payload.mass);
  }
  return 0;
}
