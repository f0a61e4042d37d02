#include "app/cli/object_estimate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "core/estimation/carried_object.h"
#include "core/estimation/judgement.h"
#include "core/estimation/picked_up.h"

namespace heft::cli {

void estimateObject(const ObjectFiles& files, const ImportOptions& import, const EstimateOptions& given) {
  const bool one = files.without.empty();
  EstimateOptions settings = given;
  if (!one && (!import.metaFile.empty() || !import.join.empty()))
    throw WrongUsage("--meta and --join go with one recording; with --minus each has its own .meta.json beside it.");
  if (one && settings.segments) throw WrongUsage("--picked-up looks for the parts by itself; leave --segments away.");
  if (settings.method != Method::map || settings.parameters != ParameterSet::full)
    throw WrongUsage("--minus and --picked-up need the method map and the parameters full.");
  if (settings.shape || !settings.stated.empty())
    throw WrongUsage(
        "--shape, --mass and --cad describe one body; with --minus and --picked-up there are two: leave them away.");
  if (!settings.known.empty())
    throw WrongUsage("--known describes one body; with --minus and --picked-up there are two: leave it away.");
  const Overwrite overwrite{files.force, [](const std::string& old) { return hasSchema(old, "heft.estimate/1"); }};
  if (!files.json.empty()) requireWritable(files.json, overwrite);
  ProgressLine line;
  Input with = readInput(files.with, import, files.robot, line.progress());
  Input without;
  if (one) {
    without.robot = with.robot;
    without.findings = with.findings;
    PickedUp parts = orFail(partsWithAndWithout(with.recording, with.model(), settings, line.progress()));
    if (!parts.pickedUpAt.empty())
      with.findings.push_back({Severity::info,
                               "picked_up",
                               fmt::format("Picked up at {:.1f} s.", fmt::join(parts.pickedUpAt, ", ")),
                               {},
                               {}});
    if (!parts.putDownAt.empty())
      with.findings.push_back(
          {Severity::info, "put_down", fmt::format("Put down at {:.1f} s.", fmt::join(parts.putDownAt, ", ")), {}, {}});
    with.recording = std::move(parts.with);
    without.recording = std::move(parts.without);
    settings.segments = SegmentMode::automatic;
  } else {
    without = readInput(files.without, import, files.robot, line.progress());
  }
  CarriedObject carried =
      orFail(estimateCarriedObject({&with.recording, with.model()}, {&without.recording, without.model()}, settings,
                                   {with.findings, without.findings}, line.progress()));
  line.clear();
  if (!files.json.empty()) writeOutput(files.json, fileText(toJson(carried)), overwrite);
  if (files.json != "-") print(toText(carried));
}

}  // namespace heft::cli
