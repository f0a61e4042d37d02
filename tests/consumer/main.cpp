// Weighs what a recording carries: consumer REC.csv prints the mass [kg].
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
  const auto report = heft::estimate(read->recording, &heft::RobotModel::panda(), heft::EstimateOptions{});
  if (!report) {
    std::fprintf(stderr, "%s\n", report.error().message.c_str());
    return 1;
  }
  std::printf("%.4f\n", report->payload.mass);
  return 0;
}
