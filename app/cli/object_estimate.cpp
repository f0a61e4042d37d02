#include "app/cli/object_estimate.h"

#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "core/estimation/judgement.h"
#include "core/estimation/picked_up.h"

namespace heft::cli {

void estimateObject(const ObjectFiles& files, const ImportOptions& import, const EstimateOptions& settings) {
  const bool one = files.without.empty();
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
  const Overwrite overwrite = ownResult(files.force, "heft.estimate/1");
  if (!files.json.empty()) requireWritable(files.json, overwrite);
  ProgressLine line;
  const Input with = readInput(files.with, import, files.robot, line.progress());
  const CarriedObject carried = [&] {
    if (one) return orFail(estimatePickedUp({&with.recording, with.model()}, settings, with.findings, line.progress()));
    const Input without = readInput(files.without, import, files.robot, line.progress());
    return orFail(estimateCarriedObject({&with.recording, with.model()}, {&without.recording, without.model()},
                                        settings, {with.findings, without.findings}, line.progress()));
  }();
  line.clear();
  if (!files.json.empty()) writeResult(files.json, toJson(carried), overwrite);
  if (files.json != "-") print(toText(carried));
}

}  // namespace heft::cli
