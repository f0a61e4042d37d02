#include "ui/controller/payload_file.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/exporters/flange.h"

namespace heft {

Result<std::string> payloadFile(const OpenRecording& opened, const EstimateReport& report, const ExportFormat& format,
                                Findings& findings) {
  const QFileInfo file(opened.path);
  FlangeOptions options;
  options.name = file.completeBaseName().toStdString();
  options.program = "Heft Studio " + QCoreApplication::applicationVersion().toStdString();
  auto payload = toFlange(toJson(report), file.fileName().toStdString(), options);
  if (!payload) return payload.error();
  findings.insert(findings.end(), payload->findings.begin(), payload->findings.end());
  return exportPayload(format, payload->input, findings);
}

}  // namespace heft
