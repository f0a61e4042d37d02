#include "ui/controller/payload_file.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/exporters/flange.h"

namespace heft {

Result<PayloadFile> payloadFile(const OpenRecording& opened, const EstimateReport& report, const ExportChoice& choice,
                                const std::vector<std::string>& cautions, bool confirmed) {
  const ExportFormat* format = findExportFormat(choice.format);
  if (!format) return Error{fmt::format("This Heft does not write the format \"{}\".", printable(choice.format))};
  const QFileInfo file(opened.path);
  FlangeOptions options;
  options.force = confirmed;
  options.name = file.completeBaseName().toStdString();
  options.program = "Heft Studio " + QCoreApplication::applicationVersion().toStdString();
  options.cautions = cautions;
  options.X_FE.translation() = choice.tcp;
  for (const MountedPart& part : choice.mounted) {
    if (!part.present) continue;
    options.add.push_back(part.payload);
    options.addNames.push_back(part.name);
  }
  auto payload = toFlange(toJson(report), file.fileName().toStdString(), options);
  if (!payload) return payload.error();
  PayloadFile out;
  out.onFlange = payload->input.payload;
  out.findings = std::move(payload->findings);
  auto text = exportPayload(*format, payload->input, out.findings);
  if (!text) return text.error();
  out.text = std::move(text).value();
  return out;
}

}  // namespace heft
