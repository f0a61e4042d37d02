#include "ui/record_panel/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Samples)
};

}  // namespace

std::vector<Sample> samples() {
  return {{QStringLiteral("sample-clean.csv"), Words::tr("A clean demonstration, 0.8 kg"), {}, 0.0},
          {QStringLiteral("sample-hose.csv"), Words::tr("A hose pulls at the tool"), QStringLiteral("cable_pull"), 2.5},
          {QStringLiteral("sample-delay.csv"), Words::tr("The force readings come late"), QStringLiteral("time_offset"),
           15.0}};
}

Result<QString> sampleFile(const Sample& sample, const Progress& progress) {
  const QDir folder(QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).absoluteFilePath("samples"));
  QString path = folder.filePath(sample.file);
  if (QFileInfo(path).size() > 0) return path;
  QDir().mkpath(folder.path());
  Payload tool;
  tool.mass = 0.8;
  tool.com = {0.005, -0.01, 0.06};
  tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
  SimulateOptions options;
  options.duration = 15.0;
  options.rateHz = 500.0;
  options.seed = 20;
  if (!sample.effect.isEmpty()) options.effects = {{sample.effect.toStdString(), "", sample.size}};
  progress(0.1, "");
  const auto made = simulate(RobotModel::panda(), tool, options);
  if (!made) return made.error();
  if (auto written = writeRecording(made->recording, path.toStdString()); !written) return written.error();
  return path;
}

}  // namespace heft
